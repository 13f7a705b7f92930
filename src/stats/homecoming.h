// How near a reversed gas comes to where it started, as far as doubles tell (physics/whereabouts.h:
// in full).
#pragma once

#include "physics/exact_positions.h"
#include "physics/gas.h"
#include "physics/particles.h"

namespace carom {

/// Compares the positions of two states of one gas; across periodic borders the nearest image
/// counts.
ReturnDistance return_distance(const Box& box, const Sample& start, const Sample& end);

}  // namespace carom
