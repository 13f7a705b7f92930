// Slow motion, measured on the frames themselves.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "scene/time/timeline.h"
#include "support/scene_text.h"

using namespace carom;

namespace {

Scene film(const std::string& film, const std::string& events = "") {
    return test::scene_from(
        "title: T\nbox: {size: [40, 30]}\ngas: [{count: 9, speed: 1}]\nrun: {until: 24, "
        "events: [" +
        events + "]}\nfilm: {" + film + "}\n");
}

/// Simulated time in a second of film, from each moving frame to the next.
struct Stride {
    double from, to;  // simulated
    double value;
};

std::vector<Stride> speeds(const Scene& scene) {
    std::vector<Stride> found;
    const std::vector<Tick> ticks = timeline(scene);
    for (std::size_t i = 1; i < ticks.size(); ++i) {
        const double before = ticks[i - 1].time, after = ticks[i].time;
        if (after > before) found.push_back({before, after, (after - before) * scene.film.fps});
    }
    return found;
}

}  // namespace

TEST_CASE("inside the span a film is slower by the factor, outside of it evenly fast") {
    for (const double factor : {0.1, 0.5, 0.02}) {
        const Scene scene =
            film("seconds: 30, slow: [{from: 8, to: 9, factor: " + std::to_string(factor) + "}]");
        double inside = 0.0, usual = 0.0;
        for (const Stride& speed : speeds(scene)) {
            if (speed.from >= 8.0 && speed.to <= 9.0) {
                if (inside == 0.0) inside = speed.value;
                CHECK(speed.value == doctest::Approx(inside).epsilon(1e-9));
            }
            if (speed.to < 6.0 || speed.from > 11.0) {
                if (usual == 0.0) usual = speed.value;
                CHECK(speed.value == doctest::Approx(usual).epsilon(1e-9));
            }
        }
        CHECK(inside / usual == doctest::Approx(factor).epsilon(1e-9));
    }
}

TEST_CASE("the speed changes smoothly, within half a second of film each time") {
    const Scene scene = film("seconds: 30, slow: [{from: 8, to: 9, factor: 0.1}]");
    const std::vector<Stride> all = speeds(scene);
    const double usual = all.front().value;
    std::vector<Stride> in, out;
    for (std::size_t i = 1; i < all.size(); ++i) {
        // The steepest slope of 3x^2 - 2x^3 is 1.5: over 15 frames a tenth of the change each.
        CHECK(std::abs(all[i].value - all[i - 1].value) <= 0.1001 * 0.9 * usual);
        const bool between = all[i].value < 0.9999 * usual && all[i].value > 0.1001 * usual;
        if (between) (all[i].to < 8.5 ? in : out).push_back(all[i]);
    }
    CHECK(in.size() >= 14);
    CHECK(in.size() <= 17);
    CHECK(out.size() >= 14);
    CHECK(out.size() <= 17);
    CHECK(std::ranges::is_sorted(
        in, [](const Stride& a, const Stride& b) { return a.value > b.value; }));
    CHECK(std::ranges::is_sorted(out, {}, &Stride::value));
    CHECK(in.front().value > 0.98 * usual);  // it begins gently
    CHECK(out.back().value > 0.98 * usual);
    // By the integral of the profile: half a second at the mean of both speeds.
    CHECK(in.front().from == doctest::Approx(8.0 - 0.5 * usual * 0.55).epsilon(0.01));
    CHECK(out.back().to == doctest::Approx(9.0 + 0.5 * usual * 0.55).epsilon(0.01));
}

TEST_CASE("times rise strictly, exact at the start, at reversals and at the end") {
    for (const char* slow : {"{from: 0, to: 1, factor: 0.1}", "{from: 23, to: 24, factor: 0.2}",
                             "{from: 11.5, to: 12.5, factor: 0.1}",
                             "{from: 2, to: 2.5, factor: 0.05}, {from: 6, to: 7, factor: 0.3}",
                             "{from: 0, to: 24, factor: 0.1}", "{from: 5, to: 6, factor: 1}"}) {
        CAPTURE(slow);
        const Scene scene =
            film("seconds: 40, slow: [" + std::string(slow) + "]", "{at: 12, reverse: velocities}");
        const std::vector<Tick> ticks = timeline(scene);
        CHECK(ticks.size() == 1200);
        CHECK(ticks.front().time == 0.0);
        CHECK(ticks.back().time == 24.0);
        CHECK(std::ranges::any_of(ticks, [](const Tick& tick) { return tick.time == 12.0; }));
        double last = -1.0;
        for (const Tick& tick : ticks) {
            if (tick.phase != Phase::moving) continue;
            CHECK(tick.time > last);
            last = tick.time;
        }
    }
}

TEST_CASE("where the spans are symmetric about a reversal, so are the frames") {
    const Scene scene = film(
        "seconds: 40, slow: [{from: 3, to: 4, factor: 0.1}, {from: 11.5, to: 12.5, factor: 0.4}, "
        "{from: 20, to: 21, factor: 0.1}]",
        "{at: 12, reverse: velocities}");
    std::vector<double> out, back;
    for (const Tick& tick : timeline(scene)) {
        if (tick.phase != Phase::moving) continue;
        if (tick.time <= 12.0) out.push_back(tick.time);
        if (tick.time >= 12.0) back.push_back(24.0 - tick.time);
    }
    REQUIRE(out.size() == back.size());
    for (std::size_t i = 0; i < out.size(); ++i)
        CHECK(std::abs(out[i] - back[out.size() - 1 - i]) < 1e-11);
}

TEST_CASE("with `seconds` the film keeps its length, with `pace` it grows") {
    const std::string slow = "slow: [{from: 8, to: 10, factor: 0.1}]";
    CHECK(film("seconds: 30, " + slow).film.seconds == 30.0);
    // 2 units at a tenth of 2 a second are 10 s instead of 1; half a second of easing covers
    // 0.55 units, which would take 0.275 s.
    CHECK(film("pace: 2").film.seconds == 12.0);
    CHECK(film("pace: 2, " + slow).film.seconds == doctest::Approx(12.0 + 9.0 + 2 * 0.225));
}

TEST_CASE("in a short film the easing is a tenth of it, so that a preview needs no other spans") {
    const std::string slow = "slow: [{from: 8, to: 10, factor: 0.25}]";
    for (const double seconds : {0.5, 1.0, 3.0, 4.9}) {
        CAPTURE(seconds);
        const Scene scene = film("seconds: " + std::to_string(seconds) + ", fps: 120, " + slow);
        double eased = 0.0, usual = 0.0;
        for (const Stride& stride : speeds(scene)) usual = std::max(usual, stride.value);
        for (const Stride& stride : speeds(scene))
            if (stride.value < 0.999 * usual && stride.value > 0.251 * usual) eased += 1.0 / 120.0;
        CHECK(eased < 0.2 * seconds + 3.0 / 120.0);
        CHECK(eased > 0.1 * seconds - 3.0 / 120.0);  // the gas moves in three quarters of it
    }
    // 22 units at 8 a second and 2 at a quarter of that are 3.75 s; the easing, a tenth of the film
    // each time, covers 0.625 of what it would at full speed.
    CHECK(film("pace: 8, " + slow).film.seconds == doctest::Approx(3.75 / (1.0 - 2 * 0.1 * 0.375)));
}

TEST_CASE("the factor is told while the film is slow, and eased in and out with it") {
    const Scene scene = film("seconds: 30, slow: [{from: 8, to: 9, factor: 0.1}]");
    for (const Tick& tick : timeline(scene)) {
        if (tick.time >= 8.0 && tick.time <= 9.0) CHECK(tick.slow.share == doctest::Approx(1.0));
        if (tick.time < 7.0 || tick.time > 10.0) CHECK(tick.slow.share == 0.0);
        CHECK(tick.slow.share >= 0.0);
        CHECK(tick.slow.share <= 1.0);
        if (tick.slow.share > 0.0) CHECK(tick.slow.factor == 0.1);
    }
}
