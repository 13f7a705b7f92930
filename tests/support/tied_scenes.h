// Small random scenes in which contacts coincide, each generated from a seed: particles on
// lattices with few speeds, symmetric racks and rows of touching particles, corners of walls. All
// places are multiples of 1/64, so that what coincides does so exactly.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "physics/box.h"
#include "physics/particles.h"
#include "physics/vec.h"
#include "util/random.h"

namespace carom::test {

struct TiedScene {
    Box box;
    Particles particles;
    Sample start;
};

class TiedParticles {
  public:
    explicit TiedParticles(int dimension) : dimension_(dimension) {}

    void add(const Vec& place, const Vec& velocity, double radius, double inverse_mass = 1.0) {
        all_.push_back({place, velocity, radius, inverse_mass});
    }

    /// In random order.
    TiedScene in(const Box& box, Random& random) {
        for (std::size_t k = all_.size(); k > 1; --k) std::swap(all_[k - 1], all_[random.below(k)]);
        const auto count = static_cast<Eigen::Index>(all_.size());
        TiedScene scene{
            box,
            {Eigen::ArrayXd(count), Eigen::ArrayXd(count), Eigen::ArrayXi::Zero(count)},
            {0.0, Eigen::ArrayXXd(count, dimension_), Eigen::ArrayXXd(count, dimension_)}};
        if (dimension_ == 3) scene.box.surfaces.side_count = 6;
        for (Eigen::Index i = 0; i < count; ++i) {
            const One& its = all_[static_cast<std::size_t>(i)];
            scene.particles.radius[i] = its.radius;
            scene.particles.inverse_mass[i] = its.inverse_mass;
            put(its.place, scene.start.position, i);
            put(its.velocity, scene.start.velocity, i);
        }
        return scene;
    }

  private:
    struct One {
        Vec place, velocity;
        double radius, inverse_mass;
    };
    int dimension_;
    std::vector<One> all_;
};

/// One of -1, 0 and 1, rather at rest or rather not.
inline double any_sign(Random& random) { return static_cast<double>(random.below(3)) - 1.0; }

inline Vec any_velocity(Random& random, int dimension) {
    Vec velocity;
    for (int axis = 0; axis < dimension; ++axis) velocity[axis] = any_sign(random);
    return velocity;
}

/// A mass of 1/2, 1 or 2, rarely infinite.
inline double any_inverse_mass(Random& random, bool are_equal) {
    if (random.below(12) == 0) return 0.0;
    return are_equal ? 1.0 : std::ldexp(1.0, static_cast<int>(random.below(3)) - 1);
}

/// Disks on a square lattice, at a few velocities, so that many meet at the same time; some touch.
inline TiedScene tied_lattice(Random& random) {
    const int across = 2 + static_cast<int>(random.below(3)),
              up = 1 + static_cast<int>(random.below(3));
    const double step = random.below(2) == 0 ? 1.0 : 1.5;
    const bool are_equal = random.below(2) == 0;
    TiedParticles disks(2);
    for (int i = 0; i < across; ++i)
        for (int j = 0; j < up; ++j) {
            const double w = any_inverse_mass(random, are_equal);
            const double still = w == 0.0 ? 0.0 : 1.0;
            disks.add({0.5 + step * i, 0.5 + step * j}, still * any_velocity(random, 2), 0.5, w);
        }
    const Wall wall = random.below(2) == 0 ? Wall::solid : Wall::periodic;
    // Disks that touch must not fill the box: they would collide without end.
    const double more = step > 1.0 && random.below(2) == 0 ? 0.0 : 1.0;
    const double width = std::max(4.0, step * across + more),
                 height = std::max(4.0, step * up + more);
    return disks.in({2, {width, height}, {wall, random.below(2) == 0 ? wall : Wall::solid}},
                    random);
}

/// A disk that is shot along the axis of a symmetric rack of triangles with sides of 10, 10 and 12.
inline TiedScene tied_rack(Random& random) {
    const int rows = 1 + static_cast<int>(random.below(3));
    const double apart = random.below(3) == 0 ? 1.0 : 0.0;  // between rows: they do not touch
    const double gap = random.below(3) == 0 ? 1.0 : 0.0;    // within a row
    TiedParticles disks(2);
    for (int row = 0; row < rows; ++row)
        for (int k = 0; k <= row; ++k)
            disks.add(
                {60.0 + (8.0 + apart) * row, 50.0 - (6.0 + gap) * row + (12.0 + 2.0 * gap) * k}, {},
                5.0);
    const double off = random.below(3) == 0 ? 3.0 : 0.0;
    disks.add({30.0, 50.0 + off}, {1.0, 0.0}, 5.0,
              std::ldexp(1.0, static_cast<int>(random.below(3)) - 1));
    if (random.below(2) == 0) disks.add({110.0, 50.0 + off}, {-1.0, 0.0}, 5.0);
    return disks.in({2, {140.0, 100.0}, {Wall::solid, Wall::solid}}, random);
}

/// Disks that lie in corners, at walls and on one another, and one that is shot at them.
inline TiedScene tied_corner(Random& random) {
    TiedParticles disks(2);
    disks.add({5.0, 5.0}, {}, 5.0, any_inverse_mass(random, false));
    disks.add({15.0, 5.0}, {}, 5.0, any_inverse_mass(random, false));
    if (random.below(2) == 0) disks.add({5.0, 15.0}, {}, 5.0);
    if (random.below(2) == 0) disks.add({13.0, 28.0}, {-1.0, -1.0}, 5.0);
    if (random.below(2) == 0) disks.add({35.0, 5.0}, {-1.0, 0.0}, 5.0);
    disks.add({32.0, 28.0}, {any_sign(random), -1.0}, 5.0, 0.5);
    return disks.in({2, {50.0, 50.0}, {Wall::solid, Wall::solid}}, random);
}

/// Beads at multiples of a length with few velocities, some of which touch.
inline TiedScene tied_wire(Random& random) {
    const int count = 2 + static_cast<int>(random.below(6));
    const double radius = random.below(2) == 0 ? 0.0 : 0.5;
    const bool are_equal = random.below(2) == 0;
    TiedParticles beads(1);
    double x = radius;
    bool was_fixed = false;
    for (int i = 0; i < count; ++i) {
        const double w = was_fixed ? 1.0 : any_inverse_mass(random, are_equal);
        beads.add({x, 0.0}, {w == 0.0 ? 0.0 : any_sign(random), 0.0}, radius, w);
        was_fixed = w == 0.0 || i == 0;  // the first and the last must not both be fixed
        x += 2.0 * radius +
             static_cast<double>(radius == 0.0 ? 1 + random.below(2) : random.below(3));
    }
    const Wall ends = random.below(2) == 0 ? Wall::solid : Wall::periodic;
    x += 1.0;  // beads that fill the wire would collide without end
    return beads.in({1, {x, 0.0}, {ends, Wall::solid}}, random);
}

/// Spheres on a cubic lattice, at a few velocities.
inline TiedScene tied_cubic_lattice(Random& random) {
    const double step = random.below(2) == 0 ? 1.0 : 1.5;
    const bool are_equal = random.below(2) == 0;
    std::array<int, 3> count{};
    Vec size;
    for (int axis = 0; axis < 3; ++axis) {
        count.at(static_cast<std::size_t>(axis)) = 1 + static_cast<int>(random.below(3));
        const double more = step > 1.0 && random.below(2) == 0 ? 0.0 : 1.0;
        size[axis] = std::max(4.0, step * count.at(static_cast<std::size_t>(axis)) + more);
    }
    TiedParticles spheres(3);
    for (int i = 0; i < count[0]; ++i)
        for (int j = 0; j < count[1]; ++j)
            for (int k = 0; k < count[2]; ++k) {
                const double w = any_inverse_mass(random, are_equal);
                spheres.add(Vec{0.5, 0.5, 0.5} + step * Vec(i, j, k),
                            (w == 0.0 ? 0.0 : 1.0) * any_velocity(random, 3), 0.5, w);
            }
    const Wall wall = random.below(2) == 0 ? Wall::solid : Wall::periodic;
    return spheres.in({3, size, {wall, random.below(2) == 0 ? wall : Wall::solid, wall}}, random);
}

/// A sphere that is shot along the axis of a symmetric group of others of its radius, 9/2, and
/// meets them at once, because |(3, 6, 6)| = |(7, 4, 4)| = |(1, 8, 4)| = 9.
inline TiedScene tied_cluster(Random& random) {
    constexpr double radius = 4.5;
    constexpr std::array<Vec, 3> shapes{Vec{3.0, 6.0, 6.0}, Vec{7.0, 4.0, 4.0}, Vec{1.0, 8.0, 4.0}};
    const auto shape = random.below(3);
    const Vec centre{40.0, 40.0, 40.0}, first = shapes.at(shape);
    std::vector<Vec> group{{0.0, first[1], first[2]}, {0.0, -first[1], -first[2]}};
    if (shape != 1 && random.below(2) == 0) {  // those of the second would overlap
        group.emplace_back(0.0, first[2], -first[1]);
        group.emplace_back(0.0, -first[2], first[1]);
    }
    const double w = std::ldexp(1.0, static_cast<int>(random.below(3)) - 1);
    TiedParticles spheres(3);
    for (const Vec& each : group) spheres.add(centre + each, {}, radius, w);
    const double off = random.below(4) == 0 ? 2.0 : 0.0;
    spheres.add(centre - Vec{first[0] + 20.0, off, 0.0}, {1.0, 0.0, 0.0}, radius,
                any_inverse_mass(random, false));
    if (random.below(2) == 0) spheres.add(centre + Vec{30.0, off, 0.0}, {-1.0, 0.0, 0.0}, radius);
    return spheres.in({3, {80.0, 80.0, 80.0}, {}}, random);
}

/// Spheres that lie in corners, at walls and on one another, and one that is shot at them.
inline TiedScene tied_corner_in_space(Random& random) {
    TiedParticles spheres(3);
    spheres.add({4.5, 4.5, 4.5}, {}, 4.5, any_inverse_mass(random, false));
    if (random.below(2) == 0)
        spheres.add({13.5, 4.5, 4.5}, {}, 4.5, any_inverse_mass(random, false));
    if (random.below(2) == 0) spheres.add({4.5, 4.5, 13.5}, {}, 4.5);
    if (random.below(2) == 0) spheres.add({8.5, 11.5, 8.5}, {}, 4.5);  // (4, 7, 4) from the first
    if (random.below(2) == 0) spheres.add({35.5, 4.5, 4.5}, {-1.0, 0.0, 0.0}, 4.5);
    if (random.below(2) == 0) spheres.add({28.5, 28.5, 28.5}, {-1.0, -1.0, -1.0}, 4.5);
    const double towards = any_sign(random);
    spheres.add({20.5, 26.5, 20.5}, {towards, -1.0, towards}, 4.5, 0.5);
    return spheres.in({3, {50.0, 50.0, 50.0}, {}}, random);
}

inline TiedScene tied_scene(std::uint64_t seed, int dimension = 2) {
    Random random(seed, "contacts that coincide");
    if (dimension == 3) {
        const auto which = random.below(3);
        return which == 0   ? tied_cubic_lattice(random)
               : which == 1 ? tied_cluster(random)
                            : tied_corner_in_space(random);
    }
    const auto kind = random.below(3);
    return kind == 0 ? tied_lattice(random) : kind == 1 ? tied_rack(random) : tied_corner(random);
}

}  // namespace carom::test
