// Validation of gases under gravity.
#include <cmath>
#include <numbers>
#include <vector>

#include "physics/gas.h"
#include "physics/mechanics.h"
#include "physics/simulation.h"
#include "support/bodies.h"
#include "validation/study.h"

namespace carom::validation {

namespace {

constexpr const char* gravity_field = "Gravity";

/// N disks in a box without a lid. The law of Roman, White and Velasco holds for points. Disks of
/// radius r cannot overlap, which to first order raises the mean height by e / 4N, where
/// e = N (N - 1) / 2 times the area pi (2r)^2 over the width.
Study column() {
    constexpr int count = 6;
    constexpr double radius = 0.004, speed = 1.5;
    Study study;
    study.field = gravity_field;
    study.runs = 24;
    study.how =
        "Of the column *E* is *mg* times the mean height of a run’s start and its kinetic energy; "
        "rows are in units of the exact values at this *E*. The disks (radius 0.004 in a width of "
        "1) cannot overlap, which raises the mean height by *N*(*N* − 1)/2 · 4π*r*²/(4*NW*), 0.02 "
        "%, and is included.";
    const char* source =
        "F. L. Román, J. A. White, S. Velasco, Eur. J. Phys. 16, 83 (1995): *p*(*z*) ∝ (1 − "
        "*mgz*/*E*)^(2*N* − 2)";
    study.truths = {
        {"mean height of 6 disks without a lid, over *E*/(2*Nmg*)", 1.0, 0.0, 0.0, source},
        {"their mean square height, over 2(*E*/*mg*)²/(2*N*(2*N* + 1))", 1.0, 0.0, 0.0, source},
        {"mean kinetic energy at heights of (0.1 to 0.3) *E*/*mg*, over (*E* − "
         "*mgz*)/(2*N* − 1)",
         1.0, 0.0, 0.0, source}};
    study.measure = [=](const RunOf& run) {
        Gas gas;
        gas.seed = run.seed;
        gas.box.size = {1.0 + 2.0 * radius, 60.0};
        gas.box.surfaces.gravity = {0.0, -1.0};
        gas.species = {{.name = "",
                        .count = count,
                        .radius = radius,
                        .velocity = Speed{speed},
                        .position = WithinRegion{{{0.0, 0.0}, {1.0, 1.0}}}}};
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
                expected += (energy - z) / (2.0 * count - 1.0);
            }
        }
        const double overlap =
            0.5 * count * (count - 1.0) * 4.0 * std::numbers::pi * radius * radius;
        const double mean = energy / (2.0 * count) + overlap / (4.0 * count);
        return std::vector<double>{
            height / mean, squares / (2.0 * energy * energy / (2.0 * count * (2.0 * count + 1.0))),
            kinetic / expected};
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

std::vector<Study> gravity() { return {column(), bouncing()}; }

}  // namespace carom::validation
