// The rate of collisions that kinetic theory expects, against simulations.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "physics/placement/draws.h"
#include "physics/simulation.h"
#include "physics/theory/law.h"

using namespace carom;

namespace {

double expected(const Gas& gas) {
    const auto [particles, sample] = draw_gas(gas);
    return 0.5 * static_cast<double>(particles.count()) *
           law(BoxedGas(gas.box, {}, particles, sample), LawOf::collision_rate).value;
}

double simulated(const Gas& gas, double begin, double end) {
    Simulation simulation(gas, Run{});
    const auto before = simulation.advance_to(begin).counts.particle;
    const auto after = simulation.advance_to(end).counts.particle;
    return static_cast<double>(after - before) / (end - begin);
}

Gas plane(Wall wall, double side) {
    Gas gas;
    gas.box.size = {side, side};
    gas.box.walls = {wall, wall};
    return gas;
}

Gas line(Wall wall, double length) {
    Gas gas;
    gas.box = {.dimension = 1, .size = {length, 0.0}, .walls = {wall, Wall::solid}};
    return gas;
}

void agree(const Gas& gas, double begin, double end, double tolerance) {
    const double theory = expected(gas);
    const double found = simulated(gas, begin, end);
    CAPTURE(theory);
    CAPTURE(found);
    CHECK(std::abs(found / theory - 1.0) < tolerance);
}

}  // namespace

// The tolerances: some 20,000 collisions scatter by less than 1 %; Henderson's contact value is
// within 0.5 % below a packing of 0.5, that of the mixture and the walls' part within 1 % more.
TEST_CASE("disks collide as often as Enskog's theory expects") {
    for (const double packing : {0.05, 0.3, 0.5}) {
        CAPTURE(packing);
        Gas gas = plane(Wall::periodic, std::sqrt(500.0 * std::numbers::pi / 4.0 / packing));
        gas.species = {{.name = "a",
                        .count = 500,
                        .velocity = Speed{Quantity{2.0}},
                        .position = LatticePlaces{}}};
        const double time = 40000.0 / expected(gas);
        agree(gas, 0.2 * time, time, 0.02);
    }
}

TEST_CASE("a mixture of sizes and masses between walls collides as often as expected") {
    for (const double side : {36.0, 80.0}) {
        CAPTURE(side);
        Gas gas = plane(Wall::solid, side);
        gas.species = {{.name = "small", .count = 300, .radius = 0.4, .velocity = Temperature{2.0}},
                       {.name = "large",
                        .count = 60,
                        .radius = UniformDistribution{0.8, 1.6},
                        .mass = Density{Quantity{5.0}},
                        .velocity = Temperature{2.0}}};
        const double time = 40000.0 / expected(gas);
        agree(gas, 0.2 * time, time, 0.03);
    }
}

// Points of equal mass only pass on their velocities: the count over a long time is exact up to
// one meeting of each pair.
TEST_CASE("equal beads on a line meet exactly as often as expected") {
    for (const Wall wall : {Wall::solid, Wall::periodic}) {
        Gas gas = line(wall, 30.0);
        gas.species = {{.name = "rods", .count = 20, .radius = 0.25, .velocity = Temperature{2.0}}};
        const double time = 20000.0;
        const double most_apart = 190.0 / (expected(gas) * time);
        agree(gas, 0.0, time, most_apart);
    }
}

TEST_CASE("beads of different masses meet about as often as expected") {
    for (const Wall wall : {Wall::solid, Wall::periodic}) {
        Gas gas = line(wall, 300.0);
        gas.species = {{.name = "light", .count = 100, .radius = 0.0, .velocity = Temperature{1.0}},
                       {.name = "heavy",
                        .count = 100,
                        .radius = 0.5,
                        .mass = Quantity{3.0},
                        .velocity = Temperature{1.0}}};
        // The beads do not change places, so that the order drawn matters: some 1/sqrt(200) of
        // the spread of g over its mean, 0.2.
        agree(gas, 20.0, 400.0, 0.05);
    }
}

TEST_CASE("there is no expected rate where there is none") {
    Gas gas = plane(Wall::solid, 20.0);
    gas.species = {{.name = "piston",
                    .count = 1,
                    .mass = Infinite{},
                    .velocity = Velocity{{Eigen::Array2d{1.0, 0.0}}}},
                   {.name = "gas", .count = 5}};
    const auto [particles, sample] = draw_gas(gas);
    CHECK(law(BoxedGas(gas.box, {}, particles, sample), LawOf::collision_rate).none->why ==
          NoLaw::Why::moving_infinite_mass);
    gas.species[0].velocity = AtRest{};
    CHECK(expected(gas) == 0.0);
    gas.species.pop_back();
    CHECK(expected(gas) == 0.0);
    Gas full = line(Wall::solid, 4.0);
    full.species = {{.name = "rods", .count = 4, .radius = 0.5, .velocity = Temperature{1.0}}};
    const auto [rods, start] = draw_gas(full);
    CHECK(law(BoxedGas(full.box, {}, rods, start), LawOf::collision_rate).none->why ==
          NoLaw::Why::no_room);
}
