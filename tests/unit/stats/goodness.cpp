// Pearson's test against published tables, and against gases whose momenta are drawn evenly from
// the energy sphere: its p must be spread evenly.
#include "stats/goodness.h"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <string>

#include "stats/histogram.h"
#include "support/goodness_of_fit.h"
#include "util/random.h"

using namespace carom;

namespace {

struct Draw {
    int dimension, particles, chosen;
    bool periodic;  // momentum is 0
    TestedQuantity quantity;
    bool both;  // all components
    Bins bins;
};

// All of one mass, chosen ones first; the energy is that of a temperature of 1.
EquilibriumGas gas_of(const Draw& draw, double mass) {
    const double d = draw.dimension, n = draw.particles;
    EquilibriumGas gas;
    gas.energy = 0.5 * d * n;
    gas.alpha = 0.5 * d;
    gas.beta = 0.5 * d * (n - (draw.periodic ? 2.0 : 1.0));
    const double share = draw.periodic ? 1.0 - 1.0 / n : 1.0;
    gas.groups = {{mass, double(draw.chosen), {share, share, share}}};
    return gas;
}

Eigen::ArrayXXd velocities(const Draw& draw, double mass, Random& random) {
    Eigen::ArrayXXd v(draw.particles, draw.dimension);
    for (double& one : v.reshaped()) one = random.normal();
    if (draw.periodic) v.rowwise() -= v.colwise().mean().eval();
    return v * std::sqrt(0.5 * draw.dimension * draw.particles / (0.5 * mass * v.square().sum()));
}

Eigen::ArrayXd values(const Draw& draw, double mass, const Eigen::ArrayXXd& v) {
    const Eigen::ArrayXXd some = v.topRows(draw.chosen);
    const Eigen::ArrayXd square = some.square().rowwise().sum();
    if (draw.quantity == TestedQuantity::speed) return square.sqrt();
    if (draw.quantity == TestedQuantity::energy) return 0.5 * mass * square;
    if (draw.both) return some.reshaped();
    return some.col(0);
}

std::vector<double> edges_of(const Bins& bins) {
    std::vector<double> edges;
    for (int i = 0; i <= bins.count; ++i) edges.push_back(bins.edge(i));
    return edges;
}

std::vector<double> counts_of(const Histogram& found) {
    std::vector<double> counts{double(found.below)};
    for (const std::int64_t count : found.counts) counts.push_back(double(count));
    counts.push_back(double(found.above));
    return counts;
}

std::vector<double> observed_in(const Draw& draw, double mass, const Eigen::ArrayXXd& v) {
    return counts_of(histogram(values(draw, mass, v), draw.bins));
}

Expected expected_of(const Draw& draw, const EquilibriumGas& gas) {
    return expected_counts(gas, draw.quantity, edges_of(draw.bins), draw.chosen,
                           draw.both ? double(draw.dimension) : 1.0);
}

constexpr double mass = 3.0;

double p_of(const Draw& draw, Random& random) {
    return pearson(observed_in(draw, mass, velocities(draw, mass, random)),
                   expected_of(draw, gas_of(draw, mass)))
        .value()
        .p;
}

// Of runs whose energies differ, as those of several seeds: drawn by Boltzmann's distribution at
// the temperature of 1.
double p_of_runs(const Draw& draw, int runs, Random& random) {
    std::vector<double> observed(static_cast<std::size_t>(draw.bins.count) + 2);
    std::vector<Expected> expected;
    for (int run = 0; run < runs; ++run) {
        EquilibriumGas gas = gas_of(draw, mass);
        double energy = 0.0;
        for (int i = 0; i < draw.dimension * draw.particles; ++i) {
            const double one = random.normal();
            energy += 0.5 * one * one;
        }
        const Eigen::ArrayXXd v = velocities(draw, mass, random) * std::sqrt(energy / gas.energy);
        gas.energy = energy;
        const std::vector<double> found = observed_in(draw, mass, v);
        for (std::size_t k = 0; k < found.size(); ++k) observed[k] += found[k];
        expected.push_back(expected_of(draw, gas));
    }
    return pearson(observed, together(expected)).value().p;
}

// By 3000 values of p of each draw; `alpha`: that one of them all fails by chance.
void check_spread_of_p(const std::vector<Draw>& draws, std::uint64_t seed, const std::string& name,
                       const std::function<double(const Draw&, Random&)>& p_of) {
    constexpr double alpha = 1e-3;
    for (std::size_t k = 0; k < draws.size(); ++k) {
        CAPTURE(k);
        Random random(seed, name + " " + std::to_string(k));
        std::vector<double> found;
        for (int i = 0; i < 3000; ++i) found.push_back(p_of(draws[k], random));
        CHECK(test::chance(found, [](double p) { return p; }) > alpha / double(draws.size()));
    }
}

}  // namespace

TEST_CASE("the tail of chi-squared is that of published tables") {
    // NIST/SEMATECH e-Handbook of Statistical Methods, 1.3.6.7.4: degrees, critical value, chance.
    const std::vector<std::array<double, 3>> table{
        {1, 3.841, 0.05},   {5, 15.086, 0.01},    {10, 18.307, 0.05}, {10, 29.588, 0.001},
        {30, 50.892, 0.01}, {100, 124.342, 0.05}, {4, 0.711, 0.95},   {20, 8.260, 0.99}};
    for (const auto& [freedom, value, chance] : table)
        CHECK(chi_squared_tail(value, freedom) == doctest::Approx(chance).epsilon(2e-3));
    CHECK(chi_squared_tail(3.0, 2.0) == doctest::Approx(std::exp(-1.5)).epsilon(1e-12));
    CHECK(chi_squared_tail(300.0, 2.0) == doctest::Approx(std::exp(-150.0)).epsilon(1e-9));
}

TEST_CASE("weighted squares have the tail that closed forms give") {
    for (const double x : {0.1, 1.0, 4.0, 20.0, 60.0, 1000.0}) {
        // Weights of 1 add degrees of freedom; two equal weights make an exponential distribution.
        CHECK(weighted_tail(x, 3, std::array{1.0}) ==
              doctest::Approx(chi_squared_tail(x, 4)).epsilon(1e-4).scale(0.0));
        CHECK(weighted_tail(x, 5, std::array{1.0, 0.0}) ==
              doctest::Approx(chi_squared_tail(x, 6)).epsilon(1e-4).scale(0.0));
        if (x < 100.0)
            CHECK(weighted_tail(x, 0, std::array{0.5, 0.5}) ==
                  doctest::Approx(std::exp(-x)).epsilon(1e-3).scale(0.0));
        // A square less than 1 with two whole ones: the exponential distribution, widened by its
        // mean.
        const double widened = std::exp(-0.5 * x) / std::sqrt(1.0 - 0.3);
        if (x > 50.0)
            CHECK(weighted_tail(x, 2, std::array{0.3}) ==
                  doctest::Approx(widened).epsilon(1e-4).scale(0.0));
        CHECK(weighted_tail(x, 2, std::array{1e-4}) ==
              doctest::Approx(std::exp(-0.5 * x)).epsilon(1e-3).scale(0.0));
    }
}

TEST_CASE("Mendel's peas (1866): chi-squared 0.470 for 3 degrees of freedom") {
    const std::vector<double> ratio{9, 3, 3, 1}, peas{315, 108, 101, 32};
    Expected expected;
    for (const double share : ratio) expected.count.push_back(556 * share / 16);
    const ChiSquared test = pearson(peas, expected).value();
    CHECK(test.statistic == doctest::Approx(0.470).epsilon(1e-3));
    CHECK(test.freedom == 3.0);
    CHECK(test.p == doctest::Approx(0.925).epsilon(1e-3));
}

TEST_CASE("classes are pooled until five are expected in each, whatever was observed") {
    const Expected expected{{2, 2, 2, 5, 7, 3, 1}, {}};
    const ChiSquared test = pearson({8, 0, 0, 5, 9, 0, 0}, expected).value();
    CHECK(test.classes == 3);  // 6, 5 and 11
    CHECK(test.statistic == doctest::Approx(4.0 / 6 + 0.0 + 4.0 / 11));
    CHECK(!pearson({6, 6}, {{6, 6}, {}}).has_value());
    CHECK(!pearson({1, 1, 1}, {{1, 1, 1}, {}}).has_value());
}

TEST_CASE("expected counts and their conserved sums are those of the laws' densities") {
    const Draw draw{2, 50, 20, true, TestedQuantity::velocity, true, {}};
    const EquilibriumGas gas = gas_of(draw, 3.0);
    const std::vector<double> edges{-0.9, -0.2, 0.1, 0.7};
    for (const TestedQuantity quantity :
         {TestedQuantity::velocity, TestedQuantity::speed, TestedQuantity::energy}) {
        const Expected expected = expected_counts(gas, quantity, edges, 20, 1);
        for (std::size_t k = 1; k < edges.size(); ++k) {
            constexpr int steps = 20'000;
            double sum = 0.0;
            for (int i = 0; i < steps; ++i) {
                const double x = edges[k - 1] + (edges[k] - edges[k - 1]) * (i + 0.5) / steps;
                const double density = quantity == TestedQuantity::velocity
                                           ? velocity_density(gas, x)
                                       : x < 0.0                           ? 0.0
                                       : quantity == TestedQuantity::speed ? speed_density(gas, x)
                                                                           : energy_density(gas, x);
                sum += 20 * density * (edges[k] - edges[k - 1]) / steps;
            }
            CHECK(expected.count[k] == doctest::Approx(sum).epsilon(1e-3));
        }
        double all = 0.0;
        for (const double count : expected.count) all += count;
        CHECK(all == doctest::Approx(20.0));
        for (const Conserved& one : expected.conserved) {
            double left = 0.0;
            for (const double moment : one.moment) left += moment;
            CHECK(std::abs(left) < 1e-9);
        }
    }
}

TEST_CASE("p is spread evenly over gases in equilibrium") {
    const std::vector<Draw> draws{
        {2, 400, 400, false, TestedQuantity::speed, false, {0, 4, 16}},
        {2, 400, 400, true, TestedQuantity::energy, false, {0, 6, 14}},
        {1, 400, 400, false, TestedQuantity::energy, false, {0, 4, 12}},
        {1, 400, 400, true, TestedQuantity::velocity, false, {-3, 3, 6}},
        {2, 300, 300, true, TestedQuantity::velocity, true, {-3, 3, 6}},
        {2, 300, 150, false, TestedQuantity::speed, false, {0, 4, 8}},
        {1, 400, 400, true, TestedQuantity::speed, false, {0, 2, 4}},
        {3, 200, 200, true, TestedQuantity::velocity, true, {-3, 3, 6}},
        {3, 200, 200, false, TestedQuantity::speed, false, {0, 4, 10}},
    };
    check_spread_of_p(draws, 7, "p of draw", p_of);
}

TEST_CASE("p is spread evenly over runs of few particles with energies of their own") {
    const std::vector<Draw> draws{
        {2, 10, 10, false, TestedQuantity::speed, false, {0, 3, 12}},
        {1, 5, 5, false, TestedQuantity::velocity, false, {-2, 2, 8}},
    };
    constexpr int runs = 60;
    check_spread_of_p(draws, 9, "p of runs of draw", [](const Draw& draw, Random& random) {
        return p_of_runs(draw, runs, random);
    });
}

TEST_CASE("runs of one distribution together are tested as one of as many values") {
    const Draw draw{2, 300, 300, true, TestedQuantity::velocity, true, {-3, 3, 6}};
    std::vector<double> observed;
    const Expected one = expected_of(draw, gas_of(draw, mass));
    Expected three = one;
    for (double& count : three.count) count *= 3.0;
    for (Conserved& sum : three.conserved) {
        for (double& moment : sum.moment) moment *= 3.0;
        sum.values *= 3.0;
    }
    for (std::size_t k = 0; k < one.count.size(); ++k)
        observed.push_back(three.count[k] + (k % 2 == 0 ? 9.0 : -8.0));
    const ChiSquared a = pearson(observed, three).value();
    const ChiSquared b = pearson(observed, together({one, one, one})).value();
    CHECK(a.statistic == doctest::Approx(b.statistic));
    CHECK(a.freedom == doctest::Approx(b.freedom));
    CHECK(a.p == doctest::Approx(b.p));
}

TEST_CASE("without what is conserved p would not be spread evenly") {
    Random random(8, "as if independent");
    const Draw draw{1, 400, 400, true, TestedQuantity::velocity, false, {-3, 3, 6}};
    std::vector<double> found;
    for (int i = 0; i < 3000; ++i) {
        const std::vector<double> observed =
            observed_in(draw, mass, velocities(draw, mass, random));
        Expected expected = expected_of(draw, gas_of(draw, mass));
        expected.conserved.clear();
        found.push_back(pearson(observed, expected).value().p);
    }
    CHECK(test::chance(found, [](double p) { return p; }) < 1e-9);
}
