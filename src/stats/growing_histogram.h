// A histogram of all values of a run whose range is not known in advance: the bins widen as larger
// values arrive, no value is lost, and the memory does not depend on the number of values. Used for
// the report of `carom run`; see histogram.h for the other histograms.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace carom {

/// Counts between edges: bin k holds [edges[k], edges[k + 1]); a value that is on an edge but for
/// rounding errors is in the bin above.
struct BinnedCounts {
    std::vector<double> edges;  ///< from 0 on; one more than there are counts
    std::vector<std::int64_t> counts;
};

/// Values must not be negative; infinite values and NaN are ignored.
class GrowingHistogram {
  public:
    using Values = Eigen::Ref<const Eigen::ArrayXd>;

    /// Widens the bins until they can hold the value `largest`. Call it once per sample with the
    /// sample's largest value before counting, so that the width does not depend on the order of
    /// the values.
    void make_room(double largest);

    /// Counts values once.
    void add(const Values& values) { count(values, 0, 1); }

    /// Counts the values once in every following sample (see count_held()), until replace() or
    /// hold_none().
    void hold(const Values& values) { count(values, 1, -samples_); }

    /// Replaces some of the held values, `before`, by others, `after`.
    void replace(const Values& before, const Values& after) {
        count(before, -1, samples_);
        count(after, 1, -samples_);
    }
    void hold_none();

    /// Completes a sample: counts all held values once.
    void count_held() { ++samples_; }

    /// Returns all counts in bins of a round width (1, 2 or 5 times a power of ten): the smallest
    /// that is not below the width by Freedman and Diaconis (1981), 2 IQR n^(-1/3), limited to
    /// between 1/200 and 1/20 of the largest value. One bin from 0 to 1 if no value is above 0.
    BinnedCounts counts() const;

  private:
    /// The count of a fine bin is `offset` plus `held` times the number of samples.
    struct Bin {
        std::int64_t held = 0, offset = 0;
    };

    void count(const Values& values, std::int64_t held, std::int64_t offset);
    void coarsen();
    void set_exponent(int exponent);
    double edge(std::int64_t bin) const;
    std::int64_t bin_of(double value) const;
    std::vector<std::int64_t> fine_counts() const;
    double quantile(const std::vector<std::int64_t>& fine, double total, double share) const;
    std::int64_t bins_together(double width) const;

    std::int64_t samples_ = 0;                  ///< number of calls of count_held()
    bool has_scale_ = false;                    ///< set by the first value above 0
    int exponent_ = 0;                          ///< fine bins are 10^exponent_ wide
    double width_ = 1.0, bins_per_unit_ = 1.0;  ///< 10^exponent_ and 10^-exponent_
    std::vector<Bin> fine_{1};
};

}  // namespace carom
