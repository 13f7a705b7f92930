// Goodness of fit: Pearson's chi-squared test of whether counts in classes agree with an
// equilibrium distribution, for values that are correlated by conservation laws. Independent of how
// histograms are drawn and described.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "physics/theory/theory.h"

namespace carom {

/// The probability that a chi-squared variable with `freedom` degrees of freedom (not necessarily
/// an integer) exceeds `statistic`. Both must be positive.
double chi_squared_tail(double statistic, double freedom);

/// The same tail probability for the sum of a chi-squared variable of `freedom` degrees of freedom
/// (0 is allowed) and squares of further standard normal variables, each times one of `weights`
/// (not negative). Relative error 1e-3 or less.
double weighted_tail(double statistic, double freedom, std::span<const double> weights);

/// A conserved sum over all particles, such as the energy, described by its relation to the counted
/// values.
struct Conserved {
    std::vector<double> moment;  ///< for each class: the expected sum, over the values in it, of
                                 ///< the conserved quantity, standardised to mean 0 and variance 1
    double share = 0.0;          ///< share of the counted values in the variance of the whole sum
    double values = 0.0;         ///< number of counted values
};

/// The expected counts in classes, and the conserved sums that correlate them.
struct Expected {
    std::vector<double> count;
    std::vector<Conserved> conserved;
};

/// The expectation for counts summed over independent runs with the same classes, each with its own
/// conserved sums. Two effects are neglected, each a relative change of order 1/N of the variances
/// for N particles: the distributions differ from run to run, and energies have correlations of
/// higher order. For energies drawn from the Boltzmann distribution the two effects have opposite
/// signs.
Expected together(const std::vector<Expected>& runs);

enum class TestedQuantity { speed, energy, velocity };

/// The expected counts for `particles` particles of one mass, with `values_each` values (components
/// of velocity) for each particle, in the classes that rising `edges` bound: below the first edge,
/// between neighbouring edges, and from the last edge on. Exact for a finite gas: the shares of the
/// energy are Beta distributed (see theory.h).
Expected expected_counts(const EquilibriumGas& gas, TestedQuantity quantity,
                         const std::vector<double>& edges, double particles, double values_each);

struct ChiSquared {
    double statistic = 0.0;
    double freedom = 0.0;  ///< degrees of freedom
    double p = 1.0;        ///< probability of a larger statistic
    int classes = 0;       ///< after pooling
};

/// The least expected count of each class in Pearson's test after pooling, and the least number of
/// classes.
inline constexpr double least_expected = 5.0;
inline constexpr int fewest_classes = 3;

/// Pearson's test. Neighbouring classes are pooled from the lowest on until at least 5 values are
/// expected in each. The number of values is fixed, and so are the conserved sums. Instead of a
/// chi-squared distribution of (classes - 1) degrees of freedom, the statistic therefore follows
/// that of a sum of (classes - 1) squared normal variables, in which as many as there are conserved
/// sums have a weight below 1: 1 less the part of each sum that the classes resolve (compare
/// Chernoff and Lehmann 1954, doi:10.1214/aoms/1177728726). If there are more than two such
/// weights, the two smallest are treated exactly and the others through their sum. The degrees of
/// freedom are the mean of this distribution, the sum of the weights; p is its tail probability.
/// Returns nothing if fewer than three classes are left.
std::optional<ChiSquared> pearson(const std::vector<double>& observed, const Expected& expected);

}  // namespace carom
