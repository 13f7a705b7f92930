// A histogram of all values of a run, whose range nobody knows before its end: bins grow with the
// values, none is lost, and memory stays the same however many there are. For the report of
// `carom run`; see histogram.h for the others.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace carom {

/// Counts between edges: bin k holds [edges[k], edges[k + 1]).
struct BinnedCounts {
    std::vector<double> edges;  ///< from 0, one more than counts
    std::vector<std::int64_t> counts;
};

/// Values are of at least 0; those that are infinite or no number are left out.
class GrowingHistogram {
  public:
    using Values = Eigen::Ref<const Eigen::ArrayXd>;

    /// Makes the bins wide enough for a value. Those of one sample are counted after a single call
    /// with their largest, so that the width does not depend on their order.
    void make_room(double largest);

    /// Counts values once.
    void add(const Values& values) { count(values, 0, 1); }

    /// Counts values once in every sample from the next on, until replace() or hold_none().
    void hold(const Values& values) { count(values, 1, -samples_); }

    /// Of the values that are held, others take the place of some.
    void replace(const Values& before, const Values& after) {
        count(before, -1, samples_);
        count(after, 1, -samples_);
    }
    void hold_none();

    /// A sample: all that is held is counted once.
    void count_held() { ++samples_; }

    /// All counts in bins of a round width (1, 2 or 5 times a power of ten): the least that is not
    /// below Freedman and Diaconis' (1981), 2 IQR n^(-1/3), which is kept between 1/200 and 1/20 of
    /// the largest value. One bin from 0 to 1 when there is no value above 0.
    BinnedCounts counts() const;

  private:
    /// In a fine bin: counted are `offset`, and `held` for each sample.
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

    std::int64_t samples_ = 0;                  ///< so many calls of count_held()
    bool has_scale_ = false;                    ///< set by the first value above 0
    int exponent_ = 0;                          ///< fine bins are 10^exponent_ wide
    double width_ = 1.0, bins_per_unit_ = 1.0;  ///< 10^exponent_ and 10^-exponent_
    std::vector<Bin> fine_{1};
};

}  // namespace carom
