// Where particles fill a line without any room: those that stand in a row from wall to wall, around
// a periodic box or between infinite masses, each touching the next. What moves along it collides
// without end before any time has passed. Rows along the sides of the box, at the start of a run.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "physics/gas.h"
#include "physics/particles.h"

namespace carom {

/// A particle that moves along a row in which nothing can.
struct Jam {
    Eigen::Index particle;
    bool alone;  ///< it is the whole row
};

/// The first jam, if there is one. A velocity that is not a number is taken for one that differs
/// from all others.
std::optional<Jam> first_jam(const Box& box, const Particles& particles, const Sample& start);

/// One sentence about it, without the way out; `particle` is how it is called.
std::string to_text(const Jam& jam, const std::string& particle, int dimension);

/// The way out of it.
std::string way_out_of_jam(int dimension);

}  // namespace carom
