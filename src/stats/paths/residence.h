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

/// Times in bins of equal width from 0 on; places below 0 count as in the first.
class Residence {
  public:
    explicit Residence(double width) : width_(width) {}

    void add(const MotionStretch& stretch);

    double width() const { return width_; }
    /// Of each bin, up to the last that was reached.
    const std::vector<double>& times() const { return times_; }

    /// Writes or reads the times; the width is not part of it.
    void archive(auto& archive) { archive(times_); }

  private:
    void add_monotone(const MotionStretch& stretch);
    void add(double place, double time);

    double width_;
    std::vector<double> times_;
};

}  // namespace carom
