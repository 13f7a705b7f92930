// Decides whether a gas can be placed and can move. It is the only place where that is decided,
// both before placement and for particles that have been placed.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "physics/box.h"
#include "physics/particles.h"
#include "physics/placement/problem.h"
#include "physics/run.h"

namespace carom {

struct Gas;

/// The reasons why the particles of `gas`, with the radii drawn for them, cannot be placed:
/// particles too large for the box; too many for its size, for a region or for a lattice; listed
/// positions outside the box or overlapping. A particle that overlaps several others is reported
/// once. An empty result is no guarantee, because random positions are found by trial. The search
/// for overlaps ends after `most_compared` pairs of particles.
std::vector<Problem> placement_problems(
    const Gas& gas, const Particles& particles,
    std::int64_t most_compared = std::numeric_limits<std::int64_t>::max());

/// The reason why placed particles cannot move, if any: beads of infinite mass on a line that leave
/// no room before the end of the run (line_squeeze.h), or a moving particle that has no room
/// (jam.h).
std::optional<Problem> motion_problem(const Box& box, const Particles& particles,
                                      const Sample& start, const Run& run);

/// All problems that are known before placement: what cannot be drawn or placed and, if there is a
/// `run` and no other problem, what could not move. The latter is checked as far as positions are
/// known in advance: those that are listed, those on a line that is full, those as wide as the box,
/// and a species on a lattice.
std::vector<Problem> problems_of(const Gas& gas, const Run* run, std::int64_t most_compared);

}  // namespace carom
