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

class GrowingHistogram {
  public:
    /// Counts values of at least 0; those that are infinite or no number are left out.
    void add(const Eigen::ArrayXd& values);

    /// All counts in bins of a round width (1, 2 or 5 times a power of ten): the least that is not
    /// below Freedman and Diaconis' (1981), 2 IQR n^(-1/3), which is kept between 1/200 and 1/20 of
    /// the largest value. One bin from 0 to 1 when there is no value above 0.
    BinnedCounts counts() const;

  private:
    void look_first(double largest);
    void coarsen();
    void set_exponent(int exponent);
    double edge(std::int64_t bin) const;
    std::int64_t bin_of(double value) const;
    double quantile(double share) const;
    std::int64_t bins_together(double width) const;

    std::int64_t zeros_ = 0;  ///< values of 0, counted until a larger one has set the scale
    std::int64_t total_ = 0;
    int exponent_ = 0;                          ///< fine bins are 10^exponent_ wide
    double width_ = 1.0, bins_per_unit_ = 1.0;  ///< 10^exponent_ and 10^-exponent_
    std::vector<std::int64_t> fine_;
};

}  // namespace carom
