// Builds simulations of a few particles whose positions and velocities are listed one by one.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "physics/simulation.h"

namespace carom::test {

struct Disk {
    double x, y, vx, vy, radius = 0.5, inverse_mass = 1.0;
};

/// The particles and the sample from which a Simulation starts; in one dimension y and vy are
/// ignored.
inline std::pair<Particles, Sample> start_of(int dimension, const std::vector<Disk>& disks) {
    const auto count = static_cast<Eigen::Index>(disks.size());
    Particles particles{Eigen::ArrayXd(count), Eigen::ArrayXd(count), Eigen::ArrayXi::Zero(count)};
    Sample sample{0.0, Eigen::ArrayXXd(count, dimension), Eigen::ArrayXXd(count, dimension)};
    for (Eigen::Index i = 0; i < count; ++i) {
        const Disk& d = disks[static_cast<std::size_t>(i)];
        particles.radius[i] = d.radius;
        particles.inverse_mass[i] = d.inverse_mass;
        const double place[] = {d.x, d.y}, velocity[] = {d.vx, d.vy};
        for (int a = 0; a < dimension; ++a) {
            sample.position(i, a) = place[a];
            sample.velocity(i, a) = velocity[a];
        }
    }
    return {std::move(particles), std::move(sample)};
}

struct Sphere {
    Vec place, velocity = {};
    double radius = 0.5, inverse_mass = 1.0;
};

/// The same for spheres.
inline std::pair<Particles, Sample> start_of(const std::vector<Sphere>& spheres) {
    const auto count = static_cast<Eigen::Index>(spheres.size());
    Particles particles{Eigen::ArrayXd(count), Eigen::ArrayXd(count), Eigen::ArrayXi::Zero(count)};
    Sample sample{0.0, Eigen::ArrayXXd(count, 3), Eigen::ArrayXXd(count, 3)};
    for (Eigen::Index i = 0; i < count; ++i) {
        const Sphere& sphere = spheres[static_cast<std::size_t>(i)];
        particles.radius[i] = sphere.radius;
        particles.inverse_mass[i] = sphere.inverse_mass;
        put(sphere.place, sample.position, i);
        put(sphere.velocity, sample.velocity, i);
    }
    return {std::move(particles), std::move(sample)};
}

/// Spheres or, in a plane, disks at their x and y.
inline Simulation simulation_of_bodies(const Box& box, const std::vector<Sphere>& spheres,
                                       const Run& run = {}) {
    auto [particles, sample] = start_of(spheres);
    for (auto* array : {&sample.position, &sample.velocity})
        *array = array->leftCols(box.dimension).eval();
    return Simulation(box, std::move(particles), std::move(sample), run);
}

inline Simulation simulation_of(const Box& box, const std::vector<Disk>& disks,
                                const Run& run = {}) {
    auto [particles, sample] = start_of(box.dimension, disks);
    return Simulation(box, std::move(particles), std::move(sample), run);
}

struct Bead {
    double x, v, inverse_mass = 1.0;
};

/// Beads of equal radius on a line between two end walls; for `dimension` 2, disks in a row along a
/// narrow box.
inline Simulation along_a_line(int dimension, double length, double radius,
                               const std::vector<Bead>& beads) {
    const double height = 4.0 * radius;
    std::vector<Disk> disks;
    for (const Bead& b : beads)
        disks.push_back({b.x, 0.5 * height, b.v, 0.0, radius, b.inverse_mass});
    return simulation_of(Box{dimension, {length, dimension == 1 ? 0.0 : height}, {}}, disks);
}

}  // namespace carom::test
