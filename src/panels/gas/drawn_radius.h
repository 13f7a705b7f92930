// How large the disks of a gas are drawn.
#pragma once

#include <Eigen/Core>
#include <algorithm>

#include "physics/particles.h"
#include "scene/scene.h"

namespace carom {

/// The radii with which the disks of a scene in a plane are drawn, as lengths; never less than
/// their own. May be called from any thread.
inline Eigen::ArrayXd drawn_radius(const Scene& scene, const Particles& particles) {
    Eigen::ArrayXd radius = particles.radius;
    for (Eigen::Index i = 0; i < radius.size(); ++i) {
        const auto species = static_cast<std::size_t>(particles.species[i]);
        radius[i] = std::max(radius[i], scene.looks[species].drawn_radius.value_or(radius[i]));
    }
    return radius;
}

}  // namespace carom
