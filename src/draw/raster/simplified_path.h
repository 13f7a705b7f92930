// Paths of fewer corners that look the same.
#pragma once

#include <span>
#include <vector>

#include "draw/geometry.h"

namespace carom {

/// The points of a path without those that lie within `tolerance` of a straight line between two
/// that are left. The first and the last one are. What is taken of a path does not change when
/// points are added to its end, except for the last one. In a time that grows as the number of
/// points. By the cone of directions in which all points so far are passed within the tolerance
/// (J. Sklansky and V. Gonzalez, Pattern Recognition 12, 327 (1980)).
std::vector<Point> simplified(std::span<const Point> path, double tolerance);

}  // namespace carom
