// Radii, masses and velocities, drawn from the species' rules and the gas's seed.
// Does not place anything (placement.h).
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <utility>

#include "physics/gas.h"
#include "physics/particles.h"

namespace carom {

/// All particles of a gas with their velocities; their places are zero. Throws PlacementError.
std::pair<Particles, Sample> draw_gas(const Gas& gas);

/// How a message calls a species: disks of species "cold", or beads in one dimension.
std::string particles_of(const Gas& gas, std::size_t species);

/// `count` radii, length. Throws PlacementError where the rule gives none above zero.
Eigen::ArrayXd draw_radii(const Gas& gas, std::size_t species);

/// Inverse masses for particles of these radii; 0 for an infinite mass. Throws PlacementError where
/// the rule gives no mass above zero.
Eigen::ArrayXd draw_inverse_masses(const Gas& gas, std::size_t species,
                                   const Eigen::ArrayXd& radii);

/// Velocities, count x dimension. Species with a speed or a temperature have no total momentum
/// along periodic axes, unless they have one particle only.
Eigen::ArrayXXd draw_velocities(const Gas& gas, std::size_t species,
                                const Eigen::ArrayXd& inverse_masses);

}  // namespace carom
