// The mean of histograms over time: of the present sample alone, of the time since the start, or of
// a while before the present. With it the mean and deviation of the values. For the bars of the
// histogram panels; see histogram.h for the others.
#pragma once

#include <Eigen/Core>
#include <deque>
#include <optional>
#include <vector>

#include "stats/histogram.h"

namespace carom {

/// Mean counts in bins over a time, and the moments of all finite values in it.
struct MeanHistogram {
    Bins bins;
    std::vector<double> counts = {};  ///< one for each bin
    double below = 0.0, above = 0.0;
    double mean = 0.0;       ///< of them; NaN where there are none
    double deviation = 0.0;  ///< root of the mean square about the mean
    void archive(auto& archive) { archive(bins, counts, below, above, mean, deviation); }
};

class RunningHistogram {
  public:
    /// Means over time since the first sample, or over `window` before the last one; with a window
    /// shorter than the time between samples, of the last one alone. Between two samples half of
    /// the time counts for each (trapezoidal rule): more samples in some parts of the time do not
    /// change the mean.
    RunningHistogram(const Bins& bins, std::optional<double> window);

    /// The next sample; times must not fall. Its cost does not grow with the window.
    void add(double time, const Eigen::ArrayXd& values);

    /// Of at least one sample. Its cost does not grow with the window.
    MeanHistogram mean() const;

    /// Writes or reads the samples so far; bins and window are not part of it.
    void archive(auto& archive) { archive(pieces_, sum_, last_, time_, older_, newer_); }

  private:
    // Sums that two sets of values add up to those of both (Chan, Golub and LeVeque 1983).
    struct Moments {
        double count = 0.0, mean = 0.0, squares = 0.0;  ///< times weights
        void join(const Moments& other);
        void archive(auto& archive) { archive(count, mean, squares); }
    };
    struct Sampled {
        Histogram histogram;
        Moments moments;
        void archive(auto& archive) { archive(histogram, moments); }
    };
    // The time between two samples, with both.
    struct Piece {
        double end = 0.0, weight = 0.0;
        Sampled both;
        void archive(auto& archive) { archive(end, weight, both); }
    };
    struct Sum {
        std::vector<double> counts;
        double below = 0.0, above = 0.0, weight = 0.0;
        void add(const Piece& piece, double sign);
        void archive(auto& archive) { archive(counts, below, above, weight); }
    };
    static Moments moments_of(const Eigen::ArrayXd& values);
    void add_piece(double time, const Sampled& now);
    void drop_first();
    Moments moments() const;

    Bins bins_;
    std::optional<double> window_;
    std::deque<Piece> pieces_;  // of the window; none without one
    Sum sum_;                   // of all pieces that count
    Sampled last_;
    std::optional<double> time_;  // of the last sample
    // Moments can be joined, not taken apart without loss: a queue of two stacks. Of the older
    // pieces those from each one on, the first at the end; of the newer all together.
    std::vector<Moments> older_;
    Moments newer_;
};

}  // namespace carom
