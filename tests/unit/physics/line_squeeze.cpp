#include "physics/placement/line_squeeze.h"

#include <doctest/doctest.h>

#include <limits>
#include <string>
#include <vector>

#include "physics/gas.h"
#include "physics/placement/placement.h"
#include "physics/simulation.h"
#include "support/bodies.h"

using namespace carom;

namespace {

constexpr double fixed = std::numeric_limits<double>::infinity();

struct Bead {
    double x, v, mass, radius = 0.0;
};

std::string squeeze_of(Wall ends, const std::vector<Bead>& beads, const Run& run) {
    std::vector<test::Disk> disks;
    for (const Bead& bead : beads)
        disks.push_back({bead.x, 0.0, bead.v, 0.0, bead.radius, 1.0 / bead.mass});
    const auto [particles, start] = test::start_of(1, disks);
    const Box box{1, {10.0, 0.0}, {ends, Wall::solid}};
    const auto squeeze = first_squeeze(box, particles, start, run);
    return squeeze ? to_text(*squeeze, {box, {}, 0}).message : "none";
}

Run until(double end, std::vector<double> reversals = {}) {
    Run run;
    run.until = end;
    for (const double at : reversals) run.events.push_back({at, ReverseVelocities{}});
    return run;
}

}  // namespace

TEST_CASE("two beads of infinite mass meet, whatever is between them") {
    const std::string met = "particle 0 and particle 2 of infinite mass leave no room between them";
    const std::vector<Bead> far{{2.0, 1.0, fixed, 0.5}, {4.0, 0.0, 1.0}, {8.0, -1.0, fixed}};
    CHECK(squeeze_of(Wall::solid, far, until(3.0)) == met + " at time 2.75");
    CHECK(squeeze_of(Wall::solid, far, until(2.7)) == "none");
    // Turned round at 2 they return by 4, and on to the walls, where no bead is.
    CHECK(squeeze_of(Wall::solid, far, until(9.0, {2.0})) == "none");
    // A rod between them takes up room.
    std::vector<Bead> rod = far;
    rod[1].radius = 1.0;
    CHECK(squeeze_of(Wall::solid, rod, until(3.0)) == met + " at time 1.75");
    rod[0].v = rod[2].v = 3.0;
    CHECK(squeeze_of(Wall::periodic, rod, until(1e6)) == "none");
    // Across the end of a ring: 4 apart, less the radius, closing at 2.
    CHECK(squeeze_of(Wall::periodic, {{2.0, -1.0, fixed, 0.5}, {4.0, 0.0, 1.0}, {8.0, 1.0, fixed}},
                     until(9.0)) == met + " at time 1.75");
    CHECK(squeeze_of(Wall::periodic,
                     {{2.0, -1.0, fixed, 0.5},
                      {0.5, 0.0, 1.0, 0.125},
                      {8.0, 1.0, fixed},
                      {9.0, 0.0, 1.0, 0.25}},
                     until(9.0)) == met + " at time 1.375");
    Run early = until(1.0);
    early.equilibrate = 2.0;
    CHECK(squeeze_of(Wall::solid, far, early) == met + " at time 0.75");
}

TEST_CASE("a bead of infinite mass presses others against the end of the line, or bounces there") {
    const std::vector<Bead> piston{{1.0, 0.0, 1.0}, {5.0, -1.0, fixed}};
    CHECK(squeeze_of(Wall::solid, piston, until(6.0)) ==
          "particle 1 of infinite mass presses beads against the left end of the wire at time 5");
    // Alone at that side it comes back, and presses to the right.
    CHECK(squeeze_of(Wall::solid, {{5.0, -1.0, fixed}, {9.0, 0.0, 1.0}}, until(100.0)) ==
          "particle 0 of infinite mass presses beads against the right end of the wire at time 15");
    CHECK(squeeze_of(Wall::solid, {{5.0, -1.0, fixed}}, until(1e9)) == "none");
    CHECK(squeeze_of(Wall::periodic, piston, until(1e9)) == "none");
    CHECK(squeeze_of(Wall::solid, {{5.0, 0.0, fixed}, {9.0, 3.0, 1.0}}, until(1e9)) == "none");
}

TEST_CASE("a simulation refuses what would be squeezed, wherever beads are placed at random") {
    Gas gas;
    gas.box = {1, {10.0, 0.0}, {Wall::solid, Wall::solid}};
    gas.species = {{.name = "gas", .count = 5, .radius = 0.0, .velocity = Speed{1.0}},
                   {.name = "piston", .count = 1, .radius = 0.0, .mass = Infinite{}}};
    gas.species[1].position = Places{{{5.0, 0.0}}};
    gas.species[1].velocity = Velocity{{{1.0, 0.0}}};
    try {
        Simulation(gas, until(20.0));
        CHECK(false);
    } catch (const PlacementError& error) {
        CHECK(error.species() == 1);
        CHECK(std::string(error.what()).find(": give a finite mass") != std::string::npos);
    }
    CHECK_NOTHROW(Simulation(gas, until(2.0)));
}
