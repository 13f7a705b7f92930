// Validation of equilibrium distributions of few particles at fixed total energy.
#include <cmath>
#include <string>
#include <vector>

#include "physics/gas.h"
#include "physics/mechanics.h"
#include "physics/simulation.h"
#include "support/csv.h"
#include "support/space.h"
#include "validation/study.h"

namespace carom::validation {

namespace {

constexpr const char* equilibria_field = "Equilibrium of few particles";

enum Column : std::size_t { mean_f2 = 3, kurtosis = 4, mean_speed = 6 };

/// The value of `column` in the table of moments, in the row that begins with `ensemble` and has
/// N = `count`.
double moment(const std::string& ensemble, int count, Column column) {
    for (const auto& row : test::reference_rows("microcanonical_moments.csv"))
        if (row[0].starts_with(ensemble) && std::stoi(row[1]) == count)
            return test::fraction(row[column]);
    throw std::runtime_error("no moment of " + ensemble);
}

/// Disks or spheres.
Gas few_bodies(int dimension, int count, Wall wall, std::uint64_t seed) {
    Gas gas;
    gas.seed = seed;
    gas.box = test::box_of(dimension, {4.0, 3.5, 3.0});
    gas.box.walls = {wall, wall, wall};
    gas.species = {{.name = "", .count = count, .radius = 0.3, .velocity = Speed{1.0}}};
    return gas;
}

/// Averages over all disks and many times: mean speed over sqrt(T), mean square of the share of the
/// energy, and kurtosis of a velocity component.
std::vector<double> moments(Simulation simulation, double freedom, double effort) {
    const auto count = static_cast<double>(simulation.particles().count());
    const double energy = kinetic_energies(simulation.particles(), simulation.sample()).sum();
    const double temperature = 2.0 * energy / freedom;
    const int samples = std::max(10, static_cast<int>(30'000 * effort));
    double speed = 0.0, square = 0.0, fourth = 0.0;
    for (int k = 1; k <= samples; ++k) {
        simulation.advance_to(3.1 * k);
        const Sample& now = simulation.sample();
        speed += speeds(now).mean() / samples;
        square +=
            (kinetic_energies(simulation.particles(), now) / energy).square().mean() / samples;
        fourth += now.velocity.square().square().mean() / samples;
    }
    const double variance =
        2.0 * energy / (count * static_cast<double>(simulation.sample().velocity.cols()));
    return {speed / std::sqrt(temperature), square, fourth / (variance * variance)};
}

constexpr const char* of_sphere =
    "exact: momenta are uniform on the sphere of energy; "
    "`tests/reference/microcanonical_moments.csv`";

/// The rows of a table of moments.
std::string ensemble_of(int dimension, const char* ends) {
    return std::to_string(dimension) + "D " + ends;
}

Study between_walls(int dimension, int count) {
    Study study;
    study.field = equilibria_field;
    study.runs = 20;
    const std::string of = " of " + std::to_string(count) +
                           (dimension == 2 ? " disks" : " spheres") + " between walls";
    const std::string walls = ensemble_of(dimension, "walls");
    study.truths = {
        {"mean speed over √*T*" + of, moment(walls, count, mean_speed), 0.0, 0.0, of_sphere},
        {"mean square of the share of the energy" + of, moment(walls, count, mean_f2), 0.0, 0.0,
         of_sphere},
        {"kurtosis of a component of velocity" + of, moment(walls, count, kurtosis), 0.0, 0.0,
         of_sphere}};
    study.measure = [=](const RunOf& run) {
        return moments(Simulation(few_bodies(dimension, count, Wall::solid, run.seed), {}),
                       dimension * count, run.effort);
    };
    return study;
}

Study in_a_periodic_box(int dimension) {
    Study study;
    study.field = equilibria_field;
    study.runs = 20;
    const std::string periodic = ensemble_of(dimension, "periodic");
    study.truths = {
        {std::string("mean speed over √*T* of 5 ") + (dimension == 2 ? "disks" : "spheres") +
             " in a periodic box, total momentum 0",
         moment(periodic, 5, mean_speed), 0.0, 0.0, of_sphere},
        {"mean square of the share of the energy, the same", moment(periodic, 5, mean_f2), 0.0, 0.0,
         of_sphere},
        {"kurtosis of a component of velocity, the same", moment(periodic, 5, kurtosis), 0.0, 0.0,
         of_sphere}};
    study.measure = [=](const RunOf& run) {
        Gas gas = few_bodies(dimension, 5, Wall::periodic, run.seed);
        gas.species[0].velocity = Temperature{1.0};  // at total momentum 0
        return moments(Simulation(gas, {}), dimension * (5 - 1), run.effort);
    };
    return study;
}

Study equipartition() {
    Study study;
    study.field = equilibria_field;
    study.runs = 20;
    study.truths = {
        {"mean energy of 50 disks of mass 8 over that of 150 of mass 1, which had all "
         "the energy",
         1.0, 0.0, 0.0, "exact: equipartition"}};
    study.measure = [=](const RunOf& run) {
        Gas gas;
        gas.seed = run.seed;
        gas.box.size = {40.0, 30.0};
        gas.species = {{.name = "light", .count = 150, .radius = 0.4, .velocity = Speed{3.0}},
                       {.name = "heavy", .count = 50, .radius = 0.8, .mass = ValueRule{8.0}}};
        Run how;
        how.equilibrate = 150.0;
        Simulation simulation(gas, how);
        double light = 0.0, heavy = 0.0;
        const int samples = std::max(10, static_cast<int>(500 * run.effort));
        for (int k = 1; k <= samples; ++k) {
            simulation.advance_to(4.0 * k);
            const Eigen::ArrayXd energies =
                kinetic_energies(simulation.particles(), simulation.sample());
            light += energies.head(150).mean();
            heavy += energies.tail(50).mean();
        }
        return std::vector<double>{heavy / light};
    };
    return study;
}

}  // namespace

std::vector<Study> equilibria() {
    std::vector<Study> all{between_walls(2, 3), between_walls(2, 10), in_a_periodic_box(2),
                           equipartition(),     between_walls(3, 3),  in_a_periodic_box(3)};
    all[0].how =
        "Disks of radius 0.3 in a box of 4 × 3.5, spheres in one of 4 × 3.5 × 3, sampled 30,000 "
        "times in each run. In a periodic box in *d* dimensions *T* = 2*E*/*d*(*N* − 1), between "
        "walls 2*E*/*dN*.";
    return all;
}

}  // namespace carom::validation
