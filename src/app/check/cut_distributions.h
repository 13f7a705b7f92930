// The part of a report about distributions that carom cannot draw from as they are written: normal
// distributions of quantities that are never negative.
#pragma once

#include <vector>

#include "app/report/facts.h"
#include "physics/units/quantity.h"

namespace carom {

struct Gas;

/// The normal distributions of a gas of which more than 1 % is below 0, in order of its species: of
/// whom, and what is drawn instead.
std::vector<ListItem> cut_distributions(const Gas& gas, UnitSystem units);

}  // namespace carom
