// The exact time that something moving along a line spends in each of many bins; not from samples.
#pragma once

#include <vector>

namespace carom {

/// A stretch of motion with constant acceleration.
struct MotionStretch {
    double place = 0.0, velocity = 0.0, acceleration = 0.0;
    double duration = 0.0;

    double place_after(double time) const {
        return place + (velocity + 0.5 * acceleration * time) * time;
    }
};

/// Times in bins of equal width, whose edges are multiples of the width. The width doubles whenever
/// the motion reaches so far that there would be more than `most_bins` on either side of 0.
class Residence {
  public:
    static constexpr int most_bins = 8192;

    explicit Residence(double width) : width_(width) {}

    void add(const MotionStretch& stretch);

    /// The present width of the bins.
    double width() const { return width_; }
    /// The time in each bin, from the lowest bin reached (or the bin that begins at 0, if lower) to
    /// the highest.
    const std::vector<double>& times() const { return times_; }
    /// The number of the first of these bins: 0 for the one that begins at 0, negative for lower
    /// ones.
    int first() const { return first_; }

    void archive(auto& archive) { archive(width_, first_, times_); }

  private:
    void add_monotone(const MotionStretch& stretch);
    void make_room(double place);
    void add(double place, double time);

    double width_;
    int first_ = 0;
    std::vector<double> times_;
};

}  // namespace carom
