// Quantities of a particle along a piece of its path.
#pragma once

#include <array>
#include <functional>

#include "stats/paths/paths.h"

namespace carom {

/// A quantity along a piece of a path: a polynomial of the time since `from`, or its root.
struct Course {
    double from = 0.0, to = 0.0;
    std::array<double, 3> coefficients{};  ///< of the powers 0, 1 and 2
    bool is_root = false;

    double polynomial(double since) const {
        return coefficients[0] + since * (coefficients[1] + since * coefficients[2]);
    }
    double value(double since) const;
};

/// The square of the speed times a factor; 0 of a particle at rest, whatever the factor.
Course square_of_speed(const PathPiece& piece, double factor);

/// The position along an axis, continued beyond the box if that is periodic.
Course course_of_place(const PathPiece& piece, Eigen::Index axis);

/// Calls `take` for the parts of the course of a position in a box of this period; 0 if it has
/// walls.
void courses_in_box(const Course& place, double period,
                    const std::function<void(const Course&)>& take);

}  // namespace carom
