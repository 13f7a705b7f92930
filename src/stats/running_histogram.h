// The mean of histograms over time: of the present sample only, over all time since the start, or
// over a window before the present; together with the mean and standard deviation of the values.
// Used for the bars of the histogram panels; see histogram.h for the other histograms.
#pragma once

#include <Eigen/Core>
#include <deque>
#include <numeric>
#include <optional>
#include <vector>

#include "stats/histogram.h"

namespace carom {

/// Mean counts in bins over a time, and the mean and deviation of all finite values in it.
struct MeanHistogram {
    Bins bins;
    std::vector<double> counts = {};  ///< one for each bin
    double below = 0.0, above = 0.0;
    double mean = 0.0;       ///< of all finite values; NaN if there are none
    double deviation = 0.0;  ///< standard deviation: the root of the mean square about the mean
    void archive(auto& archive) { archive(bins, counts, below, above, mean, deviation); }

    /// The number of all values, with those beyond the bins.
    double values() const { return std::accumulate(counts.begin(), counts.end(), below + above); }
};

class RunningHistogram {
  public:
    /// Averages over the time since the first sample, or over `window` before the last one; if the
    /// window is shorter than the time between samples, only the last sample counts. The
    /// trapezoidal rule weights samples (half of the time between two samples for each), so that
    /// denser samples in some parts of the time do not change the mean.
    RunningHistogram(const Bins& bins, std::optional<double> window);

    /// Takes the next sample; times must not decrease. The cost does not grow with the window.
    void add(double time, const Eigen::ArrayXd& values);

    /// The mean histogram; requires at least one sample. The cost does not grow with the window.
    MeanHistogram mean() const;

    /// Writes or reads the samples so far; bins and window are not part of it.
    void archive(auto& archive) { archive(pieces_, sum_, last_, time_, older_, newer_); }

  private:
    // Moments that can be combined: those of two sets of values give those of the union (Chan,
    // Golub and LeVeque 1983).
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
    // An interval between two samples, with the sums of both samples.
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
    std::deque<Piece> pieces_;  // the pieces in the window; empty without a window
    Sum sum_;                   // of all pieces that count
    Sampled last_;
    std::optional<double> time_;  // of the last sample
    // Moments can be combined but not subtracted without loss, so the window is a queue made of two
    // stacks. `older_` holds, for each older piece, the moments from that piece to the end of the
    // older ones, with the oldest piece at the back; `newer_` holds the moments of all newer pieces
    // together.
    std::vector<Moments> older_;
    Moments newer_;
};

}  // namespace carom
