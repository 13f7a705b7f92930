// The mean of histograms over time: of the present sample alone, of all since the start, or of
// those of a while before the present. With it the mean and deviation of the values. For the bars
// of the histogram panels; see histogram.h for the others.
#pragma once

#include <Eigen/Core>
#include <deque>
#include <optional>
#include <vector>

#include "stats/histogram.h"

namespace carom {

/// Mean counts of several samples in bins, and the moments of all their finite values.
struct MeanHistogram {
    Bins bins;
    std::vector<double> counts;  ///< one for each bin, mean over the samples
    double below = 0.0, above = 0.0;
    double values = 0.0;     ///< finite ones, of all samples together
    double mean = 0.0;       ///< of them; NaN where there are none
    double deviation = 0.0;  ///< root of the mean square about the mean
    void archive(auto& archive) { archive(bins, counts, below, above, values, mean, deviation); }
};

class RunningHistogram {
  public:
    /// Means over samples later than `window` before the last one, or over all: with a window of 0
    /// of the last alone.
    RunningHistogram(const Bins& bins, std::optional<double> window);

    /// The next sample; times must not fall. Its cost does not grow with the window.
    void add(double time, const Eigen::ArrayXd& values);

    /// Of at least one sample. Its cost does not grow with the window.
    MeanHistogram mean() const;

    /// Writes or reads the samples so far; bins and window are not part of it.
    void archive(auto& archive) { archive(entries_, sum_, samples_, older_, newer_); }

  private:
    // Sums that two sets of values add up to those of both (Chan, Golub and LeVeque 1983).
    struct Moments {
        double count = 0.0, mean = 0.0, squares = 0.0;
        void join(const Moments& other);
        void archive(auto& archive) { archive(count, mean, squares); }
    };
    struct Entry {
        double time = 0.0;
        Histogram histogram;
        Moments moments;
        void archive(auto& archive) { archive(time, histogram, moments); }
    };
    static Moments moments_of(const Eigen::ArrayXd& values);
    void drop_first();

    Bins bins_;
    std::optional<double> window_;
    std::deque<Entry> entries_;  // those of the window; none without one
    Histogram sum_;              // of all samples that count
    double samples_ = 0.0;
    // Moments can be joined, not taken apart without loss: a queue of two stacks. Of the older
    // entries those from each one on, the first at the end; of the newer all together.
    std::vector<Moments> older_;
    Moments newer_;
};

}  // namespace carom
