#include "physics/placement/overlap.h"

#include <algorithm>
#include <cstdint>

#include "physics/placement/members.h"
#include "physics/placement/placed_disks.h"

namespace carom {
namespace {

double overlap_of_disks(const Box& box, const Particles& particles, const Sample& sample) {
    PlacedDisks placed(box, particles.radius);
    double deepest = 0.0;
    for (Eigen::Index i = 0; i < particles.count(); ++i) {
        const Eigen::Array2d centre = sample.position.row(i).transpose();
        deepest = std::max(deepest, placed.deepest_overlap(centre, particles.radius[i]));
        placed.add(static_cast<std::int32_t>(i), centre, particles.radius[i]);
    }
    return deepest;
}

double overlap_of_beads(const Box& box, const Particles& particles, const Sample& sample) {
    double deepest = 0.0;
    for_each_two_neighbours(
        box, beads_along(sample, 0), [&](Eigen::Index left, Eigen::Index right, double apart) {
            const double contact = particles.radius[left] + particles.radius[right];
            if (contact > 0.0) deepest = std::max(deepest, 1.0 - apart / contact);
        });
    return deepest;
}

}  // namespace

double largest_relative_overlap(const Box& box, const Particles& particles, const Sample& sample) {
    if (particles.count() < 2) return 0.0;
    return box.dimension == 1 ? overlap_of_beads(box, particles, sample)
                              : overlap_of_disks(box, particles, sample);
}

}  // namespace carom
