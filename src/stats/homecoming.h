// How near a reversed gas comes to where it started.
#pragma once

#include "physics/gas.h"
#include "physics/particles.h"

namespace carom {

/// Distances of all particles from their places in another state, as lengths.
struct ReturnDistance {
    double largest = 0.0;
    double root_mean_square = 0.0;
};

/// Compares the positions of two states of one gas; across periodic borders the nearest image
/// counts.
ReturnDistance return_distance(const Box& box, const Sample& start, const Sample& end);

}  // namespace carom
