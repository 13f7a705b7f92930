// Simulations of a few particles that are given one by one.
#pragma once

#include <cstddef>
#include <vector>

#include "physics/simulation.h"

namespace carom::test {

struct Disk {
    double x, y, vx, vy, radius = 0.5, inverse_mass = 1.0;
};

inline Simulation simulation_of(const Box& box, const std::vector<Disk>& disks) {
    const auto count = static_cast<Eigen::Index>(disks.size());
    Particles particles{Eigen::ArrayXd(count), Eigen::ArrayXd(count), Eigen::ArrayXi::Zero(count)};
    Sample start{0.0, Eigen::ArrayXXd(count, 2), Eigen::ArrayXXd(count, 2)};
    for (Eigen::Index i = 0; i < count; ++i) {
        const Disk& d = disks[static_cast<std::size_t>(i)];
        particles.radius[i] = d.radius;
        particles.inverse_mass[i] = d.inverse_mass;
        start.position.row(i) << d.x, d.y;
        start.velocity.row(i) << d.vx, d.vy;
    }
    return Simulation(box, particles, start, Run{});
}

struct Bead {
    double x, v, inverse_mass = 1.0;
};

/// Beads of one radius between the ends of a wire; when `dimension` is 2, disks in a row.
inline Simulation along_a_line(int dimension, double length, double radius,
                               const std::vector<Bead>& beads) {
    const double height = 4.0 * radius;
    std::vector<Disk> disks;
    for (const Bead& b : beads)
        disks.push_back({b.x, 0.5 * height, b.v, 0.0, radius, b.inverse_mass});
    if (dimension == 2) return simulation_of(Box{2, {length, height}, {}}, disks);

    const auto count = static_cast<Eigen::Index>(beads.size());
    Particles particles{Eigen::ArrayXd::Constant(count, radius), Eigen::ArrayXd(count),
                        Eigen::ArrayXi::Zero(count)};
    Sample start{0.0, Eigen::ArrayXXd(count, 1), Eigen::ArrayXXd(count, 1)};
    for (Eigen::Index i = 0; i < count; ++i) {
        const Bead& b = beads[static_cast<std::size_t>(i)];
        particles.inverse_mass[i] = b.inverse_mass;
        start.position(i, 0) = b.x;
        start.velocity(i, 0) = b.v;
    }
    return Simulation(Box{1, {length, 0.0}, {}}, particles, start, Run{});
}

}  // namespace carom::test
