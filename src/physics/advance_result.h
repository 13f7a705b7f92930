// What an advance of the simulation reports: collisions, their counts, and the momentum that they
// transferred.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>

#include "physics/exact_positions.h"

namespace carom {

/// One collision, as it happened.
struct Collision {
    double time;
    std::int32_t first;  ///< particle
    std::int32_t
        second;  ///< particle, or -1 - side for a wall (sides: left 0, right 1, bottom 2, top 3)
    Eigen::Array2d first_position;   ///< centre of `first` at contact; y is 0 in 1-D
    Eigen::Array2d second_position;  ///< centre of `second` (in a periodic box of its image that
                                     ///< touches `first`), or the point of contact on the wall
    Eigen::Array2d first_before, second_before;  ///< velocities; y is 0 in 1-D, a wall's are 0
    Eigen::Array2d first_after, second_after;
};

/// How many collisions have happened since t = 0.
struct CollisionCounts {
    std::int64_t particle = 0;  ///< between two particles
    std::int64_t wall = 0;      ///< of a particle with a wall
    std::int64_t ties = 0;      ///< pairs that shared a particle and an instant with the pair just
                                ///< before: their order is by number, not by physics
};

/// Momentum that has changed hands since t = 0, and how well contacts were met.
struct ImpulseTotals {
    std::array<double, 4> wall{};  ///< outward momentum given to each side: left, right, bottom,
                                   ///< top; infinite after a hit by an infinite mass
    double virial = 0.0;  ///< sum over collisions of two particles of r . dp: r from the first
                          ///< to the second, dp what the second received
    double largest_overlap = 0.0;  ///< depth at a collision of two particles, in units of their
                                   ///< contact distance; 0 when none was ever too late
};

/// What happened on the way to a time.
struct AdvanceResult {
    CollisionCounts counts;  ///< since t = 0, at the end of this advance
    ImpulseTotals impulses;  ///< since t = 0, at the end of this advance
    int reversals = 0;       ///< reversals since t = 0, those at its end included
    std::span<const Collision>
        collisions;  ///< of this advance only, when recording; valid until the next advance
    std::optional<ReturnDistance>
        return_distance;  ///< of the present positions from those at the mirror time, if
                          ///< Simulation::measure_return() asks for it at the present time
};

/// Told what time it is in a run, every some thousand events.
using TimeCallback = std::function<void(double time)>;

}  // namespace carom
