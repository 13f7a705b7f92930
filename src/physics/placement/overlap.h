// Searches a whole state for overlapping particles: an independent check of the simulation, which
// looks only at pairs that collide.
#pragma once

#include "physics/box.h"
#include "physics/particles.h"

namespace carom {

/// The deepest overlap of two particles, 1 - distance / contact distance, dimensionless; 0 when
/// none overlap. Points have no contact distance and never overlap.
double largest_relative_overlap(const Box& box, const Particles& particles, const Sample& sample);

}  // namespace carom
