// Validation of collisions in a fluid: their rate, the mean free path, the momentum transferred,
// and the diffusion that follows.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "physics/mechanics.h"
#include "physics/simulation.h"
#include "stats/displacements.h"
#include "support/bodies.h"
#include "support/csv.h"
#include "support/equal_disks.h"
#include "validation/hard_fluids.h"
#include "validation/study.h"

namespace carom::validation {

namespace {

using std::numbers::pi;
constexpr const char* kinetic_theory_field = "Collisions, diffusion and relaxation";
constexpr const char* of_disks =
    "Enskog’s rate (4/√π)(*Z* − 1)√*T*, exact with the exact *Z*; D. M. Gass, J. Chem. Phys. 54, "
    "1898 (1971), *Z* of Kolafa and Rottner";
constexpr const char* of_spheres =
    "Enskog’s rate (6/√π)(*Z* − 1)√*T* = 4*nχ*√(π*T*), exact with the exact *Z*, of Kolafa, Labík "
    "and Malijevský";

/// The theoretical collision rate of each of `count` particles at T = 1.
double enskog_rate(int dimension, double packing, int count) {
    return 2.0 * dimension / std::sqrt(pi) *
           (compressibility_of(dimension, packing) - 1.0 +
            finite_number(dimension, packing, count)) *
           fixed_energy(dimension * (count - 1.0));
}

/// The mean speed at T = 1 and fixed energy: d components of d (N - 1) degrees of freedom.
double mean_speed_of(int dimension, int count) {
    const double maxwell = std::numbers::sqrt2 * std::exp(std::lgamma(0.5 * (dimension + 1.0)) -
                                                          std::lgamma(0.5 * dimension));
    return maxwell * std::sqrt(1.0 - 1.0 / count) * fixed_energy(dimension * (count - 1.0));
}

Study collision_rate(int dimension, double packing, double duration) {
    const int count = dimension == 2 ? 900 : 512;
    Study study;
    study.field = kinetic_theory_field;
    study.runs = 20;
    const std::string at = fmt::format("at packing {:.2f}", packing);
    const double rate = enskog_rate(dimension, packing, count);
    const double speed = mean_speed_of(dimension, count);
    const std::string path = dimension == 2 ? "mean free path " : "mean free path of spheres ";
    study.truths = {{"collisions of a " + body_of(dimension) + " per time " + at, rate, 0.0, 0.0,
                     dimension == 2 ? of_disks : of_spheres},
                    {path + at, speed / rate, 0.0, 0.0,
                     dimension == 2 ? "mean speed over that rate, ≈ π/(4√2 (*Z* − 1))"
                                    : "mean speed over that rate, ≈ 1/(√2 π*nχ*)"}};
    const double root_mean_square = std::sqrt(dimension * (1.0 - 1.0 / count));
    const bool has_speed = dimension == 3 && packing == 0.05;
    if (has_speed)
        study.truths.push_back({"their mean speed over the root mean square of their speeds",
                                speed / root_mean_square, 0.0, 0.0,
                                "exact: Maxwell’s √(8/3π) = 0.92132, and 1/*N*"});
    study.measure = [=](const RunOf& run) {
        Run how;  // spheres collide more often
        how.equilibrate = (20.0 + 4.0 / packing) / (dimension == 2 ? 1.0 : 2.0);
        Simulation simulation(test::equal_particles(dimension, packing, count, run.seed), how);
        const int samples = 400;
        const double time = duration * run.effort;
        double mean_speed = 0.0;
        std::int64_t collisions = 0;
        for (int k = 1; k <= samples; ++k) {
            collisions = simulation.advance_to(time * k / samples).counts.particle;
            mean_speed += speeds(simulation.sample()).mean() / samples;
        }
        const double measured = 2.0 * static_cast<double>(collisions) / (count * time);
        std::vector<double> values{measured, mean_speed / measured};
        if (has_speed) values.push_back(mean_speed / root_mean_square);
        return values;
    };
    return study;
}

/// Enskog's self-diffusion coefficient at T = 1, in the first Sonine approximation.
double enskog_diffusion(int dimension, double packing) {
    const double density = packing / content_of_ball(0.5, dimension);
    return (dimension == 2 ? 0.5 : 0.375) /
           (density * contact_value(dimension, packing) * std::sqrt(pi));
}

/// The self-diffusion coefficient from the slope of the mean squared displacement from `from` to
/// twice `from` relaxation times, in units of Enskog's D in the first Sonine approximation.
double diffusion(int dimension, double packing, int count, const RunOf& run, double from,
                 double windows) {
    const double first = enskog_diffusion(dimension, packing);
    const double relaxation = first;  // D is T / m times the relaxation time
    Run how;
    how.equilibrate = 20.0 * relaxation;
    Simulation simulation(test::equal_particles(dimension, packing, count, run.seed), how);
    simulation.record_collisions(true);
    double sum = 0.0;
    const int n = std::max(1, static_cast<int>(windows * run.effort));
    double start = 0.0;
    simulation.advance_to(0.0);
    for (int k = 0; k < n; ++k) {
        Displacements displacements(simulation.box(), start);
        displacements(simulation.sample(), {});
        std::array<double, 2> squares{};
        for (int half = 0; half < 2; ++half) {
            const auto advanced = simulation.advance_to(start + (half + 1) * from * relaxation);
            squares[static_cast<std::size_t>(half)] =
                displacements(simulation.sample(), advanced.collisions).square().sum();
        }
        sum +=
            (squares[1] - squares[0]) / (2.0 * dimension * from * relaxation * (count - 1.0) * n);
        start += 2.0 * from * relaxation;
    }
    return sum / first;
}

/// The self-diffusion at packings 0.01 and 0.02, extrapolated to 0.
auto measured_by_two(int dimension, int thin_count, int thick_count, double windows) {
    return [=](const RunOf& run) {
        const double thin = diffusion(dimension, 0.01, thin_count, run, 8.0, windows);
        const double thick =
            diffusion(dimension, 0.02, thick_count, {run.seed + 1000, run.effort}, 8.0, windows);
        return std::vector<double>{2.0 * thin - thick};
    };
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
    study.measure = measured_by_two(2, 4000, 2000, 40.0);
    return study;
}

/// The images of a periodic cube slow down what a sphere drags along, by a share of n / L to first
/// order in the density n: twice as many spheres at twice the density let that drop out.
Study dilute_diffusion_of_spheres() {
    Study study;
    study.field = kinetic_theory_field;
    study.runs = 20;
    study.how =
        "That of dilute spheres is extrapolated from packings 0.02 and 0.01 (3375 and 1728 "
        "spheres, "
        "so that the effect of the periodic cube drops out too). That of dense ones is the slope "
        "from "
        "40 to 80 relaxation times, when what a sphere drags along has come round the cube.";
    study.truths = {
        {"self-diffusion of dilute spheres, in units of the first Sonine "
         "(3/8)√(*T*/*πm*)/(*nσ*²)",
         1.019, 0.0005, 0.0,
         "S. Chapman, T. G. Cowling, The Mathematical Theory of Non-Uniform Gases: "
         "all Sonine approximations"}};
    study.measure = measured_by_two(3, 1728, 3375, 20.0);
    return study;
}

/// What the periodic images of a cube take from the D of `count` spheres of which infinitely many
/// have `unbounded`, with Enskog's viscosity.
double slowed_by_images(double packing, int count, double unbounded) {
    const double chi = contact_value(3, packing), covered = 4.0 * packing;
    const double viscosity = 1.016 * 5.0 / (16.0 * std::sqrt(pi)) *
                             (1.0 / chi + covered * (0.8 + 0.761 * covered * chi));
    const double density = 6.0 * packing / pi, side = std::cbrt(count / density);
    return 2.837297 / (6.0 * pi * (viscosity + density * unbounded) * side);
}

Study dense_diffusion(double packing) {
    constexpr int count = 1000;
    Study study;
    study.field = kinetic_theory_field;
    study.runs = 20;
    const double first = enskog_diffusion(3, packing);
    const double x = 6.0 * packing / pi / std::numbers::sqrt2;
    const double unbounded = 1.01896 * (1.0 + x * (0.05403 + x * (6.3656 - 10.9425 * x)));
    const double images = slowed_by_images(packing, count, unbounded * first) / first;
    study.truths = {
        {fmt::format("self-diffusion of 1000 spheres at packing {:.2f}, in the same units with "
                     "Enskog’s contact value",
                     packing),
         unbounded - images, std::hypot(0.005 * unbounded, 0.1 * images), 0.0,
         "J. J. Erpenbeck, W. W. Wood, Phys. Rev. A 43, 4254 (1991), less 2.837297 *T*/(6π(*η* + "
         "*mnD*)*L*) for the images of a periodic cube (mode coupling: the same, Phys. Rev. A 26, "
         "1648, 1982); errors: ½ % of their fit, and a tenth of the latter, with Enskog’s "
         "viscosity *η*"}};
    study.measure = [=](const RunOf& run) {
        return std::vector<double>{diffusion(3, packing, count, run, 40.0, 20.0)};
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
        Gas gas = test::equal_particles(2, 0.01, 4000, run.seed);
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

/// Impact parameters are uniform on the cross section: along a line or, in space, in the square of
/// their distance, in which the share is a straight line.
Study energy_transfer(int dimension) {
    Study study;
    study.field = kinetic_theory_field;
    constexpr double mass = 8.0;
    constexpr int shots = 2000;
    study.truths = {{"share of its energy that a " + body_of(dimension) +
                         " of mass 8 gives to one of mass 1 at rest, mean over impact parameters",
                     8.0 / (dimension + 1.0) * mass / ((1.0 + mass) * (1.0 + mass)), 0.0,
                     dimension == 2 ? 1e-6 : 1e-11,
                     dimension == 2 ? "exact: (2/3) 4*m*₁*m*₂/(*m*₁ + *m*₂)²"
                                    : "exact: ½ 4*m*₁*m*₂/(*m*₁ + *m*₂)²"}};
    study.measure = [=](const RunOf&) {
        const Vec center{10.0, 10.0, dimension == 2 ? 0.0 : 10.0};
        double given = 0.0;
        for (int k = 0; k < shots; ++k) {
            const double offset =
                dimension == 2 ? -1.0 + (2.0 * k + 1.0) / shots : std::sqrt((k + 0.5) / shots);
            const double angle = 2.4 * k, rise = dimension == 2 ? 0.0 : std::sin(1.7 * k);
            const Vec across{-std::sin(angle), std::cos(angle), 0.0};
            const Vec along = std::cos(rise) * Vec{across[1], -across[0], 0.0} +
                              std::sin(rise) * Vec{0.0, 0.0, 1.0};
            Simulation pair = test::simulation_of_bodies(
                test::box_of(dimension, {20.0, 20.0, 20.0}),
                {{center - 3.0 * along + offset * across, along, 0.5, 1.0 / mass}, {center}});
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
    return {collision_rate(2, 0.05, 3000.0),
            collision_rate(2, 0.3, 500.0),
            collision_rate(2, 0.6, 150.0),
            dilute_diffusion(),
            relaxation(),
            energy_transfer(2),
            collision_rate(3, 0.05, 1000.0),
            collision_rate(3, 0.25, 100.0),
            collision_rate(3, 0.45, 40.0),
            dilute_diffusion_of_spheres(),
            dense_diffusion(0.15),
            dense_diffusion(0.3),
            energy_transfer(3)};
}

}  // namespace carom::validation
