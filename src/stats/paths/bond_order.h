// The hexagonal bond-orientational order of disks: the mean of e^(6 i phi) over the directions phi
// from a disk to its neighbours (Halperin and Nelson 1978).
#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "physics/box.h"
#include "physics/particles.h"

namespace carom {

/// Disks are neighbours if the distance of their centres is less than this many times the sum of
/// their radii.
inline constexpr double neighbour_distance = 1.4;

/// For each disk of a two-dimensional gas, the mean over its neighbours (dimensionless); 0 for a
/// disk without neighbours. `positions` are N x 2.
Eigen::ArrayXcd bond_order(const Box& box, const Particles& particles,
                           const Eigen::ArrayXXd& positions);

}  // namespace carom
