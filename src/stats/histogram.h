// Histograms with fixed edges, and the rule that chooses the edges. Histogram counts one set of
// values; RunningHistogram averages such counts over the samples of a window, and GrowingHistogram
// finds its own edges while it counts.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace carom {

/// Equal bins over [low, high).
struct Bins {
    double low = 0.0, high = 1.0;
    int count = 1;
    double width() const { return (high - low) / count; }
    double edge(int index) const { return low + (high - low) * index / count; }
    void archive(auto& archive) { archive(low, high, count); }
};

/// Counts of values in bins, below them and above them; the three always add up to the number of
/// values.
struct Histogram {
    Bins bins;
    std::vector<std::int64_t> counts;  ///< one for each bin
    std::int64_t below = 0, above = 0;
    void archive(auto& archive) { archive(bins, counts, below, above); }
};

/// Counts values in bins: bin k holds [edge(k), edge(k + 1)), the last bin also its upper edge, but
/// for rounding errors (bin_number.h). NaN counts as above.
Histogram histogram(const Eigen::ArrayXd& values, const Bins& bins);

/// The bin width by Freedman and Diaconis (1981), 2 IQR n^(-1/3), for `n` values with the
/// interquartile range (IQR) `spread`.
double freedman_diaconis_width(double spread, double n);

/// The number of bins of that width over [low, high] for samples of size `n` distributed like
/// `values`; at least `fewest` and at most `most`.
int freedman_diaconis(const std::vector<double>& values, double n, double low, double high,
                      int fewest, int most);

/// The quantile at `share` in [0, 1] by linear interpolation between order statistics; `values` is
/// reordered. Requires at least one value.
double quantile(std::vector<double>& values, double share);

}  // namespace carom
