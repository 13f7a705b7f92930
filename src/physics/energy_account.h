// Where the energy of a gas in a box with surfaces is, from its state alone.
#pragma once

#include <span>

#include "physics/gas.h"
#include "physics/particles.h"
#include "physics/surface.h"

namespace carom {

/// The energies of a moment, with the heat that baths have given since t = 0; without the work of
/// driven surfaces, the heat of events and their error, which only a simulation knows: the error is
/// 0, or none where there can be none. `states` as Simulation::surfaces() gives them. Infinite
/// masses are not counted, and without gravity no positions need be there.
EnergyAccount energies(const Box& box, const Particles& particles, const Sample& sample,
                       std::span<const SurfaceState> states);

}  // namespace carom
