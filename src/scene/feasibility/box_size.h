// The size of a box that a scene gives by its shape and the pressure of the gas in it.
#pragma once

#include <vector>

#include "scene/reading/gas_reading.h"

namespace carom {

/// Multiplies the size of a box, which is its shape, by the factor that gives the gas its pressure
/// in equilibrium (scale_at_pressure()), at the kinetic temperature of all particles: that of the
/// species' temperatures, speeds and velocities, before any is drawn, so that it does not depend
/// on the seed. Does nothing to a box without a pressure. Returns false if the size remains
/// unknown, which is reported.
bool size_by_pressure(BoxDraft& box, const std::vector<SpeciesDraft>& species, Errors& errors);

}  // namespace carom
