// Creates the particles of a gas from its rules: positions without overlap, radii, masses and
// velocities, all determined by the seed of the gas. place() may be called from any thread.
#pragma once

#include <utility>

#include "physics/particles.h"
#include "physics/placement/problem.h"

namespace carom {

struct Gas;

/// The particles of `gas` and their state at time 0. Throws PlacementError.
std::pair<Particles, Sample> place(const Gas& gas);

}  // namespace carom
