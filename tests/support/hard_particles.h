// What holds of hard particles in every run: they do not overlap, touch when they collide, keep
// energy and momentum, and come home when they are reversed.
#pragma once

#include <doctest/doctest.h>

#include <Eigen/Core>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "physics/events/event_loop.h"
#include "physics/gas.h"
#include "physics/mechanics.h"
#include "physics/placement/placement.h"
#include "physics/simulation.h"
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

/// No overlap after any of so many events, and the energy and the momenta of the start, unless
/// particles of infinite mass give or take them.
template <int dimension>
void require_conserved(const Gas& gas, int events) {
    const auto [particles, start] = place(gas);
    const bool driven = infinite_mass_moves(particles, start);
    const bool fixed = (particles.inverse_mass == 0.0).any();
    const Eigen::ArrayXd masses =
        (particles.inverse_mass > 0.0).select(particles.inverse_mass.inverse(), 0.0);
    const auto energy_of = [&](const Sample& s) {
        return 0.5 * (masses * s.velocity.square().rowwise().sum()).sum();
    };
    const double before = energy_of(start), scale = (masses * speeds(start)).sum();
    EventLoop<dimension> loop(gas.box, particles);
    loop.start(start);
    Sample sample;
    Collision collision{};
    for (int k = 0; k < events && loop.advance_one(1e6, collision); ++k) {
        CAPTURE(k);
        loop.sample(collision.time, sample);
        REQUIRE(deepest_overlap(gas.box, particles, sample) <= overlap_bound(gas.box, sample));
        if (driven) continue;
        REQUIRE(energy_of(sample) == relative(before, 1e-13));
        for (int a = 0; a < dimension; ++a) {
            if (fixed || !gas.box.is_periodic(a)) continue;
            const double change = (masses * (sample.velocity.col(a) - start.velocity.col(a))).sum();
            REQUIRE(std::abs(change) <= 1e-13 * scale);
        }
    }
}

/// Reversed at the time `out`, everything returns to its start within s c + 2 sqrt(s c) + 16 bits
/// for c collisions of each particle, of which each costs s = `bits_per_collision`.
inline void check_return(const Gas& gas, double out, double bits_per_collision) {
    const auto [particles, start] = place(gas);
    const Run run{.until = 2.0 * out, .equilibrate = 0.0, .events = {{out, ReverseVelocities{}}}};
    Simulation simulation(gas.box, particles, start, run);
    const auto there = simulation.advance_to(out).counts;
    const auto back = simulation.advance_to(2.0 * out).counts;
    CHECK(there.particle > 40);
    CHECK(back.particle == 2 * there.particle);
    CHECK(back.wall == 2 * there.wall);
    const double bits = bits_per_collision * 2.0 * static_cast<double>(there.particle) /
                        static_cast<double>(particles.count());
    const double bound = std::exp2(bits + 2.0 * std::sqrt(bits) + 16.0 - 53.0);
    const Sample& returned = simulation.sample();
    CHECK((returned.position - start.position).abs().maxCoeff() <= bound);
    CHECK((returned.velocity + start.velocity).abs().maxCoeff() <= bound);
}

/// Two giants among dust, and what is between them in size.
inline std::vector<Species> giants_and_dust(double giant, double largest_between) {
    const auto species = [](std::string name, std::int64_t count, const ValueRule& radius) {
        return Species{.name = std::move(name),
                       .count = count,
                       .radius = radius,
                       .mass = Density{1.0},
                       .velocity = Temperature{30.0}};
    };
    return {species("giant", 2, giant),
            species("middle", 10, UniformDistribution{1.0, largest_between}),
            species("dust", 400, UniformDistribution{0.1, 0.4})};
}

/// A giant that nearly fills its box, small obstacles, and a small particle, which alone moves: so
/// nobody else finds what it has not seen.
inline std::vector<Species> one_among_fixed(const Vec& velocity) {
    const ValueRule fixed{std::numeric_limits<double>::infinity()};
    return {{.name = "giant", .count = 1, .radius = 8.0, .mass = fixed},
            {.name = "obstacle", .count = 40, .radius = 0.05, .mass = fixed},
            {.name = "small", .count = 1, .radius = 0.05, .velocity = Velocity{{velocity}}}};
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
