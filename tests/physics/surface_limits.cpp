// What surfaces could do without end: each run ends, with an error or a right answer.
#include <doctest/doctest.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "physics/events/event_loop.h"
#include "physics/gas.h"
#include "physics/placement/placement.h"
#include "physics/simulation.h"
#include "physics/surfaces/surface_error.h"
#include "support/bodies.h"

using namespace carom;
using test::Disk;
using test::simulation_of;

namespace {

Box box_under_gravity(double width, double height) {
    Box box{.dimension = 2, .size = {width, height}};
    box.surfaces.gravity = {0.0, -1.0};
    return box;
}

// Either it is said that it cannot go on, or the disks are where they were, moved on at `velocity`.
void check_rest_or_error(const Box& box, const std::vector<Disk>& disks, double velocity = 0.0) {
    Simulation simulation = simulation_of(box, disks);
    try {
        simulation.advance_to(2.0);
    } catch (const std::runtime_error& error) {
        const std::string message = error.what();
        CAPTURE(message);
        CHECK(message.find("lie without velocity on") != std::string::npos);
        return;
    }
    for (std::size_t i = 0; i < disks.size(); ++i)
        CHECK(simulation.sample().position(static_cast<Eigen::Index>(i), 1) ==
              doctest::Approx(disks[i].y + 2.0 * velocity).epsilon(1e-9));
}

}  // namespace

TEST_CASE("a gas that a wall squeezes until it jams ends with an error") {
    Gas gas;
    gas.box.size = {5.0, 2.0};
    gas.box.surfaces.sides[1] = Driven{-0.5};
    gas.species = {{.name = "gas", .count = 5, .radius = 0.4, .velocity = Temperature{1.0}}};
    CHECK_THROWS_WITH(Simulation(gas, {}).advance_to(9.5),
                      doctest::Contains("`right` crushes the gas at time"));
}

TEST_CASE("a partition that is driven to a wall is refused, a piston bounces off it") {
    Box box{.dimension = 2, .size = {10.0, 4.0}};
    box.surfaces.partitions = {{.name = "line", .axis = 0, .at = 4.0, .behaviour = Driven{-1.0}}};
    const std::vector<Disk> disks{{8.0, 2.0, 0.0, 0.0}};
    CHECK_THROWS_AS(simulation_of(box, disks).advance_to(20.0), std::exception);
    box.surfaces.partitions[0].behaviour = Piston{.mass = 2.0, .force = -1.0};
    Simulation piston = simulation_of(box, disks);
    piston.advance_to(1000.0);
    CHECK(piston.surfaces()[4].motion->place >= 0.0);
    CHECK(piston.surfaces()[4].motion->place < 4.0 + 1e-9);
    CHECK(piston.energy_account().relative_error.value() < 1e-12);
}

TEST_CASE("a demon that lets none pass is a wall") {
    Gas gas;
    gas.box.size = {12.0, 6.0};
    gas.box.surfaces.partitions = {
        {.name = "demon",
         .axis = 0,
         .at = 6.0,
         .behaviour = Membrane{.upward = {.faster_than = 1e9}, .downward = {.faster_than = 1e9}}}};
    gas.species = {{.name = "gas",
                    .count = 15,
                    .radius = 0.3,
                    .velocity = Temperature{1.0},
                    .position = WithinRegion{{{0.0, 0.0}, {6.0, 6.0}}}}};
    Simulation simulation(gas, {});
    simulation.advance_to(500.0);
    CHECK(simulation.surfaces()[4].hits > 500);
    CHECK(simulation.sample().position.col(0).maxCoeff() < 5.7 + 1e-12);
}

// Galperin (2003): as many hits as the digits of pi have it, nearly all of them in no time.
TEST_CASE("a light disk between a heavy piston and a wall is hit as often as pi says") {
    Box box{.dimension = 2, .size = {10.0, 4.0}};
    box.surfaces.sides[1] = Piston{.mass = 1e12, .velocity = -1.0};
    Simulation simulation = simulation_of(box, {{5.0, 2.0, 0.0, 0.0, 0.5, 1.0}});
    simulation.advance_to(1000.0);
    CHECK(simulation.surfaces()[0].hits + simulation.surfaces()[1].hits == 3'141'592);
}

TEST_CASE("a disk at rest on a shelf, a piston or a moving wall, and on others, ends") {
    SUBCASE("shelf") {
        Box box = box_under_gravity(10.0, 10.0);
        box.surfaces.obstacles = {{"shelf", Obstacle::Lines{{{2.0, 4.0}, {8.0, 4.0}}, false}}};
        check_rest_or_error(box, {{5.0, 4.5, 0.0, 0.0}});
    }
    SUBCASE("block") {
        Box box = box_under_gravity(10.0, 10.0);
        box.surfaces.obstacles = {
            {"block", Obstacle::Lines{{{2.0, 1.0}, {8.0, 1.0}, {8.0, 4.0}, {2.0, 4.0}}, true}}};
        check_rest_or_error(box, {{5.0, 4.5, 0.0, 0.0}});
    }
    SUBCASE("peg") {
        Box box = box_under_gravity(10.0, 10.0);
        box.surfaces.obstacles = {{"peg", Obstacle::Ball{{5.0, 3.0}, 1.0}}};
        check_rest_or_error(box, {{5.0, 4.5, 0.0, 0.0}});
    }
    SUBCASE("moving wall") {
        Box box = box_under_gravity(10.0, 10.0);
        box.surfaces.sides[2] = Driven{0.25};
        check_rest_or_error(box, {{5.0, 0.5, 0.0, 0.25}}, 0.25);
    }
    SUBCASE("piston") {
        Box box = box_under_gravity(10.0, 10.0);
        box.surfaces.partitions = {
            {.name = "piston", .axis = 1, .at = 3.0, .behaviour = Piston{2.0, 2.0}}};
        Simulation simulation = simulation_of(box, {{5.0, 3.5, 0.0, 0.0}});
        try {
            simulation.advance_to(1.0);
            CHECK(simulation.energy_account().relative_error.value() < 1e-12);
        } catch (const std::runtime_error& error) {
            const std::string message = error.what();
            CAPTURE(message);
            CHECK(message.find("lie without velocity on") != std::string::npos);
        }
    }
    SUBCASE("others") {
        check_rest_or_error(box_under_gravity(10.0, 10.0),
                            {{5.0, 0.5, 0.0, 0.0}, {5.0, 1.5, 0.0, 0.0}, {5.0, 2.5, 0.0, 0.0}});
    }
    SUBCASE("two others") {
        check_rest_or_error(
            box_under_gravity(10.0, 10.0),
            {{4.5, 0.5, 0.0, 0.0}, {5.5, 0.5, 0.0, 0.0}, {5.0, 0.5 + std::sqrt(0.75), 0.0, 0.0}});
    }
}

// A simulation refuses it before the run, as the partition reaches the obstacle.
TEST_CASE("a driven partition that crushes a piston against an obstacle ends the run") {
    Gas gas;
    gas.box.size = {10.0, 10.0};
    gas.box.surfaces.partitions = {
        {.name = "driven", .axis = 0, .at = 2.0, .behaviour = Driven{.velocity = 0.5}},
        {.name = "piston",
         .axis = 0,
         .at = 4.0,
         .behaviour = Piston{.mass = 1.0, .velocity = 0.1}}};
    gas.box.surfaces.obstacles = {{"peg", Obstacle::Ball{{8.0, 5.0}, 1.0}}};
    gas.species = {{.name = "points",
                    .count = 1,
                    .radius = 0.0,
                    .velocity = Temperature{1.0},
                    .position = Places{{{9.5, 9.0}}}}};
    const auto [particles, start] = place(gas);
    EventLoop<2, double, true> loop(gas.box, particles);
    loop.start(start);
    CHECK_THROWS_WITH_AS(loop.advance(20.0, nullptr), "crushes a piston", SurfaceError);
}
