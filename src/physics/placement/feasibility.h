// Whether a gas can be placed and can move: the one place where that is decided, before anything is
// placed and for what has been placed.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "physics/gas.h"
#include "physics/particles.h"
#include "physics/placement/problem.h"
#include "physics/run.h"

namespace carom {

/// What keeps the particles of `gas`, with the radii drawn for them, from being placed: disks too
/// large for the box, too many for its area, for a region or for a lattice, listed places outside
/// or that overlap. A particle that overlaps others is named once. Nothing found is no promise:
/// random places are found, or not, by trying. After `most_compared` pairs of disks the search for
/// overlaps ends.
std::vector<Problem> placement_problems(
    const Gas& gas, const Particles& particles,
    std::int64_t most_compared = std::numeric_limits<std::int64_t>::max());

/// What keeps placed particles from moving: beads of infinite mass that leave no room on a line
/// before the run ends (line_squeeze.h), or a particle that moves where it has no room (jam.h).
std::optional<Problem> motion_problem(const Box& box, const Particles& particles,
                                      const Sample& start, const Run& run);

/// All that is known of a gas before it is placed: what cannot be drawn or placed, and where there
/// is a `run` and nothing else is wrong, what could not move, as far as places are known: those
/// listed, those of a line that is full, disks as wide as the box, a species on a lattice.
std::vector<Problem> problems_of(const Gas& gas, const Run* run, std::int64_t most_compared);

}  // namespace carom
