// When a particle is in a region of a box along a piece of its path: exact times, not from samples.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "physics/box.h"
#include "stats/paths/paths.h"

namespace carom {

/// Whether a place, or its image in the box, is in a region; regions are closed at their lower
/// sides and open at the upper ones, which may be infinite.
bool is_in(const Box& box, const Region& region, const Vec& place);

/// A part of a piece, by times since its start, in which the particle is in the region or not.
struct Stay {
    double from = 0.0, to = 0.0;
    bool is_inside = false;
};

/// Replaces `stays` by those of a piece, in order of time; each is longer than 0.
void find_stays(const Box& box, const Region& region, const PathPiece& piece,
                std::vector<Stay>& stays);

}  // namespace carom
