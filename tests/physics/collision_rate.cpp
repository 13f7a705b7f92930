// The rate of collisions that kinetic theory expects, against simulations.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "physics/placement/draws.h"
#include "physics/placement/placement.h"
#include "physics/simulation.h"
#include "physics/theory/law.h"

using namespace carom;

namespace {

double expected(const Gas& gas) {
    const auto [particles, sample] = place(gas);
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
                        .velocity = Speed{ValueRule{2.0}},
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
                        .mass = Density{ValueRule{5.0}},
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

// Some 10,000 meetings, which scatter by less than 1 %; and the state at the start is not one of
// equilibrium.
TEST_CASE("beads of different masses meet as often as expected") {
    for (const Wall wall : {Wall::solid, Wall::periodic}) {
        Gas gas = line(wall, 300.0);
        gas.species = {{.name = "light", .count = 100, .radius = 0.0, .velocity = Temperature{1.0}},
                       {.name = "heavy",
                        .count = 100,
                        .radius = 0.5,
                        .mass = ValueRule{3.0},
                        .velocity = Temperature{1.0}}};
        agree(gas, 20.0, 400.0, 0.02);
    }
}

namespace {

// Beads of zero size, of these masses from left to right.
Gas beads_in_order(Wall wall, const std::vector<double>& masses) {
    Gas gas = line(wall, 10.0);
    Species beads{.name = "beads",
                  .count = std::ssize(masses),
                  .radius = 0.0,
                  .mass = ValueRule{masses},
                  .velocity = Temperature{1.0}};
    Places places;
    for (std::size_t k = 0; k < masses.size(); ++k)
        places.values.push_back({1.0 + static_cast<double>(k), 0.0});
    beads.position = std::move(places);
    gas.species = {std::move(beads)};
    return gas;
}

}  // namespace

// Some 100,000 meetings. Between walls the sum over all pairs, as if any bead met any other, is 3 %
// below the count for the first order, and 4 to 7 % above it for the others.
TEST_CASE("beads of different masses only meet their neighbours") {
    for (const Wall wall : {Wall::solid, Wall::periodic})
        for (const std::vector<double>& masses : {std::vector<double>{4, 7, 2, 6, 1, 3, 8, 5, 9},
                                                  {1, 9, 2, 8, 3, 7, 4, 6, 5},
                                                  {1, 2, 3, 4, 5, 6, 7, 8, 9},
                                                  {1, 1, 1, 1, 9, 9, 9, 9}}) {
            const Gas gas = beads_in_order(wall, masses);
            const double time = 100000.0 / expected(gas);
            agree(gas, 0.05 * time, time, 0.01);
        }
}

TEST_CASE("the rate of beads of different masses is that of their order, once it is known") {
    Gas gas = line(Wall::solid, 30.0);
    gas.species = {{.name = "beads",
                    .count = 3,
                    .radius = 0.1,
                    .mass = ValueRule{std::vector<double>{1.0, 4.0, 2.0}},
                    .velocity = Temperature{1.0}}};
    const auto [particles, sample] = draw_gas(gas);
    CHECK(law(BoxedGas(gas.box, {}, particles, sample), LawOf::collision_rate).none->why ==
          NoLaw::Why::unknown_order);
    CHECK_FALSE(why_no_law(gas, {}, LawOf::collision_rate));
    gas.species[0].mass = ValueRule{2.0};
    const auto [equal, start] = draw_gas(gas);
    CHECK(law(BoxedGas(gas.box, {}, equal, start), LawOf::collision_rate));
    gas = beads_in_order(Wall::solid, {1.0, 4.0, 2.0});
    const auto [listed, known] = draw_gas(gas);
    CHECK(law(BoxedGas(gas.box, {}, listed, known), LawOf::collision_rate));
}

TEST_CASE("there is no expected rate where there is none") {
    Gas gas = plane(Wall::solid, 20.0);
    gas.species = {
        {.name = "piston", .count = 1, .mass = Infinite{}, .velocity = Velocity{{Vec{1.0, 0.0}}}},
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
