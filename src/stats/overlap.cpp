#include "stats/overlap.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include "physics/placement/placed_disks.h"

namespace carom {
namespace {

double overlap_of_disks(const Box& box, const Particles& particles, const Sample& sample) {
    PlacedDisks placed(box, particles.count(), particles.radius.mean());
    double deepest = 0.0;
    for (Eigen::Index i = 0; i < particles.count(); ++i) {
        const Eigen::Array2d centre = sample.position.row(i).transpose();
        deepest = std::max(deepest, placed.deepest_overlap(centre, particles.radius[i]));
        placed.add(static_cast<std::int32_t>(i), centre, particles.radius[i]);
    }
    return deepest;
}

// Beads cannot pass one another: only neighbours along the line can overlap.
double overlap_of_beads(const Box& box, const Particles& particles, const Sample& sample) {
    std::vector<Eigen::Index> order(static_cast<std::size_t>(particles.count()));
    std::iota(order.begin(), order.end(), Eigen::Index{0});
    const auto x = sample.position.col(0);
    std::sort(order.begin(), order.end(),
              [&](Eigen::Index a, Eigen::Index b) { return x[a] < x[b]; });
    double deepest = 0.0;
    const auto look = [&](Eigen::Index a, Eigen::Index b, double turn) {
        const double contact = particles.radius[a] + particles.radius[b];
        if (contact > 0.0) deepest = std::max(deepest, 1.0 - (x[b] + turn - x[a]) / contact);
    };
    for (std::size_t k = 1; k < order.size(); ++k) look(order[k - 1], order[k], 0.0);
    if (box.is_periodic(0) && order.size() > 1) look(order.back(), order.front(), box.size[0]);
    return deepest;
}

}  // namespace

double largest_relative_overlap(const Box& box, const Particles& particles, const Sample& sample) {
    if (particles.count() < 2) return 0.0;
    return box.dimension == 1 ? overlap_of_beads(box, particles, sample)
                              : overlap_of_disks(box, particles, sample);
}

}  // namespace carom
