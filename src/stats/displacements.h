// How far particles have come since a time, on through periodic sides, and the straight line that
// fits a growth.
#pragma once

#include <Eigen/Core>
#include <span>

#include "physics/simulation.h"

namespace carom {

/// Follows the displacements of all particles since the first sample at or after a time.
class Displacements {
  public:
    Displacements(const Box& box, double from) : box_(box), from_(from) {}

    /// N x d, of a sample; all samples in order, with the collisions on the way. NaN before the
    /// time.
    Eigen::ArrayXXd operator()(const Sample& sample, std::span<const Collision> collisions);

  private:
    void fly(Eigen::Index particle, double time, const Eigen::Array2d& after);

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

/// Of as many values of each; the slope is finite if two of x differ.
LineFit fit_line(std::span<const double> x, std::span<const double> y);

}  // namespace carom
