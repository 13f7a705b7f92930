// How hexagonal the order of disks is: the mean of e^(6 i phi) over the directions phi to the
// neighbours of a disk (Halperin and Nelson 1978).
#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "physics/gas.h"
#include "physics/particles.h"

namespace carom {

/// Neighbours are disks whose centres are nearer than this in units of the sum of their radii.
inline constexpr double neighbour_distance = 1.4;

/// Of each disk of a plane the mean over its neighbours; 0 of one without any.
Eigen::ArrayXcd bond_order(const Box& box, const Particles& particles,
                           const Eigen::ArrayXXd& positions);

}  // namespace carom
