// How large the disks of a gas are drawn.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "physics/particles.h"
#include "scene/looks.h"

namespace carom {

/// The radii with which the disks of a gas in a plane are drawn, as lengths; never less than their
/// own. `looks`: one for each species. May be called from any thread.
inline Eigen::ArrayXd drawn_radius(const std::vector<SpeciesLook>& looks,
                                   const Particles& particles) {
    Eigen::ArrayXd radius = particles.radius;
    for (Eigen::Index i = 0; i < radius.size(); ++i) {
        const auto species = static_cast<std::size_t>(particles.species[i]);
        radius[i] = std::max(radius[i], looks[species].drawn_radius.value_or(radius[i]));
    }
    return radius;
}

}  // namespace carom
