#include <cstddef>

#include "physics/simulation.h"

namespace carom {

const Sample& VelocitySamples::after(Simulation& simulation, double time,
                                     const AdvanceResult& advanced) {
    following_.see(!is_known_ || advanced.velocities.has_value());
    if (is_known_ && advanced.velocities) {
        for (const VelocityChange& change : *advanced.velocities)
            for (Eigen::Index axis = 0; axis < sample_.velocity.cols(); ++axis)
                sample_.velocity(change.particle, axis) = change.after[axis];
    } else {
        sample_ = {};  // frees it before the next one is allocated
        sample_ = simulation.sample_of_velocities();
    }
    is_known_ = true;
    sample_.time = time;
    simulation.follow_velocities(following_.is_on());
    return sample_;
}

}  // namespace carom
