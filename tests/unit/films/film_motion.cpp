// What encoders are told of the motion in a film.
#include "films/film_motion.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <string>

#include "panels/precision.h"
#include "support/scene_text.h"

using namespace carom;

namespace {

// Disks of radius 0.5 in a box of 40 by 30 that move `step` pixels from frame to frame: 27 pixels
// are a unit of length.
Motion motion_with(int count, double step, const Overrides& changes = {}) {
    const double speed = step / 27.0 * 300.0 / 40.0;
    const Scene scene = test::scene_from(
        fmt::format("title: T\nbox: {{size: [40, 30]}}\n"
                    "gas: [{{count: {}, radius: 0.5, speed: {}}}]\nrun: {{until: 40}}\n"
                    "film: {{size: [1800, 1012], fps: 30, seconds: 10}}\n",
                    count, speed),
        changes);
    StartedScene started = start_scene(scene);
    return motion_of(started.scene, started.simulation.particles(), started.simulation.sample());
}

}  // namespace

TEST_CASE("few disks are sparse until they move by many pixels from frame to frame") {
    CHECK(motion_with(200, 0.1) == Motion::sparse);
    CHECK(motion_with(200, 2.4) == Motion::sparse);
    CHECK(motion_with(200, 2.6) == Motion::fast);
    CHECK(motion_with(200, 30) == Motion::fast);
    // Half the frames, so that each moves twice as far; and half the pixels.
    CHECK(motion_with(200, 1.4, {"film.fps=15"}) == Motion::fast);
    CHECK(motion_with(200, 4.0, {"film.size=[900, 506]"}) == Motion::sparse);
}

TEST_CASE("many edges are searched for motion as usual, and so is a field that stands still") {
    CHECK(motion_with(400, 0.1) == Motion::usual);
    CHECK(motion_with(400, 30) == Motion::usual);
    CHECK(motion_with(100, 0.1, {"film.field={of: density, cells: 8}"}) == Motion::usual);
    CHECK(motion_with(100, 30, {"film.field={of: density, cells: 8}"}) == Motion::fast);
}

TEST_CASE("beads on a line are as usual until they are fast, and no particles have no motion") {
    const auto beads = [](double speed) {
        const Scene line = test::scene_from(
            fmt::format("title: T\nbox: {{length: 10}}\ngas: [{{count: 8, radius: 0, speed: {}}}]\n"
                        "run: {{until: 10}}\nfilm: {{seconds: 10}}\n",
                        speed));
        StartedScene started = start_scene(line);
        return motion_of(started.scene, started.simulation.particles(),
                         started.simulation.sample());
    };
    CHECK(beads(0.1) == Motion::usual);
    CHECK(beads(10) == Motion::fast);
    CHECK(motion_of({}, {}, {}) == Motion::usual);
}
