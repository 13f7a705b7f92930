// What holds of hard particles in every run: they do not overlap, and touch when they collide.
#pragma once

#include <doctest/doctest.h>

#include <Eigen/Core>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "physics/events/event_loop.h"
#include "physics/gas.h"
#include "physics/placement/placement.h"
#include "support/relative.h"

namespace carom::test {

/// The deepest overlap of any pair or wall, length.
inline double deepest_overlap(const Box& box, const Particles& particles, const Sample& sample) {
    double deepest = 0.0;
    for (Eigen::Index i = 0; i < particles.count(); ++i) {
        for (Eigen::Index j = 0; j < i; ++j) {
            if (particles.inverse_mass[i] + particles.inverse_mass[j] == 0.0) continue;
            Vec r = vec_in(sample.position, i) - vec_in(sample.position, j);
            for (int a = 0; a < box.dimension; ++a)
                if (box.is_periodic(a)) r[a] = std::remainder(r[a], box.size[a]);
            const double sigma = particles.radius[i] + particles.radius[j];
            deepest = std::max(deepest, sigma - length(r));
        }
        for (int a = 0; a < box.dimension; ++a) {
            if (box.is_periodic(a)) continue;
            const double x = sample.position(i, a);
            deepest = std::max(deepest, particles.radius[i] - std::min(x, box.size[a] - x));
        }
    }
    return deepest;
}

/// Coordinates of the size of the box are rounded a few times on the way to a contact, and a sample
/// is taken at a rounded time, when the fastest particle is off by its speed times the rounding.
inline double overlap_bound(const Box& box, const Sample& sample) {
    const double epsilon = std::numeric_limits<double>::epsilon();
    const double lengths = box.size[0] + box.size[1] + box.size[2];
    return epsilon * (4.0 * lengths + 2.0 * speeds(sample).maxCoeff() * sample.time);
}

/// In contact at each of so many collisions, no overlap at those that are looked at, the first and
/// then one in `each`, and the energy of the start at the last.
template <int dimension>
void require_hard(const Gas& gas, int collisions, int each) {
    const auto [particles, start] = place(gas);
    EventLoop<dimension> loop(gas.box, particles);
    loop.start(start);
    Sample sample;
    Collision collision{};
    double apart = 0.0;  // at contact, more or less than the radii
    for (int k = 0; k < collisions; ++k) {
        REQUIRE(loop.advance_one(1e6, collision));
        if (collision.second.is_particle()) {
            const double sigma =
                particles.radius[collision.first] + particles.radius[collision.second.particle()];
            const double distance = length(collision.second_position - collision.first_position);
            apart = std::max(apart, std::abs(distance - sigma));
        }
        if (k % each != 0) continue;
        loop.sample(collision.time, sample);
        REQUIRE(deepest_overlap(gas.box, particles, sample) <= overlap_bound(gas.box, sample));
    }
    loop.sample(collision.time, sample);
    CHECK(apart <= overlap_bound(gas.box, sample));
    CHECK(kinetic_energies(particles, sample).sum() ==
          relative(kinetic_energies(particles, start).sum(), 1e-12));
}

/// A hash of all bits of the positions and velocities.
inline std::uint64_t hash_of(const Sample& sample) {
    std::uint64_t hash = 14695981039346656037ULL;  // FNV-1a
    for (const auto* array : {&sample.position, &sample.velocity})
        for (Eigen::Index k = 0; k < array->size(); ++k)
            hash = (hash ^ std::bit_cast<std::uint64_t>(array->data()[k])) * 1099511628211ULL;
    return hash;
}

}  // namespace carom::test
