// How probable a distance between two points in a box is: what pair correlations are relative to.
// All functions may be called from any thread.
#pragma once

#include <array>
#include <utility>

#include "physics/box.h"

namespace carom {

/// The positions of the sides of a box: (lower, upper) for each axis.
using BoxSides = std::array<std::pair<double, double>, 3>;
BoxSides sides_of(const Box& box);

/// The probability that two points, each distributed uniformly over the positions that the centre
/// of a particle of its radius (`radii`) can reach, are at a distance between `low` and `high`: in
/// a plane a ring, in space a shell. In periodic boxes the distance is that of the nearest images,
/// and must be at most half of the box. In space the relative error is below 1e-6.
double ring_probability(const Box& box, const BoxSides& sides, std::pair<double, double> radii,
                        double low, double high);

}  // namespace carom
