#include <doctest/doctest.h>

#include <cmath>

#include "scene/timeline.h"

using namespace carom;

namespace {

Scene film(double until, double seconds, int fps, std::vector<double> reversals = {}) {
    Scene scene;
    scene.run.until = until;
    scene.film.seconds = seconds;
    scene.film.fps = fps;
    for (double at : reversals) scene.run.events.push_back({at, ReverseVelocities{}});
    return scene;
}

}  // namespace

TEST_CASE("a film has round(seconds * fps) frames, first and last times included") {
    for (double seconds : {0.05, 0.5, 1.0, 7.77, 30.0})
        for (int fps : {24, 30, 60}) {
            const std::vector<Tick> ticks = timeline(film(60.0, seconds, fps));
            CHECK(ticks.size() == static_cast<std::size_t>(std::lround(seconds * fps)));
            CHECK(ticks.front().time == 0.0);
            if (ticks.size() > 1) CHECK(ticks.back().time == 60.0);
            for (std::size_t i = 1; i < ticks.size(); ++i)
                CHECK(ticks[i].time >= ticks[i - 1].time);
        }
}

TEST_CASE(
    "the first frame holds 1.5 s and the last 2 s; in short films all pauses are a quarter at "
    "most") {
    const std::vector<Tick> ticks = timeline(film(60.0, 30.0, 30));
    CHECK(ticks[45].time == 0.0);
    CHECK(ticks[46].time > 0.0);
    CHECK(ticks[900 - 61].time == 60.0);
    CHECK(ticks[900 - 62].time < 60.0);

    int moving = 0;
    for (const Tick& tick : timeline(film(10.0, 2.0, 30, {5.0})))
        if (tick.phase == Phase::moving) ++moving;
    CHECK(moving >= 45);
}

TEST_CASE("frames of the return leg mirror those of the way out") {
    for (double seconds : {4.0, 20.0, 29.97}) {
        const std::vector<Tick> ticks = timeline(film(30.0, seconds, 30, {15.0}));
        std::vector<double> out, back;
        for (const Tick& tick : ticks) {
            if (tick.phase != Phase::moving) continue;
            if (tick.time <= 15.0) out.push_back(tick.time);
            if (tick.time >= 15.0) back.push_back(30.0 - tick.time);
        }
        REQUIRE(out.size() == back.size());
        for (std::size_t i = 0; i < out.size(); ++i)
            CHECK(out[i] == doctest::Approx(back[out.size() - 1 - i]).epsilon(1e-14));
    }
}

TEST_CASE("a time axis folds at each reversal") {
    const Run run = film(30.0, 10.0, 30, {10.0, 25.0}).run;
    CHECK(folded_time(run, 4.0) == 4.0);
    CHECK(folded_time(run, 10.0) == 10.0);
    CHECK(folded_time(run, 12.0) == 8.0);
    CHECK(folded_time(run, 25.0) == -5.0);
    CHECK(folded_time(run, 27.0) == -3.0);
}

TEST_CASE("segments cover the film, are balanced, and depend on the scene alone") {
    CHECK(segment_starts(900, 200) == std::vector<int>{0, 112, 225, 337, 450, 562, 675, 787, 900});
    CHECK(segment_starts(10, 200) == std::vector<int>{0, 10});
    for (int frames : {1, 149, 151, 239, 240, 301, 5000}) {
        const std::vector<int> starts = segment_starts(frames, 1000);
        CHECK(starts.front() == 0);
        CHECK(starts.back() == frames);
        for (std::size_t i = 1; i < starts.size(); ++i) {
            CHECK(starts[i] > starts[i - 1]);
            CHECK(starts[i] - starts[i - 1] <= 150);
        }
    }
    const std::vector<int> large = segment_starts(900, 100000);
    CHECK(large[1] <= 30);
}
