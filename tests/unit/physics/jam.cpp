#include "physics/placement/jam.h"

#include <doctest/doctest.h>

#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "physics/gas.h"
#include "physics/placement/placement.h"
#include "support/bodies.h"
#include "support/share_of_cases.h"

using namespace carom;
using test::Disk;

namespace {

std::string jam_of(const Box& box, const std::vector<Disk>& disks) {
    const auto [particles, start] = test::start_of(box.dimension, disks);
    const auto jam = first_jam(box, particles, start);
    return jam ? std::to_string(jam->particle) +
                     (jam->kind == Problem::Kind::jam_alone ? " alone" : "")
               : "none";
}

bool collides_without_end(const Box& box, const std::vector<Disk>& disks) {
    Simulation simulation = test::simulation_of(box, disks);
    try {
        simulation.advance_to(0.25);
    } catch (const std::runtime_error&) {
        return true;
    }
    return false;
}

struct Case {
    std::string about, jam;
    Box box;
    std::vector<Disk> disks;
};

constexpr double fixed = 0.0;  // the inverse of an infinite mass

Box line(Wall ends) { return {1, {6.0, 0.0}, {ends, Wall::solid}}; }
Box room(double width, double height, Wall sides = Wall::solid) {
    return {2, {width, height}, {sides, sides}};
}

const std::vector<Case> cases{
    {"beads from wall to wall",
     "1",
     line(Wall::solid),
     {{1, 0, 0, 0, 1}, {3, 0, 1, 0, 1}, {5, 0, 0, 0, 1}}},
    {"they are at rest",
     "none",
     line(Wall::solid),
     {{1, 0, 0, 0, 1}, {3, 0, 0, 0, 1}, {5, 0, 0, 0, 1}}},
    {"a thousandth is room",
     "none",
     line(Wall::solid),
     {{1, 0, 0, 0, 1}, {3, 0, 1, 0, 1}, {5, 0, 0, 0, 0.999}}},
    {"one bead as long as its wire", "0 alone", line(Wall::solid), {{3, 0, -1, 0, 3}}},
    {"around a ring",
     "2",
     line(Wall::periodic),
     {{1, 0, 1, 0, 1}, {3, 0, 1, 0, 1}, {5, 0, 2, 0, 1}}},
    {"they turn together",
     "none",
     line(Wall::periodic),
     {{1, 0, 1, 0, 1}, {3, 0, 1, 0, 1}, {5, 0, 1, 0, 1}}},
    {"beads in no order across the end of a ring, between two posts",
     "0",
     line(Wall::periodic),
     {{5.5, 0, 1, 0, 0.5}, {1, 0, 0, 0, 1, fixed}, {4.5, 0, 0, 0, 0.5, fixed}}},
    {"a post beside it leaves room on the other side",
     "none",
     line(Wall::solid),
     {{1, 0, 0, 0, 0.5, fixed}, {2, 0, 1, 0, 0.5}, {4, 0, 0, 0, 0.5, fixed}}},
    {"a row across the box", "1", room(4, 10), {{1, 5, 0, 1, 1}, {3, 5, 1, 0, 1}, {1, 8, 1, 0, 1}}},
    {"it moves along its free side",
     "none",
     room(4, 10),
     {{1, 5, 0, 1, 1}, {3, 5, 0, 1, 1}, {1, 8, 1, 0, 1}}},
    {"a row up the box", "1", room(10, 4), {{5, 1, 0, 0, 1}, {5, 3, 0, 1, 1}}},
    {"a step in the row gives way",
     "none",
     room(4, 10),
     {{1, 5, 1, 0, 1}, {2.96, 5.397994974842648, -1, 0, 1}}},
    {"around a periodic box",
     "1",
     room(4, 10, Wall::periodic),
     {{0.5, 5, 1, 0, 1}, {2.5, 5, -1, 0, 1}}},
    {"a disk as wide as its box", "0 alone", room(10, 4), {{5, 2, 1, 0.1, 2}}},
    {"it moves along its box", "none", room(10, 4), {{5, 2, 1, 0, 2}}},
    {"it is as wide as a periodic box", "none", room(10, 4, Wall::periodic), {{5, 2, 1, 0.1, 2}}},
    {"between two posts",
     "2",
     room(20, 10),
     {{5, 5, 0, 0, 1, fixed}, {9, 5, 0, 0, 1, fixed}, {7, 5, 1, 0, 1}}},
    {"one of infinite mass cannot move either", "0 alone", room(10, 4), {{5, 2, 0, 1, 2, fixed}}},
};

}  // namespace

TEST_CASE("a jam is where a run would collide without end at its start, and nowhere else") {
    int number = 0;
    for (const Case& one : cases) {
        CAPTURE(one.about);
        CHECK(jam_of(one.box, one.disks) == one.jam);
        if (number++ % test::every_nth(1, 4) != 0) continue;  // a run without end takes long
        CHECK(collides_without_end(one.box, one.disks) == (one.jam != "none"));
    }
}

TEST_CASE("a velocity that is not known differs from all others") {
    const double drawn = std::numeric_limits<double>::quiet_NaN();
    CHECK(jam_of(line(Wall::solid), {{3, 0, drawn, 0, 3}}) == "0 alone");
    CHECK(jam_of(line(Wall::periodic), {{1.5, 0, drawn, 0, 1.5}, {4.5, 0, drawn, 0, 1.5}}) == "1");
    CHECK(jam_of(line(Wall::periodic), {{3, 0, drawn, 0, 3}}) == "none");
}

TEST_CASE("a gas that is placed in a jam is refused, with its species") {
    Gas gas;
    gas.box.size = {10.0, 2.0};
    gas.species = {{.name = "row",
                    .count = 5,
                    .radius = 1.0,
                    .velocity = Speed{1.0},
                    .position = LatticePlaces{}}};
    std::string message;
    try {
        Simulation(gas, Run{});
    } catch (const PlacementError& error) {
        message = error.what();
    }
    CHECK(message ==
          "particle 0 (row) moves along a row of touching disks without any gap: it would "
          "collide infinitely often; smaller disks or a larger box give them room");
}
