// Directions for particles of given speeds whose momenta must sum to zero, because the box
// conserves the total, and directions drawn at random. The speeds stay as they are. Independent of
// species and positions.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "physics/vec.h"
#include "util/random.h"

namespace carom {

/// A direction in the plane, as an angle: uniform in [0, 2 pi].
double random_angle(Random& random);

/// A direction in space, as a unit vector, uniform on the sphere: its z is uniform in [-1, 1],
/// since zones of equal height have equal areas (Archimedes).
Vec random_direction(Random& random);

/// Turns directions, given as angles, until the momenta sum to zero along the chosen axes (x, y),
/// to within rounding. `momenta`: their lengths, of which at least one is above 0. Returns false
/// and changes nothing if that is impossible: along all axes if one momentum is larger than the
/// sum of the others. Along fewer axes it is always possible.
///
/// Two or three momenta along all axes have directions that differ only by a rotation and a
/// reflection, which are random. In all other cases the directions, which should be independent and
/// uniform, are turned as little as possible (by the least sum of squares, in Newton steps); their
/// distribution remains symmetric under rotations that the axes allow, reflections, and exchanges
/// of equal momenta. If that fails, as it may close to the limit of what is possible, the
/// directions form a triangle, turned at random, or are drawn across the axes.
bool balance_angles(const Eigen::ArrayXd& momenta, const std::array<bool, 2>& axes, Random& random,
                    Eigen::ArrayXd& angles);

/// The same in space, for directions given as unit vectors.
bool balance_directions(const Eigen::ArrayXd& momenta, const std::array<bool, 3>& axes,
                        Random& random, std::vector<Vec>& directions);

/// How many of some beads with the same momentum move to the right.
struct EqualMomenta {
    double momentum;
    std::int64_t count, to_the_right;
};

/// Chooses how many beads of each momentum move to the right so that all momenta sum to zero (to
/// within 1e-12 of the sum of their lengths), with as many to the left where that is possible.
/// Returns false if no choice is found: there is none, or two million sums do not decide it.
bool balance_signs(std::vector<EqualMomenta>& groups, Random& random);

}  // namespace carom
