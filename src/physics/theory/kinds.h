// Classification of particles by their mechanical properties. Species and their names play no role:
// the gas is the same however its particles are listed and named.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "physics/particles.h"

namespace carom {

/// Particles sorted into kinds.
struct Kinds {
    Eigen::ArrayXi of;         ///< N, the kind of each particle
    std::vector<int> members;  ///< how many particles each kind has
};

/// Particles of equal mass and radius form one kind. All particles of finite mass that have no
/// equal, as when radii are drawn from a distribution, form one kind together. Kinds are numbered
/// in the order of their first particles.
Kinds kinds_of(const Particles& particles);

}  // namespace carom
