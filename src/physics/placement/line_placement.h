// Places of beads on a line: listed, evenly spaced, or random with no overlap. A bead never tries
// places: it gets a share of the free room, so that a line can be filled to the last bit.
// placement.h calls it for gases of one dimension.
#pragma once

#include <utility>

#include "physics/gas.h"
#include "physics/particles.h"

namespace carom {

/// The particles of a one-dimensional gas and their state at time 0. Beads at random places are
/// uniform over all arrangements (the gaps of one stretch are uniform, the order is random); where
/// beads placed before divide the line, each goes into a stretch with a chance proportional to the
/// room left there. Throws PlacementError.
std::pair<Particles, Sample> place_on_line(const Gas& gas);

}  // namespace carom
