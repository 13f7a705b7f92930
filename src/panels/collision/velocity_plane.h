// The plane of the velocities of two beads, where a picture shows it: by equal scales on both axes,
// 0 in the middle. Draws nothing but lines in it.
#pragma once

#include <span>

#include "panels/panel.h"

namespace carom {

struct VelocityPlane {
    Rect area;
    Eigen::Array2d factor;  ///< of each velocity: 1, or the root of its mass
    double scale = 1.0;     ///< pixels of a unit

    /// Where a velocity is.
    Point operator()(const Eigen::Array2d& velocity) const;
    Scale across() const;
    Scale up() const;

    /// A line through a velocity across the whole plane.
    void draw_line(Canvas& canvas, const Eigen::Array2d& through, const Eigen::Array2d& direction,
                   double width, Color color, std::span<const double> dashes) const;
};

/// Pixels of a unit in an area that shows velocities up to `reach` and a little more.
double scale_in(const Rect& area, const Eigen::Array2d& reach);

}  // namespace carom
