// Places of beads on a line: listed, evenly spaced, or random with no overlap. A bead never tries
// places: it gets a share of the free room, so that a line can be filled to the last bit.
// placement.h calls it for gases of one dimension.
#pragma once

#include "physics/gas.h"
#include "physics/particles.h"

namespace carom {

/// Sets the positions in `start` of the particles of a one-dimensional gas, of which
/// placement_problems() has found none. Beads at random places are uniform over all arrangements
/// (the gaps of one stretch are uniform, the order is random); where beads placed before divide the
/// line, each goes into a stretch with a chance proportional to the room left there. Throws
/// PlacementError.
void place_on_line(const Gas& gas, const Particles& particles, Sample& start);

}  // namespace carom
