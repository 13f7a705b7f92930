// How large the disks of a gas are drawn.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <limits>
#include <vector>

#include "physics/membership.h"
#include "scene/looks.h"

namespace carom {

/// The radii with which the disks of a gas in a plane are drawn, as lengths; never less than their
/// own. `looks`: one for each species; `species`: of each particle. May be called from any thread.
inline Eigen::ArrayXd drawn_radius(const std::vector<SpeciesLook>& looks,
                                   const Particles& particles, const Eigen::ArrayXi& species) {
    Eigen::ArrayXd radius = particles.radius;
    for (Eigen::Index i = 0; i < radius.size(); ++i) {
        const auto its = static_cast<std::size_t>(species[i]);
        radius[i] =
            std::max(radius[i], looks[its].drawn_radius.value_or(looks[its].scale * radius[i]));
    }
    return radius;
}

/// The same at the time of a sample, with what is asked of all of them.
struct DrawnRadii {
    Eigen::ArrayXd of;                     ///< of each particle; NaN of one that is absent
    double smallest = 0.0, largest = 0.0;  ///< of these
    Eigen::Index count = 0;                ///< of those that are present
    bool enlarges = false;                 ///< draws some larger than they are

    DrawnRadii(const std::vector<SpeciesLook>& looks, const Particles& particles,
               const Sample& sample)
        : of(drawn_radius(looks, particles, species_at(sample, particles))) {
        smallest = std::numeric_limits<double>::infinity();
        for (Eigen::Index i = 0; i < of.size(); ++i) {
            if (!is_present(sample, i)) {
                of[i] = std::numeric_limits<double>::quiet_NaN();
                continue;
            }
            ++count;
            smallest = std::min(smallest, of[i]);
            largest = std::max(largest, of[i]);
            enlarges = enlarges || of[i] > particles.radius[i];
        }
    }

    /// The number of disks with a smaller radius. Asked in every frame; mostly all or none.
    Eigen::Index below(double radius) const {
        if (smallest >= radius) return 0;
        return largest < radius ? count : (of < radius).count();
    }
};

}  // namespace carom
