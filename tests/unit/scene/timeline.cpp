#include "scene/time/timeline.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "scene/scene.h"

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

bool shows(const std::vector<Tick>& ticks, double time) {
    return std::any_of(ticks.begin(), ticks.end(),
                       [&](const Tick& tick) { return tick.time == time; });
}

std::vector<double> spaced(int count, double distance) {
    std::vector<double> times;
    for (int i = 1; i <= count; ++i) times.push_back(i * distance);
    return times;
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

TEST_CASE("a film reaches its end and every reversal, however early or dense the reversals are") {
    const std::vector<std::vector<double>> cases{
        {0.2},  {0.001},          {1e-7},          {1e-9},           {1e-12},        {23.9999},
        {9, 9}, {0.2, 0.3, 23.9}, spaced(60, 0.2), spaced(60, 1e-6), spaced(40, 0.5)};
    for (const std::vector<double>& reversals : cases)
        for (double until : {24.0, 1e12}) {
            CAPTURE(reversals.front());
            CAPTURE(until);
            const Scene scene = film(until, 3.0, 30, reversals);
            const std::vector<Tick> ticks = timeline(scene);
            REQUIRE(ticks.size() == 90);
            CHECK(ticks.front().time == 0.0);
            CHECK(ticks.back().time == until);
            CHECK(ticks.back().reversals == static_cast<int>(reversals.size()));
            CHECK(folded_time(scene.run, ticks.back().time) == folded_time(scene.run, until));
            for (double reversal : reversals) CHECK(shows(ticks, reversal));
            CHECK(std::is_sorted(ticks.begin(), ticks.end(),
                                 [](const Tick& a, const Tick& b) { return a.time < b.time; }));
        }
}

TEST_CASE("an early reversal does not coarsen the rest of the film") {
    for (double at : {1e-7, 0.2, 1.0, 3.3, 7.0, 11.9}) {
        CAPTURE(at);
        const Scene scene = film(24.0, 3.0, 30, {at});
        const int steps = moving_steps(scene.film, scene.run);
        double longest = 0.0;
        const std::vector<Tick> ticks = timeline(scene);
        for (std::size_t i = 1; i < ticks.size(); ++i)
            longest = std::max(longest, ticks[i].time - ticks[i - 1].time);
        CHECK(longest <= 24.0 / (0.8 * steps));
    }
}

TEST_CASE("equal legs have equal steps also where few frames fall to each") {
    const Scene scene = film(24.0, 3.0, 30, spaced(19, 1.2));
    std::vector<int> steps(20);
    double last = 0.0;
    for (const Tick& tick : timeline(scene)) {
        if (tick.phase != Phase::moving || tick.time <= last) continue;
        ++steps[static_cast<std::size_t>(tick.reversals)];
        last = tick.time;
    }
    CHECK(steps == std::vector<int>(20, steps[0]));
    CHECK(steps[0] == moving_steps(scene.film, scene.run) / 20);
}

TEST_CASE("a film can have as many legs as moving steps") {
    const std::vector<double> reversals = spaced(88, 0.2);
    const Scene scene = film(24.0, 3.0, 30, reversals);
    REQUIRE(moving_steps(scene.film, scene.run) == branch_count(scene.run));
    const std::vector<Tick> ticks = timeline(scene);
    CHECK(ticks.size() == 90);
    CHECK(ticks.back().time == 24.0);
    for (double reversal : reversals) CHECK(shows(ticks, reversal));
}

TEST_CASE("pauses leave three quarters of the frames to the motion") {
    for (int reversals : {0, 1, 2, 7, 100, 1000}) {
        const Run run = film(24.0, 1.0, 30, spaced(reversals, 0.01)).run;
        for (int frames = 2; frames < 1500; ++frames) {
            Film length;
            length.seconds = frames / 30.0;
            CHECK(moving_steps(length, run) >= 0.75 * frames - 1.0);
        }
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
    CHECK(segment_starts(39, 200) == std::vector<int>{0, 39});
    // Short films have work for several cores too.
    CHECK(segment_starts(40, 200) == std::vector<int>{0, 20, 40});
    CHECK(segment_starts(120, 200) == std::vector<int>{0, 30, 60, 90, 120});
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

TEST_CASE("a pause stands for exactly its seconds at exactly its time, and moves nothing else") {
    Scene scene = film(12.0, 30.0, 30, {6.0});
    Scene longer = scene;
    longer.film.pauses = {{0.0, 1.0}, {4.321, 3.0}, {6.0, 2.0}};
    longer.film.seconds += 6.0;
    const std::vector<Tick> ticks = timeline(longer);
    REQUIRE(ticks.size() == 1080);
    std::vector<double> moving;
    int before = 0, at_turn = 0;
    for (const Tick& tick : ticks) {
        if (tick.phase != Phase::pausing) {
            moving.push_back(tick.time);
            continue;
        }
        CHECK(tick.slow.factor == 0.0);
        CHECK(tick.slow.share == 1.0);  // a still says too that the film stands
        before += tick.time == 4.321;
        at_turn += tick.time == 6.0 && tick.reversals == 1;
    }
    CHECK(before == 90);
    CHECK(at_turn == 60);
    CHECK(std::is_sorted(ticks.begin(), ticks.end(),
                         [](const Tick& a, const Tick& b) { return a.time < b.time; }));
    std::vector<double> without;
    for (const Tick& tick : timeline(scene)) without.push_back(tick.time);
    CHECK(moving == without);
}

TEST_CASE("pauses take at most half of a film, all in the same proportion") {
    Scene scene = film(12.0, 10.0, 30);
    scene.film.pauses = {{2.0, 4.0}, {3.0, 8.0}};
    CHECK(most_pause_seconds(scene.film) == 5.0);
    int first = 0, second = 0;
    for (const Tick& tick : timeline(scene)) {
        first += tick.phase == Phase::pausing && tick.time == 2.0;
        second += tick.phase == Phase::pausing && tick.time == 3.0;
    }
    CHECK(first == 50);
    CHECK(second == 100);
}
