// How long something that moves along a line is in each of many bins, exactly: not from samples.
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

/// Times in bins of equal width, whose edges are multiples of it. The width doubles as often as
/// what moves goes so far that there would be more than `most_bins` on either side of 0.
class Residence {
  public:
    static constexpr int most_bins = 8192;

    explicit Residence(double width) : width_(width) {}

    void add(const MotionStretch& stretch);

    /// At present.
    double width() const { return width_; }
    /// Of each bin, from the one at 0 or the lowest that was reached, up to the last.
    const std::vector<double>& times() const { return times_; }
    /// The number of the first of them: 0 for the one that begins at 0, or less.
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
