// Validation of gases under gravity.
#include <cmath>
#include <string>
#include <vector>

#include "physics/gas.h"
#include "physics/mechanics.h"
#include "physics/simulation.h"
#include "support/bodies.h"
#include "support/space.h"
#include "validation/study.h"

namespace carom::validation {

namespace {

constexpr const char* gravity_field = "Gravity";

/// The mean of a power k of the height of one of N particles of the energy E at m g = 1 between
/// walls, to first order in their excluded content over the width or area of the column. Points
/// have (1 - z / E)^(m - 2) with m = (d / 2 + 1) N (Roman, White and Velasco). Two that cannot
/// overlap are less often at the same height. In the Laplace transform of the density of states,
/// beta^-m of points, the integral k! / beta^(k + 1) over one height, and 1 / beta over another,
/// give way to k! / (2 beta)^(k + 1) of this pair; the others lose half a power of beta.
double moment_of_height(int dimension, double count, double energy, int power, double excluded) {
    const double m = (0.5 * dimension + 1.0) * count, own = count - 1.0,
                 others = 0.5 * own * (count - 2.0);
    const auto states = [&](double exponent) {
        return std::exp((exponent - 1.0) * std::log(energy) - std::lgamma(exponent));
    };
    const double norm = states(m) - 0.5 * excluded * (own + others) * states(m - 1.0);
    const double sum = states(m + power) - excluded *
                                               (own * std::pow(0.5, power + 1.0) + 0.5 * others) *
                                               states(m - 1.0 + power);
    return std::tgamma(power + 1.0) * sum / norm;
}

/// N disks or spheres in a box without a lid, which are not points.
Study column(int dimension) {
    constexpr int count = 6;
    constexpr double speed = 1.5;
    const double radius = dimension == 2 ? 0.004 : 0.03;
    Study study;
    study.field = gravity_field;
    study.runs = 24;
    if (dimension == 2)
        study.how =
            "Of the columns *E* is *mg* times the mean height of a run’s start and its kinetic "
            "energy; heights are in units of the exact values at this *E*. The disks (radius 0.004 "
            "in a width of 1) and spheres (0.03 in 1 × 1) cannot overlap, which raises the mean "
            "height by 0.02 and 0.1 %, to first order, and is included.";
    const char* source = dimension == 2
                             ? "F. L. Román, J. A. White, S. Velasco, Eur. J. Phys. 16, 83 (1995): "
                               "*p*(*z*) ∝ (1 − *mgz*/*E*)^(2*N* − 2)"
                             : "the same with 3*N* degrees of freedom: *p*(*z*) ∝ (1 − "
                               "*mgz*/*E*)^(5*N*/2 − 2)";
    const std::string body = dimension == 2 ? "disks" : "spheres";
    study.truths = {
        {"mean height of 6 " + body + " without a lid", 1.0, 0.0, 0.0, source},
        {"mean square height of 6 " + body + " without a lid", 1.0, 0.0, 0.0, source},
        {std::string("mean kinetic energy at heights of (0.1 to 0.3) *E*/*mg*, over (*E* − ") +
             (dimension == 2 ? "*mgz*)/(2*N* − 1)" : "*mgz*)·(3/2)/(5*N*/2 − 1)"),
         1.0, 0.0, 0.0, source}};
    study.measure = [=](const RunOf& run) {
        Gas gas;
        gas.seed = run.seed;
        gas.box = test::box_of(dimension, {1.0 + 2.0 * radius, 60.0, 1.0 + 2.0 * radius});
        gas.box.surfaces.gravity = {0.0, -1.0};
        gas.species = {{.name = "",
                        .count = count,
                        .radius = radius,
                        .velocity = Speed{speed},
                        .position = WithinRegion{{{}, {1.0, 1.0, dimension == 2 ? 0.0 : 1.0}}}}};
        Run how;
        how.equilibrate = 300.0;
        Simulation simulation(gas, how);
        const double energy = simulation.energy_account().in_all();
        const int samples = std::max(10, static_cast<int>(20'000 * run.effort));
        double height = 0.0, squares = 0.0, kinetic = 0.0, expected = 0.0;
        for (int k = 1; k <= samples; ++k) {
            simulation.advance_to(4.3 * k);
            const Sample& now = simulation.sample();
            for (Eigen::Index i = 0; i < count; ++i) {
                const double z = now.position(i, 1) - radius;
                height += z / (count * samples);
                squares += z * z / (count * samples);
                if (z < 0.1 * energy || z > 0.3 * energy) continue;
                kinetic += 0.5 * now.velocity.row(i).square().sum();
                expected +=
                    (energy - z) * 0.5 * dimension / ((0.5 * dimension + 1.0) * count - 1.0);
            }
        }
        const double excluded = content_of_ball(2.0 * radius, dimension);
        return std::vector<double>{
            height / moment_of_height(dimension, count, energy, 1, excluded),
            squares / moment_of_height(dimension, count, energy, 2, excluded), kinetic / expected};
    };
    return study;
}

Study bouncing() {
    Study study;
    study.field = gravity_field;
    study.truths = {{"time of 1000 bounces from height 2 at *g* = 1, over 2√(2*h*/*g*)", 1000.0,
                     0.0, 1e-12, "exact"},
                    {"height after 1000 bounces", 2.0, 0.0, 4e-13, "exact"}};
    study.measure = [=](const RunOf&) {
        Box box{.dimension = 2, .size = {4.0, 20.0}};
        box.surfaces.gravity = {0.0, -1.0};
        Simulation simulation = test::simulation_of(box, {{2.0, 2.5, 0.0, 0.0}});
        simulation.record_collisions(true);
        // A period is the time from top to top; bounce k occurs half a period after k - 1 periods.
        const AdvanceResult advanced = simulation.advance_to(4.0 * 1000.0);
        const double last = advanced.collisions.back().time, first = advanced.collisions[0].time;
        const auto gaps = static_cast<double>(advanced.collisions.size() - 1);
        return std::vector<double>{1000.0 * (last - first) / gaps / 4.0,
                                   simulation.sample().position(0, 1) - 0.5};
    };
    return study;
}

}  // namespace

std::vector<Study> gravity() { return {column(2), bouncing(), column(3)}; }

}  // namespace carom::validation
