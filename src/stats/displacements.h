// The displacements of particles since a given time, continued through periodic sides, and the
// least-squares straight line through points.
#pragma once

#include <Eigen/Core>
#include <span>

#include "physics/simulation.h"

namespace carom {

/// Follows the displacements of all particles since the first sample at or after a time.
class Displacements {
  public:
    Displacements(const Box& box, double from) : box_(box), from_(from) {}

    /// Returns the displacements at a sample, N x d; NaN before the start time. Must be called for
    /// all samples in order of time, each with the collisions since the previous one.
    Eigen::ArrayXXd operator()(const Sample& sample, std::span<const Collision> collisions);

  private:
    void fly(Eigen::Index particle, double time, const Vec& after);

    Box box_;
    double from_;
    Eigen::ArrayXXd start_, moved_, velocity_;  ///< N x d
    Eigen::ArrayXd time_;  ///< of each particle's last collision, or of the sample
};

/// The straight line of least squares through points.
struct LineFit {
    double slope = 0.0;
    double mean_x = 0.0, mean_y = 0.0;  ///< a point on it
    double at(double x) const { return mean_y + slope * (x - mean_x); }
};

/// `x` and `y` must be of equal length; the slope is finite if at least two values of x differ.
LineFit fit_line(std::span<const double> x, std::span<const double> y);

}  // namespace carom
