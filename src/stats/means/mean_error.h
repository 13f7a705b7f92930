// The mean of a quantity over independent runs, or over pieces of the time of one run, and its
// standard error.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace carom {

struct MeanError {
    double mean = 0.0;   ///< NaN if there are no values
    double error = 0.0;  ///< standard error of the mean; NaN for fewer than two values
    void archive(auto& archive) { archive(mean, error); }
};

/// The mean of all finite values, and its standard error: the square root of (1 / n) times their
/// variance (with divisor n - 1).
MeanError mean_error(const std::vector<double>& values);

/// Integrals over pieces of a time, in order of time, in several cells: piece x cell. The mean in a
/// cell is the sum of its column divided by the sum of its weights; the weight of a time average is
/// the time.
struct PieceSums {
    Eigen::ArrayXXd sum, weight;

    /// Pieces of twice the length. Requires an even number of them.
    PieceSums in_pairs() const;
};

/// The correlation of neighbouring pieces, as the mean over all cells whose mean varies: of n
/// pieces in a cell, the sum over neighbours of the products of their deviations from the mean,
/// divided by the sum of squares, plus 1/n, so that it is 0 on average for independent pieces. NaN
/// if no mean varies.
double correlation_of_neighbours(const PieceSums& pieces);

/// The standard error of the mean in each cell, from the scatter of its pieces in pairs: the square
/// root of 1/n times the variance of n pairs (with divisor n - 1). NaN in cells where a pair has no
/// weight or none of the quantity at all.
///
/// Nothing if the pieces, or the pairs, are not independent: if the correlation of neighbours is
/// larger than the standard deviation, 1 / sqrt(n - 1), that it has by chance in a single cell, or
/// less than minus that. Independent pieces exceed this rarely in five cells and hardly ever in
/// more. At the bound the error is about a fifth too small. Pieces are tested besides the pairs
/// because what connects neighbouring pairs is stronger between their halves.
std::optional<Eigen::ArrayXd> standard_errors(const PieceSums& pieces);

/// The standard error of the mean of a quantity over a time, from standard_errors() of 40 equal
/// pieces of it, or of 20 if those are not independent: `integrals` are those of the quantity since
/// the first of the `times`, which increase. NaN if the pieces are not independent, or have fewer
/// than two moments each.
double error_of_time_average(const std::vector<double>& times,
                             const std::vector<double>& integrals);

}  // namespace carom
