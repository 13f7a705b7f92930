// Validation of gases behind partitions that are then removed or opened.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "physics/gas.h"
#include "physics/mechanics.h"
#include "physics/simulation.h"
#include "validation/study.h"

namespace carom::validation {

namespace {

constexpr const char* partitions_field = "Partitions and mixing";

Species points(const char* name, int count, double mass, Region within) {
    return {.name = name,
            .count = count,
            .radius = 0.0,
            .mass = ValueRule{mass},
            .velocity = Temperature{1.0},
            .position = WithinRegion{within}};
}

Study window() {
    constexpr double left = 3.0, size = 10.0, share = left / size;
    constexpr int count = 20;
    Study study;
    study.field = partitions_field;
    study.runs = 24;
    study.how =
        "Points of two species begin on either side of a window; baths at both ends let each of "
        "them forget its velocity.";
    study.truths = {{"mean number of 20 light points in a part of 0.3 beside a window",
                     count * share, 0.0, 0.0, "exact: binomial"},
                    {"its variance", count * share * (1.0 - share), 0.0, 0.0, "exact: binomial"},
                    {"mean number of 20 heavy points there: equal partial densities", count * share,
                     0.0, 0.0, "exact: binomial"},
                    {"mean energy of a light point there", 1.0, 0.0, 0.0, "exact: *T* = 1"},
                    {"mean energy of a heavy point there: equal temperatures", 1.0, 0.0, 0.0,
                     "exact: *T* = 1"}};
    study.measure = [=](const RunOf& run) {
        Gas gas;
        gas.seed = run.seed;
        gas.box.size = {size, 4.0};
        gas.box.surfaces.sides = {Bath{1.0}, Bath{1.0}, Reflecting{}, Reflecting{}};
        gas.box.surfaces.partitions = {
            {.name = "window", .axis = 0, .at = left, .gaps = {{1.0, 3.0}}}};
        gas.species = {points("light", count, 0.5, {{0.0, 0.0}, {left, 4.0}}),
                       points("heavy", count, 4.0, {{left, 0.0}, {size, 4.0}})};
        Run how;
        how.equilibrate = 500.0;
        Simulation simulation(gas, how);
        const int samples = std::max(10, static_cast<int>(1800 * run.effort));
        double mean[2] = {}, variance[2] = {}, energy[2] = {}, inside[2] = {};
        for (int k = 1; k <= samples; ++k) {
            simulation.advance_to(20.0 * k);
            const Sample& now = simulation.sample();
            const Eigen::ArrayXd energies = kinetic_energies(simulation.particles(), now);
            double numbers[2] = {};
            for (Eigen::Index i = 0; i < 2 * count; ++i) {
                if (now.position(i, 0) >= left) continue;
                const int s = simulation.particles().species[i];
                numbers[s] += 1.0;
                energy[s] += energies[i];
            }
            for (int s = 0; s < 2; ++s) {
                mean[s] += numbers[s] / samples;
                variance[s] += std::pow(numbers[s] - count * share, 2) / samples;
                inside[s] += numbers[s];
            }
        }
        return std::vector<double>{mean[0], variance[0], mean[1], energy[0] / inside[0],
                                   energy[1] / inside[1]};
    };
    return study;
}

/// The entropy per particle of the distribution of x over parts of equal size.
double entropy(const Sample& sample, double size, int parts) {
    Eigen::ArrayXd numbers = Eigen::ArrayXd::Zero(parts);
    for (const double x : sample.position.col(0))
        numbers[std::min(static_cast<Eigen::Index>(x * parts / size), Eigen::Index{parts - 1})] +=
            1.0;
    double sum = 0.0;
    for (const double n : numbers)
        if (n > 0.0) sum -= n * std::log(n / static_cast<double>(sample.position.rows()));
    return sum;
}

Study free_expansion() {
    constexpr int count = 4000, parts = 10;
    Study study;
    study.field = partitions_field;
    study.runs = 60;
    study.how =
        "The entropy of places by their numbers in 10 parts of a box is less than *N* ln *k* by "
        "half a chi-squared number of *k* − 1 degrees where *k* parts are filled: (9 − 4)/2 in "
        "all, "
        "which is included.";
    study.truths = {{"growth of the entropy of 4000 points in a free expansion to twice the room, "
                     "for each",
                     std::numbers::ln2 - 2.5 / count, 0.0, 0.0,
                     "exact: ln(*V*₁/*V*₀), and the bias of 10 cells"},
                    {"temperature after over that before", 1.0, 0.0, 1e-12, "exact"}};
    study.measure = [=](const RunOf& run) {
        Gas gas;
        gas.seed = run.seed;
        gas.box.size = {20.0, 10.0};
        gas.box.surfaces.partitions = {{.name = "divider", .axis = 0, .at = 10.0}};
        gas.species = {points("points", count, 1.0, {{0.0, 0.0}, {10.0, 10.0}})};
        Run how;
        how.events = {{1.0, SetOpen{Surfaces{}.first_partition(), true}}};
        Simulation simulation(gas, how);
        simulation.advance_to(1.0);
        const double before = entropy(simulation.sample(), 20.0, parts);
        const double energy = simulation.energy_account().kinetic;
        simulation.advance_to(60.0);
        return std::vector<double>{(entropy(simulation.sample(), 20.0, parts) - before) / count,
                                   simulation.energy_account().kinetic / energy};
    };
    return study;
}

Study and_back() {
    constexpr int count = 60;
    Study study;
    study.field = partitions_field;
    study.truths = {
        {"of 60 disks that expanded and were reversed (2048 bits), those back behind the divider",
         count, 0.0, 1e-12, "exact: mechanics is reversible"}};
    study.measure = [=](const RunOf&) {
        Gas gas;
        gas.box.size = {20.0, 10.0};
        gas.box.surfaces.partitions = {{.name = "divider", .axis = 0, .at = 10.0}};
        gas.species = {{.name = "disks",
                        .count = count,
                        .radius = 0.3,
                        .velocity = Temperature{1.0},
                        .position = WithinRegion{{{0.0, 0.0}, {10.0, 10.0}}}}};
        Run how;
        how.bits = 2048;
        how.events = {{1.0, SetOpen{Surfaces{}.first_partition(), true}},
                      {60.0, ReverseVelocities{}}};
        Simulation simulation(gas, how);
        simulation.advance_to(119.5);  // reversed in time, the divider is back since 119
        return std::vector<double>{
            static_cast<double>((simulation.sample().position.col(0) < 10.0).count())};
    };
    return study;
}

}  // namespace

std::vector<Study> partitions() { return {window(), free_expansion(), and_back()}; }

}  // namespace carom::validation
