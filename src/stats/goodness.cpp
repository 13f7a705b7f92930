#include "stats/goodness.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <unsupported/Eigen/SpecialFunctions>

namespace carom {
namespace {

// The distribution function of Beta(a, b).
double beta_below(double a, double b, double x) {
    if (x <= 0.0) return 0.0;
    return x >= 1.0 ? 1.0 : Eigen::numext::betainc(a, b, x);
}

// Integrals of the distribution of one value up to an edge: of the probability, of the energy and
// of the momentum; energy and momentum are standardised, i.e. relative to their means and in units
// of their standard deviations.
struct Below {
    double chance, energy, momentum;
};

// For u, an energy divided by the largest possible one: Beta(a, b) distributed.
Below energies_below(double a, double b, double u) {
    const double mean = a / (a + b);
    const double deviation = std::sqrt(a * b / (a + b + 1.0)) / (a + b);
    const double chance = beta_below(a, b, u);
    return {chance, mean * (beta_below(a + 1.0, b, u) - chance) / deviation, 0.0};
}

// For a component of velocity of either sign; its share of the energy is Beta(1/2, b) distributed.
Below velocities_below(double b, double root) {
    const double u = root * root;
    const double side = root < 0.0 ? -1.0 : 1.0;
    const Below one = energies_below(0.5, b, u);
    const double mean_size =
        std::exp(std::lgamma(1.0) + std::lgamma(0.5 + b) - std::lgamma(0.5) - std::lgamma(1.0 + b));
    const double deviation = std::sqrt(0.5 / (0.5 + b));
    return {0.5 + 0.5 * side * one.chance, 0.5 * side * one.energy,
            -0.5 * mean_size * std::pow(std::max(0.0, 1.0 - u), b) / deviation};
}

Below below(const EquilibriumGas& gas, TestedQuantity quantity, double edge) {
    const MassGroup& group = gas.groups.front();
    const double most = gas.energy * group.largest_share[0];
    if (quantity == TestedQuantity::energy) return energies_below(gas.alpha, gas.beta, edge / most);
    const double root = std::sqrt(0.5 * group.mass / most) * edge;
    if (quantity == TestedQuantity::speed)
        return energies_below(gas.alpha, gas.beta, root > 0.0 ? root * root : 0.0);
    return velocities_below(gas.alpha + gas.beta - 0.5, std::clamp(root, -1.0, 1.0));
}

Expected pooled(const Expected& expected, std::vector<double>& observed) {
    Expected some;
    some.conserved = expected.conserved;
    for (Conserved& one : some.conserved) one.moment.clear();
    std::vector<double> counts;
    bool opens = true;
    for (std::size_t k = 0; k < expected.count.size(); ++k) {
        if (opens) {
            some.count.push_back(0.0);
            counts.push_back(0.0);
            for (Conserved& one : some.conserved) one.moment.push_back(0.0);
        }
        some.count.back() += expected.count[k];
        counts.back() += observed[k];
        for (std::size_t c = 0; c < some.conserved.size(); ++c)
            some.conserved[c].moment.back() += expected.conserved[c].moment[k];
        opens = some.count.back() >= least_expected;
    }
    if (!opens && some.count.size() > 1) {  // the rest at the end joins its neighbour
        const auto join = [](std::vector<double>& list) {
            const double last = list.back();
            list.pop_back();
            list.back() += last;
        };
        join(some.count);
        join(counts);
        for (Conserved& one : some.conserved) join(one.moment);
    }
    observed = std::move(counts);
    return some;
}

// With fixed conserved sums, the statistic is a sum of squares of independent normal variables.
// Returns the variances below 1, smallest first: 1 less the parts of the sums that the classes
// resolve. All other variances are 1.
std::vector<double> lesser_weights(const Expected& expected) {
    const auto sums = static_cast<Eigen::Index>(expected.conserved.size());
    const auto classes = static_cast<Eigen::Index>(expected.count.size());
    if (sums == 0) return {};
    Eigen::MatrixXd seen(classes, sums);
    for (Eigen::Index c = 0; c < sums; ++c) {
        const Conserved& one = expected.conserved[static_cast<std::size_t>(c)];
        for (Eigen::Index k = 0; k < classes; ++k) {
            const auto at = static_cast<std::size_t>(k);
            seen(k, c) = one.moment[at] *
                         std::sqrt(std::min(1.0, one.share) / (expected.count[at] * one.values));
        }
    }
    // The number of parts is the smaller of the numbers of sums and of classes; the smaller matrix
    // of products is used.
    const Eigen::MatrixXd products =
        sums <= classes ? Eigen::MatrixXd(seen.transpose() * seen) : seen * seen.transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> parts(products, Eigen::EigenvaluesOnly);
    std::vector<double> weights;
    for (const double part : parts.eigenvalues().reverse())
        weights.push_back(std::clamp(1.0 - part, 0.0, 1.0));
    return weights;
}

}  // namespace

double chi_squared_tail(double statistic, double freedom) {
    return Eigen::numext::igammac(0.5 * freedom, 0.5 * statistic);
}

// Integrates over the normal variable z of the first weighted square and calls itself for the rest.
// With z = most * sin(angle) the integrand continues smoothly beyond both ends, where the
// trapezoidal rule is most accurate.
double weighted_tail(double statistic, double freedom, std::span<const double> weights) {
    if (statistic <= 0.0) return 1.0;
    if (weights.empty()) return freedom > 0.0 ? chi_squared_tail(statistic, freedom) : 0.0;
    const double weight = weights.front();
    const auto others = weights.subspan(1);
    constexpr double negligible = 1e-9;
    if (weight < negligible) return weighted_tail(statistic, freedom, others);
    constexpr int steps = 64;
    // Far out in the tail the integrand falls as a normal distribution of variance 1 / (1 -
    // weight).
    const double whole = std::sqrt(statistic / weight);
    const double far = weight < 1.0 ? 10.0 / std::sqrt(1.0 - weight) : whole;
    const double most = std::min(far, whole);
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {  // at the upper end the integrand is 0
        const double angle = 0.5 * std::numbers::pi * i / steps;
        const double z = most * std::sin(angle);
        const double rest = weighted_tail(statistic - weight * z * z, freedom, others);
        sum += (i == 0 ? 0.5 : 1.0) * std::exp(-0.5 * z * z) * rest * most * std::cos(angle);
    }
    const double inside = sum * std::sqrt(0.5 * std::numbers::pi) / steps;
    const double beyond = most < whole ? 0.0 : std::erfc(whole / std::numbers::sqrt2);
    return std::min(1.0, inside + beyond);
}

Expected expected_counts(const EquilibriumGas& gas, TestedQuantity quantity,
                         const std::vector<double>& edges, double particles, double values_each) {
    const double values = particles * values_each;
    const bool is_velocity = quantity == TestedQuantity::velocity;
    const double part = is_velocity ? 0.5 : gas.alpha;
    Expected expected;
    expected.conserved.push_back({{}, values * part / (gas.alpha + gas.beta), values});
    if (is_velocity)
        expected.conserved.push_back(
            {{}, particles * (1.0 - gas.groups.front().largest_share[0]), values});
    Below last{0.0, 0.0, 0.0};
    for (std::size_t k = 0; k <= edges.size(); ++k) {
        const Below next = k < edges.size() ? below(gas, quantity, edges[k]) : Below{1.0, 0.0, 0.0};
        expected.count.push_back(values * (next.chance - last.chance));
        expected.conserved[0].moment.push_back(values * (next.energy - last.energy));
        if (is_velocity)
            expected.conserved[1].moment.push_back(values * (next.momentum - last.momentum));
        last = next;
    }
    return expected;
}

Expected together(const std::vector<Expected>& runs) {
    Expected all{std::vector<double>(runs.front().count.size(), 0.0), {}};
    for (const Expected& run : runs) {
        for (std::size_t k = 0; k < all.count.size(); ++k) all.count[k] += run.count[k];
        all.conserved.insert(all.conserved.end(), run.conserved.begin(), run.conserved.end());
    }
    return all;
}

std::optional<ChiSquared> pearson(const std::vector<double>& observed, const Expected& expected) {
    std::vector<double> counts = observed;
    const Expected classes = pooled(expected, counts);
    ChiSquared test;
    test.classes = static_cast<int>(classes.count.size());
    if (test.classes < fewest_classes || classes.count.front() < least_expected)
        return std::nullopt;
    for (std::size_t k = 0; k < counts.size(); ++k) {
        const double off = counts[k] - classes.count[k];
        test.statistic += off * off / classes.count[k];
    }
    constexpr std::size_t taken_alone = 2;
    const std::vector<double> weights = lesser_weights(classes);
    const std::span least = std::span(weights).first(std::min(taken_alone, weights.size()));
    test.freedom = std::accumulate(weights.begin(), weights.end(),
                                   test.classes - 1.0 - static_cast<double>(weights.size()));
    const double others = test.freedom - std::accumulate(least.begin(), least.end(), 0.0);
    test.p = weighted_tail(test.statistic, std::max(0.0, others), least);
    return test;
}

}  // namespace carom
