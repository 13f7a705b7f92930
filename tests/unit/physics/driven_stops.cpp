// Driven walls stop where their motion ends, whether it is given at the start or by an event, and
// only as long as no event has given them another motion.
#include <doctest/doctest.h>

#include <cmath>

#include "physics/gas.h"
#include "physics/simulation.h"
#include "support/relative.h"

using namespace carom;
using test::relative;

namespace {

// One disk far from the left wall, which is driven.
Gas gas_beside(Driven left) {
    Gas gas;
    gas.box.size = {40.0, 10.0};
    gas.box.surfaces.sides[0] = left;
    gas.species = {{.name = "disk", .count = 1, .radius = 0.3, .position = Places{{{30.0, 5.0}}}}};
    return gas;
}

double place_at(Simulation& simulation, double time) {
    simulation.advance_to(time);
    return simulation.surfaces()[0].motion->place;
}

}  // namespace

TEST_CASE("a driven wall stops by itself") {
    Simulation simulation(gas_beside({0.5, 4.0}), Run{});
    CHECK(place_at(simulation, 3.0) == relative(1.5, 1e-15));
    CHECK(place_at(simulation, 4.0) == relative(2.0, 1e-15));
    CHECK(place_at(simulation, 9.0) == relative(2.0, 1e-15));
}

TEST_CASE("what an event makes of a driven wall does not stop when its first motion would have") {
    Run run;
    run.events = {{2.0, MoveSurface{0, 0.25}}};
    Simulation simulation(gas_beside({0.5, 4.0}), run);
    CHECK(place_at(simulation, 10.0) == relative(1.0 + 8.0 * 0.25, 1e-15));
}

TEST_CASE("a wall that an event drives until a time stops then") {
    Run run;
    run.events = {{2.0, ChangeSurface{0, Driven{1.0, 5.0}}},
                  {8.0, ChangeSurface{0, Driven{1.0, 7.0}}}};
    Simulation simulation(gas_beside({0.0}), run);
    CHECK(place_at(simulation, 4.0) == relative(2.0, 1e-15));
    CHECK(place_at(simulation, 7.0) == relative(3.0, 1e-15));
    CHECK(place_at(simulation, 9.0) == relative(3.0, 1e-15));  // over before it began
}

TEST_CASE("after a reversal a wall that had stopped goes back, whatever its next event was") {
    Run run;
    run.bits = 128;
    run.events = {{3.0, ChangeSurface{0, Driven{1.0, 5.0}}},
                  {6.0, ChangeSurface{0, Reflecting{}}},
                  {7.0, ReverseVelocities{}}};
    Simulation simulation(gas_beside({0.0}), run);
    CHECK(place_at(simulation, 8.5) == relative(2.0, 1e-15));
    CHECK(place_at(simulation, 10.0) == relative(1.0, 1e-15));
    CHECK(std::abs(place_at(simulation, 11.5)) < 1e-15);
}
