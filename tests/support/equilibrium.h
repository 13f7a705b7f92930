// The equilibrium of a gas that no event changes, for tests of distributions.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "physics/theory/boxed_gas.h"

namespace carom::test {

/// The equilibrium that the gas comes to, if it comes to one; of some species, if any are given.
inline std::optional<EquilibriumGas> equilibrium(const Box& box, const Particles& particles,
                                                 const Sample& sample,
                                                 const std::vector<int>& species = {}) {
    const BoxedGas boxed(box, {}, particles, sample);
    if (!boxed.equilibrium || species.empty()) return boxed.equilibrium;
    std::vector<Eigen::Index> chosen;
    for (Eigen::Index i = 0; i < particles.count(); ++i)
        if (std::ranges::find(species, particles.species[i]) != species.end()) chosen.push_back(i);
    return among(*boxed.equilibrium, particles, chosen);
}

}  // namespace carom::test
