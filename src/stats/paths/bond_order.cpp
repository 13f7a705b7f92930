#include "stats/paths/bond_order.h"

#include "stats/paths/near_pairs.h"

namespace carom {

Eigen::ArrayXcd bond_order(const Box& box, const Particles& particles,
                           const Eigen::ArrayXXd& positions) {
    const Eigen::Index count = particles.count();
    Eigen::ArrayXcd sums = Eigen::ArrayXcd::Zero(count);
    Eigen::ArrayXd neighbours = Eigen::ArrayXd::Zero(count);
    const double farthest =
        count > 0 ? 2.0 * neighbour_distance * particles.radius.maxCoeff() : 0.0;
    NearPairs(box, positions, farthest).for_each([&](Eigen::Index i, Eigen::Index j) {
        const Vec apart = box.nearest(vec_in(positions, j) - vec_in(positions, i));
        const double contact = particles.radius[i] + particles.radius[j];
        const double distance = length(apart);
        if (!(distance < neighbour_distance * contact)) return;
        // The sixth power is the same for the opposite direction, seen from the other disk.
        const std::complex<double> direction(apart[0] / distance, apart[1] / distance);
        const std::complex<double> third = direction * direction * direction;
        for (const Eigen::Index k : {i, j}) {
            sums[k] += third * third;
            neighbours[k] += 1.0;
        }
    });
    return (neighbours > 0.0).select(sums / neighbours.max(1.0), 0.0 * sums);
}

}  // namespace carom
