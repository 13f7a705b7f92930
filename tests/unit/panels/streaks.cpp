// Streaks are the paths of disks in the last 1/60 s of film, found here once more by a simulation
// that is stopped at every one of their corners.
#include "panels/gas/marks/streaks.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "panels/frame.h"
#include "support/pixels.h"
#include "support/scene_text.h"
#include "support/shot.h"

using namespace carom;

namespace {

Scene scene_of(const std::string& more, const std::string& film) {
    return test::scene_from("title: T\n" + more +
                            "film: {size: [640, 360], panels: [], streaks: "
                            "true, " +
                            film + "}\n");
}

const std::string periodic_gas =
    "box: {size: [16, 12], walls: periodic}\n"
    "gas: [{name: a, count: 40, radius: 0.4, temperature: 1}]\n";
const std::string falling_gas =
    "box: {size: [16, 12], walls: {left: periodic, right: periodic}}\ngravity: [0, -2]\n"
    "gas: [{name: a, count: 30, radius: 0.4, temperature: 1}]\n";

// The streaks of each frame of a film.
struct StreakFilm {
    Scene scene;
    std::vector<Tick> ticks = timeline(scene);
    std::vector<std::shared_ptr<const StreakState>> states = {};

    explicit StreakFilm(Scene its) : scene(std::move(its)) {
        Simulation run(scene.gas, scene.run);
        run.record_collisions(true);
        const BoxedGas none;
        Streaks streaks({scene, run.particles(), static_cast<int>(ticks.size()), none});
        const Eigen::ArrayXd zeros = Eigen::ArrayXd::Zero(run.particles().count());
        for (const Tick& tick : ticks) {
            const AdvanceResult advanced = run.advance_to(tick.time);
            states.push_back(streaks.see({tick, run.sample(), zeros, zeros, advanced}));
        }
    }

    // The simulated time that the film shows at a number of frames, between frames too.
    double time_at(double frame) const {
        const auto before = static_cast<std::size_t>(std::max(0.0, std::floor(frame)));
        const double share = frame - static_cast<double>(before);
        if (before + 1 >= ticks.size()) return ticks.back().time;
        return ticks[before].time + share * (ticks[before + 1].time - ticks[before].time);
    }
};

struct SeenPlace {
    double time;
    Eigen::Index particle;
    Vec place;  // not wrapped
};

// The corners of all streaks, and the middles of the lines between them.
std::vector<SeenPlace> places_of(const StreakFilm& film) {
    std::vector<SeenPlace> all;
    const double frames = film.scene.film.fps / 60.0;
    Simulation run(film.scene.gas, film.scene.run);
    for (std::size_t frame = 0; frame < film.ticks.size(); ++frame) {
        run.advance_to(film.ticks[frame].time);
        if (!film.states[frame]) continue;
        for (Eigen::Index i = 0; i < run.particles().count(); ++i) {
            const Vec now = vec_in(run.sample().position, i);
            Eigen::Array3d last{0.0, 0.0, 1.0};
            const auto add = [&](const Eigen::Array3d& at) {
                const double back = (1.0 - at[2]) * frames;
                all.push_back(
                    {film.time_at(static_cast<double>(frame) - back), i, now + Vec(at[0], at[1])});
            };
            for (const auto& [x, y, light] : film.states[frame]->of(static_cast<std::size_t>(i))) {
                const Eigen::Array3d at{double(x), double(y), double(light)};
                add(0.5 * (last + at));
                add(at);
                last = at;
            }
        }
    }
    std::ranges::sort(all, {}, &SeenPlace::time);
    return all;
}

// The largest distance of these places from the disks at their times.
double farthest_off(const StreakFilm& film) {
    Simulation run(film.scene.gas, film.scene.run);
    const Box& box = film.scene.gas.box;
    double farthest = 0.0;
    for (const SeenPlace& seen : places_of(film)) {
        run.advance_to(seen.time);
        const Vec at = vec_in(run.sample().position, seen.particle);
        farthest = std::max(farthest, length(box.nearest(seen.place - at)));
    }
    return farthest;
}

std::size_t corners_in(const StreakFilm& film) {
    std::size_t sum = 0;
    for (const auto& state : film.states) sum += state ? state->corners.size() : 0;
    return sum;
}

// A curve is drawn as lines that are off by 1e-4 of the shorter side; the rest is single precision.
constexpr double rounding = 2e-5, of_curves = 1e-4 * 12.0;

}  // namespace

TEST_CASE("a streak is where its disk was, around collisions and through periodic sides") {
    for (const int fps : {10, 30, 60, 120}) {
        CAPTURE(fps);
        const StreakFilm film(scene_of(periodic_gas + "run: {until: 8}\n",
                                       "seconds: 1.6, fps: " + std::to_string(fps)));
        const auto lines = static_cast<std::size_t>(
            std::ranges::count_if(film.states, [](const auto& state) { return state != nullptr; }));
        CHECK(corners_in(film) > 41 * lines);  // more than one line each: some are bent
        CHECK(farthest_off(film) < rounding);
    }
}

TEST_CASE("under gravity a streak is curved") {
    const StreakFilm film(scene_of(falling_gas + "run: {until: 16}\n", "seconds: 1, fps: 30"));
    CHECK(farthest_off(film) < of_curves);
}

TEST_CASE("a streak lasts 1/60 s of film, in slow motion too, and reaches back to there") {
    const StreakFilm film(
        scene_of(periodic_gas + "run: {until: 8, events: [{at: 6, heat: {of: all, by: 20}}]}\n",
                 "seconds: 6, fps: 60, slow: [{from: 2, to: 3, factor: 0.1}]"));
    CHECK(farthest_off(film) < rounding);
    double slowest = 1e9, fastest = 0.0;
    for (std::size_t frame = 1; frame < film.ticks.size(); ++frame) {
        const double span = film.ticks[frame].time - film.ticks[frame - 1].time;
        if (span == 0.0) continue;
        REQUIRE(film.states[frame]);
        for (std::size_t i = 0; i < 40; ++i) {
            const auto corners = film.states[frame]->of(i);
            REQUIRE(!corners.empty());
            CHECK(double(corners.back().light) == doctest::Approx(0.0).epsilon(1e-6));
        }
        const auto corner = film.states[frame]->of(0).back();
        const double length = std::hypot(double(corner.x), double(corner.y));
        slowest = std::min(slowest, length / span);
        fastest = std::max(fastest, span);
        if (film.ticks[frame].time > 2.0 && film.ticks[frame].time < 3.0)
            CHECK(span < 0.02);  // a tenth of the rest
    }
    CHECK(fastest > 0.02);
}

TEST_CASE("there is no streak in a pause, in holds and at a reversal") {
    const StreakFilm film(
        scene_of(periodic_gas + "run: {until: 8, events: [{at: 2, pause: 0.5}, {at: 4, reverse: "
                                "velocities}]}\n",
                 "seconds: 6, fps: 30"));
    int pausing = 0;
    for (std::size_t frame = 1; frame < film.ticks.size(); ++frame) {
        const bool moves = film.ticks[frame].time > film.ticks[frame - 1].time;
        CHECK((film.states[frame] != nullptr) == moves);
        pausing += film.ticks[frame].phase == Phase::pausing;
    }
    CHECK(pausing == 15);
    CHECK(farthest_off(film) < rounding);
}

TEST_CASE("streaks lie behind disks that move, and through a periodic side on both sides") {
    // At the last frame the disk has just gone through the right side.
    const std::string gas =
        "box: {size: [16, 9], walls: periodic}\ngas: [{count: 1, radius: 0.5, position: [2.5, 4], "
        "velocity: [20, 0]}]\nrun: {until: 0.75}\n";
    const auto shot = [&](const std::string& streaks) {
        return test::scene_from("title: T\n" + gas +
                                "film: {template: minimal, seconds: 0.2, fps: "
                                "20, size: [1280, 720], panels: [], streaks: " +
                                streaks + "}\n");
    };
    const test::Shot with(shot("true")), without(shot("false"));
    std::size_t frame = 0;
    while (with.frames[frame].tick.time <= 0.0) ++frame;
    while (frame + 1 < with.frames.size() &&
           with.frames[frame + 1].tick.time > with.frames[frame].tick.time)
        ++frame;
    FramePainter painter(*with.panels), plain(*without.panels);
    const std::vector<std::uint32_t> one = test::pixels_of(painter.paint(with.frames[frame])),
                                     other = test::pixels_of(plain.paint(without.frames[frame]));
    // Columns that differ: to the left of the disk at 1.5, and at the right side.
    int first = 1280, last = 0, differ = 0;
    for (int x = 0; x < 1280; ++x) {
        bool is_other = false;
        for (int y = 0; y < 720; ++y)
            is_other =
                is_other || one[std::size_t(y * 1280 + x)] != other[std::size_t(y * 1280 + x)];
        if (!is_other) continue;
        first = std::min(first, x), last = std::max(last, x);
        ++differ;
    }
    REQUIRE(differ > 0);
    CHECK(differ < 500);
    CHECK(last - first > 700);
}

TEST_CASE("figures have no streaks") {
    const Scene scene = scene_of(periodic_gas + "run: {until: 8}\n", "seconds: 2");
    const Simulation run(scene.gas, scene.run);
    const BoxedGas none;
    CHECK(Streaks({scene, run.particles(), 60, none}).shown());
    CHECK_FALSE(Streaks({scene, run.particles(), 60, none, false}).shown());
}
