// The virial theorem in a box of equal disks, exact at every time with its boundary term: momentum
// on the walls, virial of the collisions and change of sum p . r add up. Checks at once the
// simulation's impulses and both pressures made of them.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "physics/gas.h"
#include "physics/mechanics.h"
#include "physics/simulation.h"
#include "physics/theory/equation_of_state.h"
#include "stats/pressure.h"
#include "support/bodies.h"
#include "support/relative.h"
#include "util/random.h"

using namespace carom;
using test::relative;

namespace {

// sum p . r, r from the centre of the box
double momentum_times_place(const Simulation& simulation, const Sample& sample) {
    const Eigen::ArrayXd mass = masses(simulation.particles());
    double sum = 0.0;
    for (Eigen::Index a = 0; a < sample.position.cols(); ++a)
        sum += (mass * sample.velocity.col(a) *
                (sample.position.col(a) - 0.5 * simulation.box().size[a]))
                   .sum();
    return sum;
}

// Disks of one radius and two masses in a square
Gas disks_of_two_masses(double radius, std::uint64_t seed) {
    Gas gas;
    gas.seed = seed;
    gas.box.size = {20.0, 20.0};
    gas.species = {
        {.name = "light", .count = 40, .radius = radius, .velocity = Speed{2.0}},
        {.name = "heavy",
         .count = 40,
         .radius = radius,
         .mass = ValueRule{7.0},
         .velocity = Temperature{1.0}},
    };
    return gas;
}

// Sixteen beads of different masses on a line of length 20
Simulation sixteen_beads(double radius) {
    std::vector<test::Bead> beads;
    Random random(3, "beads");
    for (int i = 0; i < 16; ++i) {
        const double inverse_mass = 1.0 / random.uniform(1.0, 7.0);
        beads.push_back({(i + 0.5) * 1.25, random.normal(), inverse_mass});
    }
    return test::along_a_line(1, 20.0, radius, beads);
}

}  // namespace

TEST_CASE("momentum on the walls, virial and boundary term add up at every time") {
    for (const int dimension : {1, 2}) {
        for (const double radius : {0.3, 0.6}) {
            CAPTURE(dimension);
            CAPTURE(radius);
            Simulation simulation = dimension == 1
                                        ? sixteen_beads(radius)
                                        : Simulation(disks_of_two_masses(radius, 3), Run{});
            const Box& box = simulation.box();
            const double begun = momentum_times_place(simulation, simulation.sample());
            for (const double time : {0.1, 1.0, 7.0, 50.0, 400.0}) {
                CAPTURE(time);
                const ImpulseTotals impulses = simulation.advance_to(time).impulses;
                const Sample& sample = simulation.sample();
                const double energy = thermal_motion(box, simulation.particles(), sample).energy;
                double walls = 0.0;
                for (std::size_t a = 0; a < static_cast<std::size_t>(dimension); ++a)
                    walls += (box.length(a) - 2.0 * radius) * 0.5 *
                             (impulses.wall[2 * a] + impulses.wall[2 * a + 1]);
                const double boundary = momentum_times_place(simulation, sample) - begun;
                const double gas = 2.0 * energy * time + impulses.virial - boundary;
                // Round-off of some 1e5 terms
                CHECK(walls == doctest::Approx(gas).epsilon(1e-11));

                // In a square the same holds for the two pressures.
                const double room =
                    dimension == 1 ? 20.0 - 2.0 * radius : 2.0 * 20.0 * (20.0 - 2.0 * radius);
                const double by_walls = *wall_pressure(box, impulses, time);
                const double by_virial =
                    *virial_pressure(box, simulation.particles(), energy, impulses, time);
                CHECK(by_walls * room * time ==
                      doctest::Approx(by_virial * room * time - boundary).epsilon(1e-11));
            }
        }
    }
}

TEST_CASE("both pressures of a long run agree, whatever the radii and the sides of the box") {
    Gas gas = disks_of_two_masses(0.5, 8);
    gas.box.size = {30.0, 14.0};
    gas.species[1].radius = 0.9;
    Run run;
    run.equilibrate = 50.0;
    Simulation simulation(gas, run);
    constexpr double time = 3000.0;
    const ImpulseTotals impulses = simulation.advance_to(time).impulses;
    const double energy =
        thermal_motion(gas.box, simulation.particles(), simulation.sample()).energy;
    const double by_walls = *wall_pressure(gas.box, impulses, time);
    const double by_virial =
        *virial_pressure(gas.box, simulation.particles(), energy, impulses, time);
    CAPTURE(by_walls);
    // 1e5 hits of the walls: a standard error of 0.3 %, and a mean radius in place of two
    CHECK(by_virial == relative(by_walls, 0.015));
}

TEST_CASE("beads on a line press on its ends with 2E / (L - N a)") {
    Simulation simulation = sixteen_beads(0.3);
    constexpr double time = 20000.0;
    const ImpulseTotals impulses = simulation.advance_to(time).impulses;
    const ThermalMotion thermal =
        thermal_motion(simulation.box(), simulation.particles(), simulation.sample());
    const double energy = thermal.energy;
    const double exact = 2.0 * energy / (20.0 - 16 * 0.6);
    CHECK(*pressure_of_rods(simulation.box(), simulation.particles(), thermal) ==
          relative(exact, 1e-14));
    // 4e4 hits of each wall
    CHECK(*wall_pressure(simulation.box(), impulses, time) == relative(exact, 0.02));
    CHECK(*virial_pressure(simulation.box(), simulation.particles(), energy, impulses, time) ==
          relative(exact, 0.02));
}
