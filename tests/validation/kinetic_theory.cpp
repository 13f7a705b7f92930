// Validation of collisions in a fluid: their rate, the mean free path, the momentum transferred,
// and the diffusion that follows.
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "physics/mechanics.h"
#include "physics/simulation.h"
#include "stats/displacements.h"
#include "support/bodies.h"
#include "support/csv.h"
#include "support/equal_disks.h"
#include "validation/hard_disks.h"
#include "validation/study.h"

namespace carom::validation {

namespace {

using std::numbers::pi;
constexpr const char* kinetic_theory_field = "Collisions, diffusion and relaxation";
constexpr const char* of_enskog =
    "Enskog’s rate (4/√π)(*Z* − 1)√*T*, exact with the exact *Z*; D. M. Gass, J. Chem. Phys. 54, "
    "1898 (1971), *Z* of Kolafa and Rottner";

Gas gas_of(double packing, int count, std::uint64_t seed) {
    Gas gas = test::equal_disks(packing, count);
    gas.seed = seed;
    gas.species[0].velocity = Temperature{1.0, true};
    return gas;
}

/// The theoretical collision rate per disk, for `count` disks at T = 1.
double enskog_rate(double packing, int count) {
    return 4.0 / std::sqrt(pi) * (kolafa_rottner(packing) - 1.0 + finite_number(packing, count)) *
           fixed_energy(2.0 * count - 2.0);
}

Study collision_rate(double packing, double duration) {
    constexpr int count = 900;
    Study study;
    study.field = kinetic_theory_field;
    study.runs = 20;
    const std::string at = packing == 0.05 ? "0.05" : packing == 0.3 ? "0.30" : "0.60";
    const double rate = enskog_rate(packing, count);
    // The mean speed of a disk at fixed energy: 2 components of 2N - 2 degrees of freedom.
    const double speed =
        std::sqrt(0.5 * pi * (1.0 - 1.0 / count)) *
        std::exp(0.5 * std::log(count - 1.0) + std::lgamma(count - 1.0) - std::lgamma(count - 0.5));
    study.truths = {{"collisions of a disk per time at packing " + at, rate, 0.0, 0.0, of_enskog},
                    {"mean free path at packing " + at, speed / rate, 0.0, 0.0,
                     "mean speed over that rate, ≈ π/(4√2 (*Z* − 1))"}};
    study.measure = [=](const RunOf& run) {
        Run how;
        how.equilibrate = 20.0 + 4.0 / packing;
        Simulation simulation(gas_of(packing, count, run.seed), how);
        const int samples = 400;
        const double time = duration * run.effort;
        double mean_speed = 0.0;
        std::int64_t collisions = 0;
        for (int k = 1; k <= samples; ++k) {
            collisions = simulation.advance_to(time * k / samples).counts.particle;
            mean_speed += speeds(simulation.sample()).mean() / samples;
        }
        const double measured = 2.0 * static_cast<double>(collisions) / (count * time);
        return std::vector<double>{measured, mean_speed / measured};
    };
    return study;
}

/// The self-diffusion coefficient from the slope of the mean squared displacement between 8 and 16
/// relaxation times, in units of Enskog's D in the first Sonine approximation.
double diffusion(double packing, int count, std::uint64_t seed, double windows) {
    const double density = 4.0 * packing / pi;
    const double contact = (1.0 - 7.0 / 16.0 * packing) / ((1.0 - packing) * (1.0 - packing));
    const double first = 1.0 / (2.0 * density * contact * std::sqrt(pi));
    const double relaxation = first;  // D is T / m times the relaxation time
    Run how;
    how.equilibrate = 20.0 * relaxation;
    Simulation simulation(gas_of(packing, count, seed), how);
    simulation.record_collisions(true);
    double sum = 0.0;
    const int n = std::max(1, static_cast<int>(windows));
    double start = 0.0;
    simulation.advance_to(0.0);
    for (int k = 0; k < n; ++k) {
        Displacements displacements(simulation.box(), start);
        displacements(simulation.sample(), {});
        std::array<double, 2> squares{};
        for (int half = 0; half < 2; ++half) {
            const auto advanced = simulation.advance_to(start + (half + 1) * 8.0 * relaxation);
            squares[static_cast<std::size_t>(half)] =
                displacements(simulation.sample(), advanced.collisions).square().sum();
        }
        sum += (squares[1] - squares[0]) / (4.0 * 8.0 * relaxation * (count - 1.0) * n);
        start += 16.0 * relaxation;
    }
    return sum / first;
}

Study dilute_diffusion() {
    Study study;
    study.field = kinetic_theory_field;
    study.runs = 20;
    study.how =
        "The self-diffusion of disks has no limit of long times (its velocity correlation falls "
        "off as 1/*t*), and corrections of order packing. *D* is the slope of the mean squared "
        "displacement from 8 to 16 relaxation times, extrapolated from packings 0.02 and 0.01 "
        "(2000 "
        "and 4000 disks, boxes of as many mean free paths) to 0. There the Boltzmann equation "
        "holds: Gass’s *D* is its first Sonine approximation; the second, third and fourth are "
        "larger by "
        "factors of 1.0237, 1.0263 and 1.0268 (bracket integrals by quadrature), which tend to "
        "1.0270(2).";
    study.truths = {
        {"self-diffusion of dilute disks, in units of Gass’s (first Sonine) "
         "√(*T*/*πm*)/(2*nσ*)",
         1.0270, 0.0002, 0.0,
         "D. M. Gass, J. Chem. Phys. 54, 1898 (1971), with the higher Sonine "
         "approximations"}};
    study.measure = [=](const RunOf& run) {
        const double thin = diffusion(0.01, 4000, run.seed, 40.0 * run.effort);
        const double thick = diffusion(0.02, 2000, run.seed + 1000, 40.0 * run.effort);
        return std::vector<double>{2.0 * thin - thick};
    };
    return study;
}

/// a2 = <v^4> / (2 <v^2>^2) - 1 after c collisions per disk, in a gas that starts with equal
/// speeds.
Study relaxation() {
    Study study;
    study.field = kinetic_theory_field;
    study.runs = 40;
    study.how =
        "The gases of equal speeds have 4000 disks at packing 0.01; *a*₂ at the number of "
        "collisions that a run has reached is brought to that of the table by its slope.";
    const auto rows = test::reference_rows("relaxation_equal_speeds.csv");
    const std::array<std::size_t, 3> chosen{2, 4, 11};
    std::vector<std::array<double, 3>> known;  // c, a2, its slope
    for (const std::size_t k : chosen) {
        const auto at = [&](std::size_t row, std::size_t column) {
            return std::stod(rows[row][column]);
        };
        known.push_back(
            {at(k, 0), at(k, 1), (at(k + 1, 1) - at(k - 1, 1)) / (at(k + 1, 0) - at(k - 1, 0))});
        study.truths.push_back({"*a*₂ = ⟨*v*⁴⟩/2⟨*v*²⟩² − 1 after " + rows[k][0].substr(0, 4) +
                                    " collisions of each disk, from equal speeds",
                                at(k, 1), 1e-3, 0.0,
                                "direct simulation Monte Carlo of the Boltzmann equation, "
                                "`tests/reference/relaxation_equal_speeds.csv`"});
    }
    study.measure = [known](const RunOf& run) {
        Gas gas = gas_of(0.01, 4000, run.seed);
        gas.species[0].velocity = Speed{1.0};
        gas.species[0].position = RandomPlaces{};
        Simulation simulation(gas, {});
        std::vector<double> values;
        double time = 0.0;
        for (const auto& [c, a2, slope] : known) {
            double reached = 0.0;
            while (reached < c)
                reached = 2.0 *
                          static_cast<double>(simulation.advance_to(time += 0.25).counts.particle) /
                          4000.0;
            const Eigen::ArrayXd square = speeds(simulation.sample()).square();
            const double now = square.square().mean() / (2.0 * square.mean() * square.mean()) - 1.0;
            values.push_back(now - slope * (reached - c));
        }
        return values;
    };
    return study;
}

Study energy_transfer() {
    Study study;
    study.field = kinetic_theory_field;
    constexpr double mass = 8.0;
    constexpr int shots = 2000;
    study.truths = {
        {"share of its energy that a disk of mass 8 gives to one of mass 1 at rest, "
         "mean over impact parameters",
         8.0 / 3.0 * mass / ((1.0 + mass) * (1.0 + mass)), 0.0, 1e-6,
         "exact: (2/3) 4*m*₁*m*₂/(*m*₁ + *m*₂)²"}};
    study.measure = [=](const RunOf&) {
        double given = 0.0;
        for (int k = 0; k < shots; ++k) {
            const double offset = -1.0 + (2.0 * k + 1.0) / shots;
            const double angle = 2.4 * k, nx = std::cos(angle), ny = std::sin(angle);
            Simulation pair = test::simulation_of(
                Box{2, {20.0, 20.0}, {}}, {{10.0 - 3.0 * nx - offset * ny,
                                            10.0 - 3.0 * ny + offset * nx, nx, ny, 0.5, 1.0 / mass},
                                           {10.0, 10.0, 0.0, 0.0}});
            pair.advance_to(3.1);
            const Eigen::ArrayXd energies = kinetic_energies(pair.particles(), pair.sample());
            given += energies[1] / energies.sum() / shots;
        }
        return std::vector<double>{given};
    };
    return study;
}

}  // namespace

std::vector<Study> kinetic_theory() {
    return {collision_rate(0.05, 3000.0),
            collision_rate(0.3, 500.0),
            collision_rate(0.6, 150.0),
            dilute_diffusion(),
            relaxation(),
            energy_transfer()};
}

}  // namespace carom::validation
