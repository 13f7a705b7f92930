// What takes the results of a run as they come.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "runs/run.h"
#include "scene/scene.h"
#include "support/scene_text.h"

using namespace carom;

namespace {

Scene crowd(double sample_every) {
    return test::scene_from(
        "title: T\nbox: {size: [40, 30]}\ngas: [{name: a, count: 300, radius: 0.5, temperature: "
        "4}]\nrun: {until: 60}\n",
        {"run.sample_every=" + std::to_string(sample_every)});
}

Scene large_crowd(double sample_every) {
    return test::scene_from(
        "title: T\nbox: {size: [80, 60]}\ngas: [{name: a, count: 1200, radius: 0.5, temperature: "
        "4}]\nrun: {until: 6}\n",
        {"run.sample_every=" + std::to_string(sample_every)});
}

// What takers were given: times and places of samples, and of collisions.
struct Taken {
    std::vector<double> numbers;
    std::vector<std::thread::id> threads;
    RunReport report;
};

Taken taken(const Scene& scene, bool is_sample, bool is_collisions, bool aside) {
    Taken all;
    RunTakers take{.aside = aside};
    if (is_sample)
        take.sample = [&](const Particles&, const Sample& sample,
                          const std::vector<SurfaceState>&) {
            all.threads.push_back(std::this_thread::get_id());
            all.numbers.push_back(sample.time);
            for (const double place : sample.position.reshaped()) all.numbers.push_back(place);
        };
    if (is_collisions)
        take.collisions = [&](const Particles&, std::span<const Collision> collisions) {
            all.threads.push_back(std::this_thread::get_id());
            for (const Collision& one : collisions) {
                all.numbers.push_back(one.time);
                all.numbers.push_back(one.first_after[0]);
            }
        };
    all.report = run_physics(scene, take);
    return all;
}

}  // namespace

TEST_CASE("on a thread of their own takers are given the same, and statistics are the same") {
    for (const double sample_every : {6.0, 0.2, 0.002}) {
        const Scene scene = large_crowd(sample_every);
        for (const bool is_sample : {false, true})
            for (const bool is_collisions : {false, true}) {
                CAPTURE(sample_every);
                CAPTURE(is_sample);
                CAPTURE(is_collisions);
                const Taken here = taken(scene, is_sample, is_collisions, false);
                const Taken aside = taken(scene, is_sample, is_collisions, true);
                CHECK((here.numbers == aside.numbers));
                for (const std::thread::id& thread : here.threads)
                    REQUIRE(thread == std::this_thread::get_id());
                for (const std::thread::id& thread : aside.threads)
                    REQUIRE(thread != std::this_thread::get_id());
                const RunSummary &a = here.report.summary, &b = aside.report.summary;
                CHECK(here.report.state == aside.report.state);
                CHECK(a.temperature == b.temperature);
                CHECK(a.energy_final == b.energy_final);
                CHECK(a.largest_overlap == b.largest_overlap);
                CHECK(a.species[0].speed == b.species[0].speed);
                CHECK(a.speeds.counts == b.speeds.counts);
            }
    }
}

TEST_CASE("what a taker throws ends the run, also from a thread of its own") {
    for (const bool aside : {false, true}) {
        const auto refuse = [](const Particles&, const Sample& sample,
                               const std::vector<SurfaceState>&) {
            if (sample.time > 1.0) throw std::runtime_error("the disk is full");
        };
        CHECK_THROWS_WITH(run_physics(large_crowd(0.1), {.sample = refuse, .aside = aside}),
                          "the disk is full");
    }
}

TEST_CASE("of all collisions few are held at a time, also between two samples") {
    std::size_t most = 0, all = 0;
    double last = 0.0;
    const auto take = [&](const Particles& particles, std::span<const Collision> collisions) {
        CHECK(particles.count() == 300);
        most = std::max(most, collisions.size());
        all += collisions.size();
        for (const Collision& one : collisions) {
            CHECK(one.time >= last);
            last = one.time;
        }
    };
    const RunReport report = run_physics(crowd(60.0), {.collisions = take});
    CHECK(static_cast<std::int64_t>(all) == events_of(report.collisions));
    CHECK(all > 20'000);
    // Steps aim at 4096 of a rate that does not double in one of them.
    CHECK(most < 3 * 4096);
}

TEST_CASE("what is taken changes nothing in the run") {
    const auto ignore = [](const Particles&, std::span<const Collision>) {};
    CHECK(run_physics(crowd(7.0), {.collisions = ignore}).state == run_physics(crowd(60.0)).state);
}
