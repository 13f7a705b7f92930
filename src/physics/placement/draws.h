// Radii, masses and velocities, drawn from the species' rules and the gas's seed.
// Does not place anything (placement.h).
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "physics/gas.h"
#include "physics/particles.h"
#include "physics/placement/problem.h"

namespace carom {

/// Which rules of a species give one value for all of its particles or one for each, as the
/// functions here and place() take for granted.
struct FittingRules {
    bool radius, mass, velocity, position;
};
FittingRules fitting_rules(const Species& species);

/// All particles of a gas with their velocities; their places are zero. Species with a speed or a
/// temperature have no total momentum along periodic axes, unless they have one particle only.
/// Throws PlacementError.
std::pair<Particles, Sample> draw_gas(const Gas& gas);

/// The same without throwing: adds to `problems` what cannot be drawn, one for a species. Its
/// particles have radius 0, mass 1 or velocity 0 then; there are none at all where a gas has too
/// many.
std::pair<Particles, Sample> draw_gas(const Gas& gas, std::vector<Problem>& problems);

/// The same, or nothing for a gas that cannot be drawn: also if a rule does not fit the number of
/// particles.
std::optional<std::pair<Particles, Sample>> try_draw_gas(const Gas& gas);

}  // namespace carom
