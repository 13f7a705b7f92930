// Where particles fill a line without any room: those that stand in a row from wall to wall, around
// a periodic box or between infinite masses, each touching the next. What moves along it collides
// without end before any time has passed. Rows along the sides of the box, at the start of a run.
#pragma once

#include <optional>

#include "physics/gas.h"
#include "physics/particles.h"
#include "physics/placement/problem.h"

namespace carom {

/// The first particle that moves along a row in which nothing can, if there is one: a jam, or
/// jam_alone where it is the whole row. A velocity that is not a number is taken for one that
/// differs from all others.
std::optional<Problem> first_jam(const Box& box, const Particles& particles, const Sample& start);

}  // namespace carom
