// Radii, masses and velocities, drawn from the species' rules and the gas's seed.
// Does not place anything (placement.h).
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <utility>
#include <vector>

#include "physics/gas.h"
#include "physics/particles.h"
#include "physics/placement/problem.h"

namespace carom {

/// Whether every list gives one value for each particle of its species, which all functions here
/// and place() take for granted.
bool lists_fit(const Gas& gas);

/// All particles of a gas with their velocities; their places are zero. Throws PlacementError.
std::pair<Particles, Sample> draw_gas(const Gas& gas);

/// The same without throwing: adds to `problems` what cannot be drawn, one for a species. Its
/// particles have radius 0, mass 1 or velocity 0 then; there are none at all where a gas has too
/// many.
std::pair<Particles, Sample> draw_gas(const Gas& gas, std::vector<Problem>& problems);

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
