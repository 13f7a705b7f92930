// Draws radii, masses and velocities from the rules of the species and the seed of the gas.
// Positions are drawn elsewhere (placement.h).
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "physics/particles.h"
#include "physics/placement/problem.h"

namespace carom {

struct Gas;
struct Species;

/// Which rules of a species have the right number of values, one for all of its particles or one
/// for each. The functions here and place() require that.
struct FittingRules {
    bool radius, mass, velocity, position;
};
FittingRules fitting_rules(const Species& species);

/// The number of particles of all species together.
std::int64_t total_count(const Gas& gas);

/// Draws all particles of a gas and their velocities. Their positions are those that are listed, if
/// all are, otherwise zero. Along periodic axes
/// a species with a temperature has no total momentum, unless it has only one particle. Where
/// momentum is conserved (conserves_momentum()), the momenta of all particles with a speed sum to
/// zero, while each keeps its speed (directions.h). Throws PlacementError, also if that is
/// impossible.
std::pair<Particles, Sample> draw_gas(const Gas& gas);

/// The same without throwing: appends what cannot be drawn to `problems`, one entry per species.
/// The particles concerned then have radius 0, mass 1 or velocity 0; if the gas has too many
/// particles, none are drawn.
std::pair<Particles, Sample> draw_gas(const Gas& gas, std::vector<Problem>& problems);

/// The same, or nothing if the gas cannot be drawn, for instance if a rule does not fit the number
/// of particles.
std::optional<std::pair<Particles, Sample>> try_draw_gas(const Gas& gas);

}  // namespace carom
