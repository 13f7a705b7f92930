// Along which axes all places are alike for a gas, so that means over such an axis lose nothing.
#pragma once

#include <array>
#include <vector>

#include "physics/run.h"

namespace carom {

struct Gas;

/// Along an even axis the mean of every quantity of a gas is the same at all places at any time of
/// its run, but for a layer at its sides: neither the box and its events nor the start tell one
/// place from another. Sides across it reflect or are periodic, all that acts on the gas does so
/// along its whole length, and all particles are thrown over it. None is even if some of the
/// particles are so few that they are seen one by one, or if the gas may order itself: if it may
/// freeze, or rolls of convection may form in it because baths of different temperatures act on
/// it in gravity. On a line none is.
std::array<bool, 3> even_axes(const Gas& gas, const std::vector<RunEvent>& events);

}  // namespace carom
