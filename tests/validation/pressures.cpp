// Validation of the pressure of equal hard disks, measured from the momentum that they exchange.
#include <cmath>
#include <numbers>
#include <vector>

#include "physics/simulation.h"
#include "support/bodies.h"
#include "support/equal_disks.h"
#include "validation/hard_disks.h"
#include "validation/study.h"

namespace carom::validation {

namespace {

using std::numbers::pi;
constexpr const char* pressures_field = "Pressure of hard disks";

/// Disks on a triangular lattice of 29 by 30, in a periodic box of 29 : 30 sqrt(3) / 2.
Gas gas_of_li(double packing, std::uint64_t seed) {
    const double spacing = std::sqrt(pi / (2.0 * std::sqrt(3.0) * packing));
    Gas gas;
    gas.seed = seed;
    gas.box.size = {29.0 * spacing, 15.0 * std::sqrt(3.0) * spacing};
    gas.box.walls = {Wall::periodic, Wall::periodic};
    Places places;
    for (int row = 0; row < 30; ++row)
        for (int k = 0; k < 29; ++k)
            places.values.push_back({(k + 0.25 + 0.5 * (row % 2)) * spacing,
                                     (row + 0.5) * 0.5 * std::sqrt(3.0) * spacing});
    gas.species = {
        {.name = "", .count = 870, .velocity = Temperature{1.0, true}, .position = places}};
    return gas;
}

/// P A / (N T) of a run whose centre of mass is at rest: there are 2N - 2 degrees of freedom.
double compressibility(Simulation& simulation, double duration) {
    const double count = static_cast<double>(simulation.particles().count());
    const double temperature =
        kinetic_energies(simulation.particles(), simulation.sample()).sum() / (count - 1.0);
    const double virial = simulation.advance_to(duration).impulses.virial;
    return 1.0 + virial / (2.0 * count * temperature * duration);
}

Study li(double packing, double value, double error, int runs, double duration) {
    Study study;
    study.field = pressures_field;
    study.runs = runs;
    study.truths = {{"*P*(2*R*)²/*T* of 870 disks at packing " +
                         std::string(packing == 0.7 ? "0.700" : "0.670") + ", box 29 : 30√3/2",
                     value, error, 0.0,
                     "B. Li et al., J. Chem. Phys. 157, 234111 (2022), data at "
                     "github.com/jellyfysh/HistoricDisks"}};
    study.measure = [=](const RunOf& run) {
        Run how;
        how.equilibrate = 0.1 * duration * run.effort;
        Simulation simulation(gas_of_li(packing, run.seed), how);
        return std::vector<double>{4.0 * packing / pi *
                                   compressibility(simulation, duration * run.effort)};
    };
    return study;
}

Study equation(const char* name, double packing, double value, double error, const char* source,
               double duration) {
    constexpr int count = 900;
    Study study;
    study.field = pressures_field;
    study.runs = 20;
    study.truths = {{std::string("*Z* = *PA*/*NT* ") + name, value + finite_number(packing, count),
                     error, 0.0, source}};
    study.measure = [=](const RunOf& run) {
        Gas gas = test::equal_disks(packing, count);
        gas.seed = run.seed;
        gas.species[0].velocity = Temperature{1.0, true};
        Run how;
        how.equilibrate = 20.0 + 4.0 / packing;
        Simulation simulation(gas, how);
        return std::vector<double>{compressibility(simulation, duration * run.effort)};
    };
    return study;
}

constexpr const char* of_kolafa =
    "J. Kolafa, M. Rottner, Mol. Phys. 104, 3435 (2006), equation (7), and 1/*N*";
constexpr const char* of_henderson =
    "D. Henderson, Mol. Phys. 30, 971 (1975), and 1/*N*; its error: how far it is from Kolafa and "
    "Rottner’s";

Study by_henderson(const char* name, double packing, double duration) {
    const double value = henderson(packing);
    return equation(name, packing, value, std::abs(value - kolafa_rottner(packing)), of_henderson,
                    duration);
}

/// Two disks between walls: the configuration integral Q (the area of allowed pairs of places) is
/// known, and thus also the force on a wall, E/2 d ln Q / da.
Study two_disks() {
    constexpr double a = 2.0, b = 1.5;
    Study study;
    study.field = pressures_field;
    study.runs = 20;
    const double q = a * a * b * b - excluded(a, b, 1.0);
    const double slope = 2.0 * a * b * b - pi * b + 4.0 / 3.0;
    study.truths = {{"force of two disks of diameter 1 and energy 2 on a side of a box of 3 × 2.5",
                     slope / q, 0.0, 0.0,
                     "exact: (*E*/2) d ln *Q*/d*a* with *Q* = *a*²*b*² − π*ab* + (4/3)(*a* + *b*) "
                     "− ½, *a* = 2, *b* = 1.5"}};
    study.measure = [=](const RunOf& run) {
        Gas gas;
        gas.seed = run.seed;
        gas.box.size = {a + 1.0, b + 1.0};
        gas.species = {{.name = "", .count = 2, .velocity = Speed{std::numbers::sqrt2}}};
        Simulation simulation(gas, {});
        const double time = 100'000.0 * run.effort;
        return std::vector<double>{simulation.advance_to(time).impulses.wall[1] / time};
    };
    return study;
}

}  // namespace

std::vector<Study> pressures() {
    std::vector<Study> all{li(0.70, 9.12956, 0.00017, 20, 3000.0),
                           li(0.67, 7.986735, 0.000026, 20, 2000.0)};
    // The number of disks is fixed: the correction of about 0.1 % exceeds the errors.
    all.push_back(equation("at packing 0.10", 0.1, virial_series(0.1), 0.0,
                           "virial coefficients to *B*₁₀: N. Clisby, B. M. McCoy, J. Stat. Phys. "
                           "122, 15 (2006), and 1/*N*",
                           3000.0));
    all.push_back(by_henderson("at packing 0.05", 0.05, 4000.0));
    all.push_back(by_henderson("at packing 0.30", 0.3, 600.0));
    all.push_back(equation("at packing 0.20", 0.2, kolafa_rottner(0.2), 0.0, of_kolafa, 1200.0));
    all.push_back(equation("at packing 0.40", 0.4, kolafa_rottner(0.4), 0.0, of_kolafa, 500.0));
    all.push_back(equation("at packing 0.50", 0.5, kolafa_rottner(0.5), 0.0, of_kolafa, 400.0));
    all.push_back(equation("at packing 0.60", 0.6, kolafa_rottner(0.6), 0.0, of_kolafa, 400.0));
    all[0].how =
        "Li et al. have the pressure by event-chain Monte Carlo of the same 870 disks in the same "
        "periodic box, at 0.700 where fluid and solid take turns. No correction is needed: the "
        "virial of collisions has the mean of Monte Carlo if *T* = *E*/(*N* − 1), the centre of "
        "mass at rest. Each run begins as a lattice and melts for a tenth of its time; runs of "
        "3,000 and 2,000 units of time (a diameter times √(*m*/*T*)), 20 seeds.";
    all[2].how =
        "Kolafa and Rottner’s, Henderson’s and the virial series are of infinitely many disks. 900 "
        "disks in a periodic box press differently by *ρ*/2*N* · d ln *χ*/d*ρ*, *χ* = "
        "d*ρ*/d(*P*/*T*) (J. L. Lebowitz, J. K. Percus, Phys. Rev. 122, 1675, 1961), which is "
        "included. Henderson’s equation is an approximation; how far it is from Kolafa and "
        "Rottner’s stands as its error.";
    all.push_back(two_disks());
    return all;
}

}  // namespace carom::validation
