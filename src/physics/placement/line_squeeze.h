// Where beads of infinite mass leave no room on a line: they can neither pass nor yield, so that
// two of them that meet, or beads that one presses against another or against the end of the line,
// have no motion that goes on. They move by themselves alone, so that this is known beforehand.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "physics/gas.h"
#include "physics/particles.h"
#include "physics/placement/problem.h"
#include "physics/run.h"

namespace carom {

/// What stands for a particle where the line ends.
inline constexpr Eigen::Index left_end = -1, right_end = -2;

/// The first squeeze of a run from `start` on, if there is one up to its end: its `particle` and
/// `other` are two beads of infinite mass between which the room ends, the left one first, or an
/// end of the line; its species is that of the bead listed last.
std::optional<Problem> first_squeeze(const Box& box, const Particles& particles,
                                     const Sample& start, const Run& run);

}  // namespace carom
