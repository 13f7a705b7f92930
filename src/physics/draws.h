// Radii, masses and velocities of one species, drawn from its rules and the gas's seed.
// Does not place anything (placement.h).
#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "physics/gas.h"

namespace carom {

/// `count` radii, length. Throws PlacementError where the rule gives none above zero.
Eigen::ArrayXd draw_radii(const Gas& gas, std::size_t species);

/// Inverse masses for particles of these radii; 0 for an infinite mass. Throws PlacementError where
/// the rule gives no mass above zero.
Eigen::ArrayXd draw_inverse_masses(const Gas& gas, std::size_t species,
                                   const Eigen::ArrayXd& radii);

/// Velocities, count x 2. Species with a speed or a temperature have no total momentum along
/// periodic axes, unless they have one particle only.
Eigen::ArrayXXd draw_velocities(const Gas& gas, std::size_t species,
                                const Eigen::ArrayXd& inverse_masses);

}  // namespace carom
