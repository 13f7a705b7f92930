// What takes the results of a run as they come.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "runs/run.h"
#include "support/scene_text.h"

using namespace carom;

namespace {

Scene crowd(double sample_every) {
    return test::scene_from(
        "title: T\nbox: {size: [40, 30]}\ngas: [{name: a, count: 300, radius: 0.5, temperature: "
        "4}]\nrun: {until: 60}\n",
        {"run.sample_every=" + std::to_string(sample_every)});
}

}  // namespace

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
