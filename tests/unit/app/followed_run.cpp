// A run of the physics: what is taken of its samples changes nothing in its report.
#include <doctest/doctest.h>

#include <string>

#include "app/report/run_facts.h"
#include "runs/run.h"
#include "scene/scene.h"
#include "support/scene_text.h"

using namespace carom;

namespace {

// A scene of more disks than are looked at one by one in every sample.
Scene scene_of(const std::string& box, const std::string& run) {
    return test::scene_from("title: T\nbox: " + box +
                            "\ngas:\n  - {name: light, count: 900, radius: 0.3, temperature: 1}\n"
                            "  - {name: heavy, count: 300, radius: 0.5, mass: 3, speed: 1}\n"
                            "run: " +
                            run + "\n");
}

// All of it but the time that it took.
std::string report_of(const Scene& scene, const SampleTaker& take) {
    RunReport report = run_physics(scene, RunTakers{.sample = take});
    report.seconds = {};
    return run_json(scene, report);
}

void check_is_the_same(const Scene& scene) {
    int samples = 0;
    const std::string seen = report_of(scene, [&](const Particles&, const Sample&,
                                                  const std::vector<SurfaceState>&) { ++samples; });
    CHECK(samples > 10);
    CHECK(report_of(scene, {}) == seen);
}

}  // namespace

TEST_CASE("a run whose samples are seen by their changes gives the very same report") {
    SUBCASE("in many samples") {
        check_is_the_same(scene_of("{size: [60, 50]}", "{until: 1, sample_every: 0.005}"));
    }
    SUBCASE("in few samples, between which most disks collide") {
        check_is_the_same(scene_of("{size: [60, 50]}", "{until: 10, sample_every: 0.5}"));
    }
    SUBCASE("in some of both") {
        check_is_the_same(
            scene_of("{size: [60, 50], walls: periodic}", "{until: 5, sample_every: 0.05}"));
    }
    SUBCASE("with a way back") {
        check_is_the_same(
            scene_of("{size: [60, 50], walls: periodic}",
                     "{until: 1, sample_every: 0.01, events: [{at: 0.5, reverse: velocities}]}"));
    }
    SUBCASE("under gravity") {
        check_is_the_same(
            scene_of("{size: [60, 50]}\ngravity: [0, -0.1]", "{until: 1, sample_every: 0.01}"));
    }
}
