// Goodness of fit: whether counts in classes are what an equilibrium gives, by Pearson's
// chi-squared test, for values that conservation laws tie together. Knows no bars and no words.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "physics/theory/theory.h"

namespace carom {

/// The chance of more than `statistic` in a chi-squared distribution with `freedom` degrees of
/// freedom, which need not be whole. Both positive.
double chi_squared_tail(double statistic, double freedom);

/// The same for a chi-squared distribution of `freedom` degrees, none included, and squares of
/// further normal numbers times `weights`, not negative. Accurate to 1e-3 of itself or better.
double weighted_tail(double statistic, double freedom, std::span<const double> weights);

/// A sum over all particles that never changes, as far as the counted values have a part in it.
struct Conserved {
    std::vector<double> moment;  ///< for each class: the expected sum, over the values in it, of
                                 ///< the conserved thing, brought to mean 0 and variance 1
    double share = 0.0;          ///< of these values in the variance of the whole sum
    double values = 0.0;         ///< how many there are
};

/// What is expected of counts in classes.
struct Expected {
    std::vector<double> count;
    std::vector<Conserved> conserved;
};

/// Of the sums of counts in the same classes of independent runs, each with conserved sums of its
/// own. That their distributions differ is left out: of N particles it changes the variances by
/// their Nth part, as do the energies' correlations of higher order, which are left out too, and
/// with energies drawn by Boltzmann's distribution the two have opposite signs.
Expected together(const std::vector<Expected>& runs);

enum class TestedQuantity { speed, energy, velocity };

/// What is expected of `particles` particles of one mass, `values_each` components of velocity of
/// each of them, in the classes below the first of some rising edges, between them and from the
/// last on. Exact for a finite gas: energy shares are Beta distributed (see theory.h).
Expected expected_counts(const EquilibriumGas& gas, TestedQuantity quantity,
                         const std::vector<double>& edges, double particles, double values_each);

struct ChiSquared {
    double statistic = 0.0;
    double freedom = 0.0;  ///< degrees of freedom
    double p = 1.0;        ///< the chance of a larger statistic
    int classes = 0;       ///< after pooling
};

/// What each class must have in Pearson's test after pooling, and how many there must be.
inline constexpr double least_expected = 5.0;
inline constexpr int fewest_classes = 3;

/// Pearson's test. Neighbouring classes are pooled from the lowest on until at least 5 values are
/// expected in each. The number of values is given, and so are the conserved sums: instead of a
/// chi-squared distribution of (classes - 1) degrees the statistic has that of a sum of squares of
/// which as many as there are sums weigh less than 1, by the part of each that the classes see
/// (compare Chernoff and Lehmann 1954, doi:10.1214/aoms/1177728726). Of more than two such weights
/// the two least are taken as they are, the others by their sum. Degrees of freedom are the mean of
/// this distribution, the sum of the weights; p is its tail. Nothing where fewer than three
/// classes are left.
std::optional<ChiSquared> pearson(const std::vector<double>& observed, const Expected& expected);

}  // namespace carom
