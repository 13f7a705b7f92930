// Scenes of one dimension: what their keys mean. What is wrong in them is in tests/scenes_bad.
#include <doctest/doctest.h>

#include <string>

#include "scene/scene.h"
#include "support/scene_text.h"

using namespace carom;

namespace {

Scene scene_of(const std::string& box, const std::string& gas, const Overrides& overrides = {}) {
    return test::scene_from(
        "title: T\nbox: {" + box + "}\ngas: [" + gas + "]\nrun: {until: 4}\nfilm: {seconds: 4}\n",
        overrides);
}

}  // namespace

TEST_CASE("a length makes a wire, on which beads are points unless they say otherwise") {
    const Scene scene = scene_of("length: 9.5", "{count: 4, speed: 1}");
    CHECK(scene.gas.box.dimension == 1);
    CHECK(scene.gas.box.size[0] == 9.5);
    CHECK(scene.gas.box.size[1] == 0.0);
    CHECK(scene.gas.box.walls == Walls{Wall::solid, Wall::solid});
    CHECK(std::get<double>(scene.gas.species[0].radius) == 0.0);
    CHECK_FALSE(scene.looks[0].drawn_radius.has_value());
    CHECK(scene_of("size: [9, 8]", "{count: 4}").gas.box.dimension == 2);
}

TEST_CASE("the ends of a wire are walls or joined; what lies across does not matter") {
    for (const std::string walls : {"periodic", "{left: periodic, right: periodic}"})
        CHECK(scene_of("length: 9, walls: " + walls, "{count: 4}").gas.box.walls ==
              Walls{Wall::periodic, Wall::solid});
    CHECK(scene_of("length: 9, walls: {right: solid}", "{count: 4}").gas.box.walls ==
          Walls{Wall::solid, Wall::solid});
}

TEST_CASE("places and velocities on a wire are numbers") {
    const Scene scene = scene_of(
        "length: 9",
        "{name: list, position: [7, 1, 3], velocity: [1, -1, 0], radius: 0.5, drawn_radius: 0.7}, "
        "{name: one, position: 5, velocity: -2.5}, "
        "{name: part, count: 3, position: {within: [1.5, 2.5]}, velocity: 2}, "
        "{name: even, count: 2, position: lattice}");
    const auto& species = scene.gas.species;
    CHECK(species[0].count == 3);
    CHECK(std::get<Places>(species[0].position).values[1][0] == 1.0);
    CHECK(std::get<Places>(species[0].position).values[1][1] == 0.0);
    CHECK(std::get<Velocity>(species[0].velocity).values[1][0] == -1.0);
    CHECK(scene.looks[0].drawn_radius == 0.7);
    CHECK(species[1].count == 1);
    CHECK(std::get<Places>(species[1].position).values[0][0] == 5.0);
    CHECK(std::get<Velocity>(species[1].velocity).values[0][0] == -2.5);
    CHECK(std::get<WithinRegion>(species[2].position).region.low[0] == 1.5);
    CHECK(std::get<WithinRegion>(species[2].position).region.high[0] == 2.5);
    CHECK(std::get<Velocity>(species[2].velocity).values.size() == 1);
    CHECK(std::holds_alternative<LatticePlaces>(species[3].position));
}

TEST_CASE("the command line can make a wire of a box") {
    const Overrides overrides{"box.length=9"};
    const Scene scene = scene_of("size: [9, 8]", "{count: 4}", overrides);
    CHECK(scene.gas.box.dimension == 1);
    CHECK(std::get<double>(scene.gas.species[0].radius) == 0.0);
}

TEST_CASE("a wire is described as one") {
    CHECK(scene_of("length: 9", "{count: 1, speed: 1}").description ==
          "1 bead, at speed 1, starts on a wire of length 9 between two walls and collides "
          "elastically.");
    CHECK(
        scene_of("length: 9, walls: periodic", "{name: a, count: 4, speed: 1}, {name: b, count: 2}")
            .description ==
        "4 beads (a, at speed 1) and 2 beads (b, at rest) start on a wire of length 9 whose ends "
        "are joined and collide elastically. What leaves at the right end enters at the left, "
        "and the other way round.");
}
