// The energy balance of a gas in a box with surfaces, as far as it follows from the present state.
#pragma once

#include <span>

#include "physics/box.h"
#include "physics/particles.h"
#include "physics/surface.h"

namespace carom {

/// The energies of a state, and the heat given by baths since t = 0. The work of driven surfaces,
/// the heat of events and the numerical error are not included, as only a simulation knows them:
/// the relative error is set to 0, or unset if it cannot be defined. `states` is the result of
/// Simulation::surfaces(). Infinite masses are not counted. Without gravity the sample need not
/// contain positions.
EnergyAccount energies(const Box& box, const Particles& particles, const Sample& sample,
                       std::span<const SurfaceState> states);

}  // namespace carom
