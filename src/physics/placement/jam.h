// Detects rows of particles without any free room: from wall to wall, around a periodic box or
// between infinite masses, each touching the next. A particle that moves along such a row collides
// endlessly before any time has passed. Only rows along the sides of the box are considered, at the
// start of a run.
#pragma once

#include <optional>

#include "physics/box.h"
#include "physics/particles.h"
#include "physics/placement/problem.h"

namespace carom {

/// The first particle that moves along a row in which nothing can move, if there is one; the kind
/// of problem is jam, or jam_alone if the particle is the whole row. A velocity that is NaN counts
/// as different from all others.
std::optional<Problem> first_jam(const Box& box, const Particles& particles, const Sample& start);

}  // namespace carom
