// The bond-orientational order of disks and spheres: of the directions from a particle to its
// neighbours.
#pragma once

#include <Eigen/Core>

#include "physics/box.h"
#include "physics/particles.h"

namespace carom {

/// Particles are neighbours if the distance of their centres is less than this many times the sum
/// of their radii.
inline constexpr double neighbour_distance = 1.4;

/// The order of each particle, N x components, dimensionless: means over its neighbours, 0 for a
/// particle without. In a plane there is one component, e^(6 i phi) with the angle phi of the
/// direction (hexagonal order, Halperin and Nelson 1978). In space there are seven, those spherical
/// harmonics Y_6m with m from 0 to 6 times sqrt(4 pi / 13), for m > 0 times another sqrt(2)
/// (Steinhardt, Nelson and Ronchetti, Phys. Rev. B 28, 784, 1983): harmonics with negative m are
/// their conjugates. The absolute value of all components of a particle is its q6: 0.575 among the
/// twelve neighbours of a cubic close packing, 1 at most. `positions` are N x dimension, with two
/// or three dimensions.
Eigen::ArrayXXcd bond_order(const Box& box, const Particles& particles,
                            const Eigen::ArrayXXd& positions);

/// The order of a whole gas: the absolute value of the mean of the order of each.
double global_order(const Eigen::ArrayXXcd& order);

/// The mean of the absolute values of the order of each.
double local_order(const Eigen::ArrayXXcd& order);

}  // namespace carom
