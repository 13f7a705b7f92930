// Detects where beads of infinite mass leave no room on a line. They can neither pass nor yield, so
// the motion cannot continue if two of them meet, or if one presses other beads against another
// infinite mass or the end of the line. Their motion does not depend on the other beads, so this is
// known before the simulation.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "physics/box.h"
#include "physics/particles.h"
#include "physics/placement/problem.h"
#include "physics/run.h"

namespace carom {

/// Used in place of a particle number for the ends of the line.
inline constexpr Eigen::Index left_end = -1, right_end = -2;

/// The first squeeze before the end of a run that begins with `start`, if any. Its `particle` and
/// `other` are the two beads of infinite mass between which the room vanishes, the left one first;
/// either may be an end of the line. Its species is that of the bead listed last.
std::optional<Problem> first_squeeze(const Box& box, const Particles& particles,
                                     const Sample& start, const Run& run);

}  // namespace carom
