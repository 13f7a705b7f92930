// Equations of state against published numbers, and against the pressures of runs.
#include "physics/theory/equation_of_state.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "physics/gas.h"
#include "physics/simulation.h"
#include "stats/pressure.h"
#include "support/blocks.h"
#include "support/equal_disks.h"
#include "support/equation_of_state.h"
#include "support/relative.h"

using namespace carom;
using test::relative;

namespace {

// Disks of diameter 1 and two masses that cover this share of a box between these sides.
Gas disks(double packing, std::int64_t count, Walls walls) {
    const double area = static_cast<double>(count) * std::numbers::pi / 4.0 / packing;
    Gas gas;
    gas.seed = 11;
    gas.box.size = {std::sqrt(1.5 * area), std::sqrt(area / 1.5)};
    gas.box.walls = walls;
    const PositionRule places = LatticePlaces{};
    gas.species = {
        {.name = "light", .count = count / 2, .velocity = Temperature{1.5}, .position = places},
        {.name = "heavy",
         .count = count - count / 2,
         .mass = ValueRule{3.0},
         .velocity = Temperature{1.5},
         .position = places}};
    return gas;
}

// The impulses of blocks of a run of this length.
std::vector<ImpulseTotals> impulses_of_blocks(Simulation& simulation, int blocks, double length) {
    std::vector<ImpulseTotals> changes;
    PressureStart last;
    for (int i = 1; i <= blocks; ++i) {
        const ImpulseTotals now = simulation.advance_to(i * length).impulses;
        changes.push_back(last.since(now));
        last.impulses = now;
    }
    return changes;
}

struct Pressures {
    std::vector<double> virial, walls;  // of blocks of the run
    double henderson, kolafa_rottner;
};

// Blocks of this length.
Pressures pressures(const Gas& gas, double length = 40.0) {
    constexpr int blocks = 20;
    Run run;
    run.equilibrate = 40.0;
    Simulation simulation(gas, run);
    const ThermalMotion thermal =
        thermal_motion(gas.box, simulation.particles(), simulation.sample());
    Pressures found;
    for (const ImpulseTotals& change : impulses_of_blocks(simulation, blocks, length)) {
        found.virial.push_back(
            *virial_pressure(gas.box, simulation.particles(), thermal.energy, change, length));
        if (const auto walls = wall_pressure(gas.box, change, length))
            found.walls.push_back(*walls);
    }
    found.henderson =
        *pressure_of_fluid(EquationOfState::simple, gas.box, simulation.particles(), thermal);
    found.kolafa_rottner =
        *pressure_of_fluid(EquationOfState::accurate, gas.box, simulation.particles(), thermal);
    return found;
}

// Within five standard errors, beyond what the equation itself claims.
void check_pressure(const std::vector<double>& blocks, double expected, double claimed) {
    const test::Estimate found = test::estimate(blocks);
    const double mean = found.mean, error = found.error;
    CAPTURE(mean);
    CAPTURE(error);
    CAPTURE(expected);
    CHECK(std::abs(mean / expected - 1.0) < claimed + 5.0 * error / mean);
    CHECK(error < 0.005 * mean);
}

}  // namespace

TEST_CASE("equations of state have the values that their authors publish") {
    for (const double packing : {0.0, 0.1, 0.3, 0.5, 0.65, 0.7})
        CHECK(compressibility_factor(2, EquationOfState::accurate, packing) ==
              relative(1.0 + test::excess_compressibility(packing), 1e-14));
    // Li et al. 2022: beta P (2 sigma)^2 = 7.986735(26), sigma the radius; the fit is good to 1e-4.
    CHECK(compressibility_factor(2, EquationOfState::accurate, 0.67) * 0.67 * 4.0 /
              std::numbers::pi ==
          relative(7.986735, 1e-4));
    CHECK(compressibility_factor(2, EquationOfState::simple, 0.5) == 4.125);
    // Its third virial coefficient is 3.125 in powers of the packing; the exact one is 3.128.
    CHECK((compressibility_factor(2, EquationOfState::simple, 1e-4) - 1.0) / 1e-4 - 2.0 ==
          relative(3.125e-4, 1e-3));
}

TEST_CASE("spheres in a crystal have the pressure of Speedy's equation of state") {
    for (const double packing : {0.58, 0.65}) {
        CAPTURE(packing);
        const Gas gas = test::equal_spheres(packing, 500);
        Run run;
        run.equilibrate = 3.0;
        Simulation simulation(gas, run);
        const ThermalMotion thermal =
            thermal_motion(gas.box, simulation.particles(), simulation.sample());
        const auto expected =
            pressure_of_phase(PhaseOfSpheres::crystal, gas.box, simulation.particles(), thermal);
        REQUIRE(expected);
        std::vector<double> found;
        for (const ImpulseTotals& change : impulses_of_blocks(simulation, 20, 2.0))
            found.push_back(
                *virial_pressure(gas.box, simulation.particles(), thermal.energy, change, 2.0));
        // Fits to molecular dynamics differ by 0.0004; corrections of the order of 1 / N that are
        // not those of the centre of mass are below that.
        check_pressure(found, *expected, 0.0004);
    }
}

TEST_CASE("disks between periodic sides have the pressure of their equation of state") {
    for (const double packing : {0.05, 0.3, 0.5}) {
        CAPTURE(packing);
        const Gas gas = disks(packing, 400, {Wall::periodic, Wall::periodic});
        const Pressures found = pressures(gas);
        // The finite box changes Z - 1 by some 1/N of itself.
        check_pressure(found.virial, found.kolafa_rottner, 1.0 / 400.0);
        CHECK(found.henderson == relative(found.kolafa_rottner, 0.005));
    }
}

TEST_CASE("disks between walls have the pressure of their equation of state") {
    for (const double packing : {0.05, 0.15, 0.3, 0.47}) {
        CAPTURE(packing);
        const Gas gas = disks(packing, 400, {Wall::solid, Wall::solid});
        const Pressures found = pressures(gas, packing < 0.1 ? 160.0 : 40.0);
        // The tension of walls is exact to second order only.
        const double claimed = packing < 0.2 ? 0.003 : 0.01;
        check_pressure(found.virial, found.kolafa_rottner, claimed);
        check_pressure(found.walls, found.kolafa_rottner, claimed);
    }
}

TEST_CASE("disks in a box of thirteen diameters have the pressure of their equation of state") {
    // The walls' tension makes 4 % here; with the wrong sign the pressure would err by 2 %.
    Gas gas = disks(0.3, 64, {Wall::solid, Wall::solid});
    gas.box.size = {13.0, 13.0};
    const Pressures found = pressures(gas, 2000.0);
    check_pressure(found.walls, found.kolafa_rottner, 0.01);
    CHECK(test::estimate(found.walls).error < 0.0012 * found.kolafa_rottner);
}

TEST_CASE("disks between two walls have the pressure of their equation of state") {
    const Gas gas = disks(0.3, 400, {Wall::solid, Wall::periodic});
    const Pressures found = pressures(gas);
    check_pressure(found.walls, found.kolafa_rottner, 0.01);
}

TEST_CASE("there is no equation of state of a mixture of sizes, of a solid or of no gas") {
    const auto pressure = [](Gas gas) {
        gas.species[0].velocity = gas.species[1].velocity = Temperature{1.0};
        Simulation simulation(gas, Run{});
        return pressure_of_fluid(
            EquationOfState::accurate, gas.box, simulation.particles(),
            thermal_motion(gas.box, simulation.particles(), simulation.sample()));
    };
    Gas gas = disks(0.4, 100, {Wall::periodic, Wall::periodic});
    CHECK(pressure(gas));
    gas.species[0].radius = 0.45;
    CHECK_FALSE(pressure(gas));
    CHECK_FALSE(pressure(disks(0.75, 100, {Wall::periodic, Wall::periodic})));
    gas = disks(0.4, 100, {Wall::periodic, Wall::periodic});
    gas.species[0].mass = Infinite{};
    gas.species[0].velocity = AtRest{};
    CHECK_FALSE(pressure(gas));
}

TEST_CASE("a mixture of spheres between six walls has the pressure of scaled particle theory") {
    constexpr double packing = 0.3, length = 2.0;
    constexpr int each = 1000;
    Gas gas;
    gas.seed = 4;
    const double content = each * (content_of_ball(0.5, 3) + content_of_ball(0.25, 3));
    gas.box = test::cube_of(std::cbrt(content / packing), Wall::solid);  // 12.5 diameters wide
    for (const double diameter : {1.0, 0.5})
        gas.species.push_back({.name = diameter == 1.0 ? "large" : "small",
                               .count = each,
                               .radius = 0.5 * diameter,
                               .velocity = Temperature{1.0}});
    Run run;
    run.equilibrate = 5.0;
    Simulation simulation(gas, run);
    const ThermalMotion thermal =
        thermal_motion(gas.box, simulation.particles(), simulation.sample());
    const auto expected =
        pressure_of_fluid(EquationOfState::accurate, gas.box, simulation.particles(), thermal);
    REQUIRE(expected);
    std::vector<double> found;
    for (const ImpulseTotals& change : impulses_of_blocks(simulation, 20, length))
        found.push_back(*wall_pressure(gas.box, change, length));
    // The edges of the box, of which the theory is exact to second order only, count for 0.5 %.
    check_pressure(found, *expected, 0.006);
    // The pressure of the fluid at the density of the room that centres reach.
    double reach = 0.0;
    for (const double diameter : {1.0, 0.5}) reach += 0.5 * std::pow(gas.box.size[0] - diameter, 3);
    const Box bulk = test::cube_of(std::cbrt(reach), Wall::periodic);
    const auto without =
        pressure_of_fluid(EquationOfState::accurate, bulk, simulation.particles(), thermal);
    REQUIRE(without);
    CHECK(std::abs(*without / test::estimate(found).mean - 1.0) > 0.02);
}
