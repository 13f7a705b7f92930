// Paths simplified to fewer corners that look the same.
#pragma once

#include <span>
#include <vector>

#include "draw/geometry.h"

namespace carom {

/// Returns the points of a path without those that lie within `tolerance` of a straight line
/// between two of the remaining points; the first and the last point remain. Appending points to a
/// path does not change the selection from the points before them, except for the last one. Linear
/// time: the algorithm tracks the cone of directions in which a line passes all points so far
/// within the tolerance (J. Sklansky and V. Gonzalez, Pattern Recognition 12, 327 (1980)).
std::vector<Point> simplified(std::span<const Point> path, double tolerance);

}  // namespace carom
