// Which particles of a gas are alike as mechanics sees them. The names of species say nothing here:
// a gas stays the same gas however its particles are listed and called.
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

/// Particles of equal mass and radius are one kind. Those of finite mass of which there is no
/// second, as where radii are drawn from a distribution, are one kind together. Kinds are numbered
/// in the order of their first particles.
Kinds kinds_of(const Particles& particles);

}  // namespace carom
