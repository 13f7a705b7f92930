// Places beads on a line: at listed positions, evenly spaced, or at random without overlap.
// Positions are not found by trial; each bead gets a share of the free length, so a line can be
// filled completely. placement.h calls it for one-dimensional gases.
#pragma once

#include "physics/particles.h"

namespace carom {

struct Gas;

/// Sets the positions in `start` of the particles of a one-dimensional gas for which
/// placement_problems() has found no problem. Random arrangements are uniformly distributed over
/// all possible ones (the gaps in a stretch are uniform, the order is random). Where beads placed
/// before divide the line, each bead goes into a stretch with a probability proportional to the
/// room left there. Throws PlacementError.
void place_on_line(const Gas& gas, const Particles& particles, Sample& start);

}  // namespace carom
