// Gases with walls that act, obstacles and gravity against what is known of them. Each bound on a
// mean is five standard errors of blocks of the same run: chance fails one in two million.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "physics/gas.h"
#include "physics/simulation.h"
#include "support/blocks.h"
#include "support/goodness_of_fit.h"

using namespace carom;

namespace {

constexpr int blocks = 40;

void check_mean_of_blocks(const std::vector<double>& values, double expected) {
    test::check_mean(values, expected, 0.03);
}

Species points(const char* name, std::int64_t count, double mass, Region within) {
    return {.name = name,
            .count = count,
            .radius = 0.0,
            .mass = mass,
            .velocity = Temperature{1.0},
            .position = WithinRegion{within}};
}

}  // namespace

// Roman, White and Velasco (1995), for particles that are small.
TEST_CASE("in a lidless box a gas of N has the density and the energies of its height") {
    constexpr int count = 6;
    Gas gas;
    gas.box.size = {1.0, 40.0};
    gas.box.surfaces.gravity = {0.0, -1.0};
    gas.species = {{.name = "disks",
                    .count = count,
                    .radius = 0.004,
                    .velocity = Speed{1.0},
                    .position = WithinRegion{{{0.0, 0.0}, {1.0, 1.0}}}}};
    Simulation simulation(gas, {});
    const double energy = simulation.energy_account().in_all();
    REQUIRE(energy < 30.0);  // none reaches the lid
    std::vector<double> heights, squares, kinetic;
    double time = 0.0;
    for (int block = 0; block < blocks; ++block) {
        double height = 0.0, square = 0.0, excess = 0.0;
        constexpr int samples = 600;
        for (int k = 0; k < samples; ++k) {
            simulation.advance_to(time += 5.3);
            const Sample& now = simulation.sample();
            for (Eigen::Index i = 0; i < count; ++i) {
                const double z = now.position(i, 1) - 0.004;
                height += z / (count * samples);
                square += z * z / (count * samples);
                // Weighted by the height: the energy must be right high and low.
                excess += z * 0.5 * now.velocity.row(i).square().sum() / (count * samples);
            }
        }
        heights.push_back(height);
        squares.push_back(square);
        kinetic.push_back(excess);
    }
    // Of p(z) ~ (1 - z/E)^(2N - 2), and of z (E - z) / (2N - 1).
    const double mean = energy / (2.0 * count);
    const double mean_square = 2.0 * energy * energy / (2.0 * count * (2.0 * count + 1.0));
    check_mean_of_blocks(heights, mean);
    check_mean_of_blocks(squares, mean_square);
    check_mean_of_blocks(kinetic, (energy * mean - mean_square) / (2.0 * count - 1.0));
}

TEST_CASE("through a gap effuse n a sqrt(T / 2 pi m), of energy 1.5 T, at angles of cos / 2") {
    constexpr double size = 10.0, gap = 1.0, mass = 2.0, temperature = 1.0;
    constexpr int count = 40;
    Gas gas;
    gas.box.size = {size + 1.0, size};
    gas.box.surfaces.sides[0] = Bath{temperature};
    // What comes through is counted by a bath just behind, which sends back what is alike.
    gas.box.surfaces.partitions = {
        {.name = "gap", .axis = 0, .at = size, .gaps = {{4.0, 4.0 + gap}}},
        {.name = "counter", .axis = 0, .at = size + 1e-6, .behaviour = Bath{temperature}}};
    gas.species = {points("points", count, mass, {{0.0, 0.0}, {size, size}})};
    Simulation simulation(gas, {});
    simulation.record_collisions(true);
    std::vector<double> rates, energies, sines;
    for (int block = 1; block <= blocks; ++block) {
        constexpr double time = 1500.0;
        double energy = 0.0, hits = 0.0;
        for (const Collision& hit : simulation.advance_to(time * block).collisions) {
            if (hit.second.surface() != Surfaces{}.first_partition() + 1) continue;
            const Vec& v = hit.first_before;
            energy += 0.5 * mass * square(v);
            sines.push_back(v[1] / length(v));
            hits += 1.0;
        }
        rates.push_back(hits / time);
        energies.push_back(energy / hits);
    }
    const double density = count / (size * size);
    check_mean_of_blocks(rates,
                         density * gap * std::sqrt(temperature / (2.0 * std::numbers::pi * mass)));
    check_mean_of_blocks(energies, 1.5 * temperature);
    CHECK(test::chance(sines, [](double s) { return 0.5 * (1.0 + s); }) > 1e-6);
}

TEST_CASE("points of two species that begin on two sides of a window mix evenly, as coins fall") {
    constexpr double left = 3.0, size = 10.0;
    constexpr int count = 20;
    Gas gas;
    gas.box.size = {size, 4.0};
    gas.box.surfaces.sides = {Bath{1.0}, Bath{1.0}, Reflecting{}, Reflecting{}};
    gas.box.surfaces.partitions = {{.name = "window", .axis = 0, .at = left, .gaps = {{1.0, 3.0}}}};
    gas.species = {points("light", count, 0.5, {{0.0, 0.0}, {left, 4.0}}),
                   points("heavy", count, 4.0, {{left, 0.0}, {size, 4.0}})};
    Run run;
    run.equilibrate = 500.0;
    Simulation simulation(gas, run);
    const double share = left / size;
    std::vector<double> means[2], variances[2], temperatures[2];
    double time = 0.0;
    for (int block = 0; block < blocks; ++block) {
        double sums[2] = {}, squares[2] = {}, energies[2] = {};
        constexpr int samples = 50;
        for (int k = 0; k < samples; ++k) {
            simulation.advance_to(time += 40.0);
            const Sample& now = simulation.sample();
            int inside[2] = {};
            for (Eigen::Index i = 0; i < 2 * count; ++i) {
                const auto species = simulation.particles().species[i];
                inside[species] += now.position(i, 0) < left ? 1 : 0;
                energies[species] += 0.5 * now.velocity.row(i).square().sum() /
                                     simulation.particles().inverse_mass[i] / (count * samples);
            }
            for (int s = 0; s < 2; ++s) {
                sums[s] += inside[s] / double{samples};
                squares[s] += std::pow(inside[s] - count * share, 2) / samples;
            }
        }
        for (int s = 0; s < 2; ++s) {
            means[s].push_back(sums[s]);
            variances[s].push_back(squares[s]);
            temperatures[s].push_back(energies[s]);
        }
    }
    for (int s = 0; s < 2; ++s) {
        check_mean_of_blocks(means[s], count * share);
        check_mean_of_blocks(variances[s], count * share * (1.0 - share));
        check_mean_of_blocks(temperatures[s], 1.0);
    }
}

// One value from each seed; the wall is a hundred times slower than the particles.
TEST_CASE("a slow piston keeps T V in a plane, and T L^2 on a line") {
    for (const int dimension : {1, 2}) {
        CAPTURE(dimension);
        std::vector<double> kept;
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            Gas gas;
            gas.seed = seed;
            gas.box.dimension = dimension;
            gas.box.size = {10.0, dimension == 1 ? 0.0 : 10.0};
            gas.box.surfaces.sides[1] = Driven{-0.01, 500.0};
            gas.species = {{.name = "gas",
                            .count = dimension == 1 ? 20 : 50,
                            .radius = dimension == 1 ? 0.0 : 0.03,
                            .velocity = Temperature{1.0}}};
            Simulation simulation(gas, {});
            const double before = simulation.energy_account().kinetic;
            simulation.advance_to(500.0);
            kept.push_back(simulation.energy_account().kinetic / before /
                           (dimension == 1 ? 4.0 : 2.0));
        }
        // Disks have less room than points: 0.06 less from wall to wall, and N pi r^2 / 2 of each
        // other's, here 0.28.
        const double room = dimension == 1 ? 1.0 : 9.94 / 4.94 / 2.0 * (1.0 + 0.28 / 100.0);
        check_mean_of_blocks(kept, room);
    }
}

// The entropy of places, by their numbers n in parts of equal size: -sum of n ln(n / N). Where the
// gas is uniform in k of them, it is N ln k less half a chi-squared number of k - 1: five standard
// deviations and the mean of that.
TEST_CASE("the entropy of a free expansion grows by N ln(V1 / V0), and the temperature stays") {
    constexpr int count = 4000, parts = 10;
    Gas gas;
    gas.box.size = {20.0, 10.0};
    gas.box.surfaces.partitions = {{.name = "divider", .axis = 0, .at = 10.0}};
    gas.species = {points("points", count, 1.0, {{0.0, 0.0}, {10.0, 10.0}})};
    Run run;
    run.events = {{1.0, SetOpen{Surfaces{}.first_partition(), true}}};
    Simulation simulation(gas, run);
    const auto entropy = [&] {
        Eigen::ArrayXd numbers = Eigen::ArrayXd::Zero(parts);
        for (const double x : simulation.sample().position.col(0))
            numbers[std::min(static_cast<Eigen::Index>(x * parts / 20.0),
                             Eigen::Index{parts - 1})] += 1.0;
        double sum = 0.0;
        for (const double n : numbers)
            if (n > 0.0) sum -= n * std::log(n / count);
        return sum;
    };
    simulation.advance_to(1.0);
    const double before = entropy(), energy = simulation.energy_account().kinetic;
    simulation.advance_to(200.0);
    const double mean = 0.5 * (parts - 1), deviation = std::sqrt(mean + 0.5 * (parts / 2 - 1));
    CHECK(std::abs(entropy() - before - count * std::numbers::ln2) < mean + 5.0 * deviation);
    CHECK(simulation.energy_account().kinetic == doctest::Approx(energy).epsilon(1e-12));
}
