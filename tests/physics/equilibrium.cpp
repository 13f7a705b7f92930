// The laws of equilibrium, exact for any number of particles, any masses, sizes and densities:
// energy shares and, on a line, places.
//
// Each distribution is tested on independent samples (taken far apart in time, their correlation is
// looked at) by Kolmogorov and Smirnov's test. All tests of fit together fail by chance once in a
// hundred choices of seeds: Bonferroni's share of that for each, which holds although the shares of
// one gas depend on each other. The seeds are fixed, so a run never fails by chance.
#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "physics/gas.h"
#include "physics/simulation.h"
#include "support/bodies.h"
#include "support/csv.h"
#include "support/goodness_of_fit.h"

using namespace carom;

namespace {

constexpr int tests_of_fit = 8 + 2 + 1 + 5 + 24;
constexpr double level = 0.01 / tests_of_fit;
constexpr int samples = 3000;

using Distribution = std::function<double(double)>;  // a distribution function
using Series = std::vector<std::vector<double>>;     // of each quantity its samples

// Beta(1, b), as a share of at most `most`.
Distribution shares_below(double b, double most = 1.0) {
    return [=](double x) { return 1.0 - std::pow(std::max(0.0, 1.0 - x / most), b); };
}

void check_distribution(const std::vector<double>& values, const Distribution& below) {
    CHECK(test::chance(values, below) > level);
    // Four standard errors: looked at for as many series as there are tests
    CHECK(std::abs(test::correlation_with_next(values)) < 4.0 / std::sqrt(values.size()));
}

// What `look` sees `count` times, `apart` from each other, after fifty of them.
Series series(Simulation& simulation, double apart,
              const std::function<Eigen::ArrayXd(const Sample&)>& look, int count = samples) {
    Series found;
    for (int k = 0; k < count; ++k) {
        simulation.advance_to((50 + k) * apart);
        const Eigen::ArrayXd seen = look(simulation.sample());
        found.resize(static_cast<std::size_t>(seen.size()));
        for (std::size_t i = 0; i < found.size(); ++i)
            found[i].push_back(seen[static_cast<Eigen::Index>(i)]);
    }
    return found;
}

Series energy_shares(Simulation& simulation, double apart, int count = samples) {
    const auto shares = [&](const Sample& sample) -> Eigen::ArrayXd {
        const Eigen::ArrayXd energies = kinetic_energies(simulation.particles(), sample);
        return energies / energies.sum();
    };
    return series(simulation, apart, shares, count);
}

// Masses without simple ratios, so that the beads mix.
const std::vector<double> bead_masses{1.0, 2.0 * std::numbers::sqrt2, 5.3, 9.1, 0.7, 3.7, 1.9, 6.1};

Simulation unequal_beads(int count, double length, double rod) {
    std::vector<test::Bead> beads;
    for (int k = 0; k < count; ++k)
        beads.push_back({length * (k + 0.5) / count, k % 2 == 0 ? 1.0 : -0.3,
                         1.0 / bead_masses[static_cast<std::size_t>(k)]});
    return test::along_a_line(1, length, 0.5 * rod, beads);
}

}  // namespace

TEST_CASE("energy shares between walls follow Beta(1, N - 1), whatever masses and sizes") {
    for (const int light : {0, 1, 2, 8}) {
        CAPTURE(light);
        Gas gas;
        gas.box.size = {8.0, 7.0};
        gas.species = {{.name = "heavy",
                        .count = 2,
                        .radius = 0.9,
                        .mass = ValueRule{std::vector{4.0, 4.5}},
                        .velocity = Speed{1.0}},
                       {.name = "light", .count = light, .radius = 0.4, .mass = ValueRule{0.5}}};
        Simulation simulation(gas, Run{});
        // The laws of ten disks and of eleven are 0.039 apart: so many samples are expected to give
        // the wrong one a chance of 1e-10, where 3000 would give it just that of `level`.
        const Series found = energy_shares(simulation, 60.0, 8000);
        check_distribution(found.front(), shares_below(light + 1.0));
        check_distribution(found.back(), shares_below(light + 1.0));
        CHECK(test::chance(found.front(), shares_below(light + 2.0)) < level);  // it can tell
    }
}

TEST_CASE("energy shares of a dense gas follow the same distribution") {
    Gas gas;
    gas.box.size = {4.3, 4.3};
    gas.species = {{.name = "", .count = 14, .velocity = Speed{1.0}, .position = LatticePlaces{}}};
    Simulation simulation(gas, Run{});  // packing 0.59
    const Series found = energy_shares(simulation, 10.0);
    check_distribution(found[0], shares_below(13.0));
    CHECK(test::chance(found[0], shares_below(15.0)) < level);
}

TEST_CASE("energy shares in a periodic box follow (1 - m/M) Beta(1, N - 2)") {
    Gas gas;
    gas.box.size = {8.0, 7.0};
    gas.box.walls = {Wall::periodic, Wall::periodic};
    gas.species = {{.name = "light", .count = 3, .radius = 0.4, .velocity = Speed{2.0}},
                   {.name = "heavy",
                    .count = 2,
                    .radius = 0.8,
                    .mass = ValueRule{3.0},
                    .velocity = Speed{1.0}}};
    Simulation simulation(gas, Run{});
    const Series found = energy_shares(simulation, 60.0);
    check_distribution(found[0], shares_below(3.0, 1.0 - 1.0 / 9.0));
    check_distribution(found[3], shares_below(3.0, 1.0 - 3.0 / 9.0));
    CHECK(test::chance(found[3], shares_below(4.0)) < level);
}

TEST_CASE("energy shares of beads follow Beta(1/2, (N - 1)/2)") {
    Simulation simulation = unequal_beads(5, 9.0, 0.0);
    const Series found = energy_shares(simulation, 300.0);
    // N = 5: one component of a direction in space of five dimensions, squared.
    const Distribution below = [](double x) { return 0.5 * std::sqrt(x) * (3.0 - x); };
    for (const std::vector<double>& shares : found) {
        check_distribution(shares, below);
        CHECK(test::chance(shares, [](double x) { return std::sqrt(x); }) < level);  // of N = 3
    }
}

TEST_CASE("bead k of N lies at Beta(k, N + 1 - k) of a line, whatever the masses") {
    for (const int count : {4, 8}) {
        for (const double rod : {0.0, 0.4}) {
            CAPTURE(count);
            CAPTURE(rod);
            const double length = 9.0;
            Simulation simulation = unequal_beads(count, length, rod);
            const Series found =
                series(simulation, 300.0, [&](const Sample& sample) -> Eigen::ArrayXd {
                    const Eigen::ArrayXd before =
                        Eigen::ArrayXd::LinSpaced(count, 0.5, count - 0.5) * rod;
                    return (sample.position.col(0) - before) / (length - count * rod);
                });
            for (const auto& row : test::reference_rows("beads_1d_positions.csv")) {
                if (std::stoi(row[0]) != count) continue;
                const int bead = std::stoi(row[1]);
                CAPTURE(bead);
                const std::vector<double>& places = found[static_cast<std::size_t>(bead - 1)];
                check_distribution(
                    places, [&](double x) { return test::beta_below(bead, count + 1 - bead, x); });
                double mean = 0.0;
                for (const double x : places) mean += x / samples;
                const double error = std::sqrt(test::fraction(row[3]) / samples);
                CHECK(std::abs(mean - test::fraction(row[2])) < 4.0 * error);
            }
            CHECK(test::chance(found[0], [&](double x) {
                      return test::beta_below(1, count + 1, x);
                  }) < level);
        }
    }
}

TEST_CASE("neighbours on a line collide as often as their energy and masses say") {
    // N/(L - N a) sqrt(E / 2 mu) Gamma(N/2) / (sqrt(pi) Gamma((N + 1)/2)), mu the reduced mass
    constexpr int count = 4, blocks = 20;
    Simulation simulation = unequal_beads(count, 9.0, 0.4);
    const double energy = kinetic_energies(simulation.particles(), simulation.sample()).sum();
    simulation.record_collisions(true);
    const double duration = 20'000.0;  // of a block; many times the memory of any energy
    Eigen::ArrayXXd rate = Eigen::ArrayXXd::Zero(count - 1, blocks);
    for (int block = 0; block < blocks; ++block)
        for (const Collision& c : simulation.advance_to((block + 1) * duration).collisions)
            if (c.second.is_particle())
                rate(std::min(c.first, c.second.particle()), block) += 1.0 / duration;
    for (int k = 0; k < count - 1; ++k) {
        CAPTURE(k);
        const double mass = 1.0 / simulation.particles().inverse_mass.segment(k, 2).sum();
        const double expected = count / (9.0 - count * 0.4) * std::sqrt(energy / (2.0 * mass)) *
                                std::tgamma(0.5 * count) /
                                (std::sqrt(std::numbers::pi) * std::tgamma(0.5 * (count + 1)));
        const double mean = rate.row(k).mean();
        const double error =
            std::sqrt((rate.row(k) - mean).square().sum() / (blocks * (blocks - 1)));
        CHECK(error < 0.005 * expected);
        CHECK(std::abs(mean - expected) < 4.0 * error);
    }
}
