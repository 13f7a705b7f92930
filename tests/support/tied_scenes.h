// Small random scenes in which contacts coincide, each generated from a seed: particles on
// lattices with few speeds, symmetric racks and rows of touching particles, corners of walls. All
// places are multiples of 1/64, so that what coincides does so exactly.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <vector>

#include "physics/box.h"
#include "physics/particles.h"
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

    void add(double x, double y, double vx, double vy, double radius, double inverse_mass = 1.0) {
        all_.push_back({x, y, vx, vy, radius, inverse_mass});
    }

    /// In random order.
    TiedScene in(const Box& box, Random& random) {
        for (std::size_t k = all_.size(); k > 1; --k) std::swap(all_[k - 1], all_[random.below(k)]);
        const auto count = static_cast<Eigen::Index>(all_.size());
        TiedScene scene{
            box,
            {Eigen::ArrayXd(count), Eigen::ArrayXd(count), Eigen::ArrayXi::Zero(count)},
            {0.0, Eigen::ArrayXXd(count, dimension_), Eigen::ArrayXXd(count, dimension_)}};
        for (Eigen::Index i = 0; i < count; ++i) {
            const One& its = all_[static_cast<std::size_t>(i)];
            scene.particles.radius[i] = its.radius;
            scene.particles.inverse_mass[i] = its.inverse_mass;
            for (int axis = 0; axis < dimension_; ++axis) {
                scene.start.position(i, axis) = axis == 0 ? its.x : its.y;
                scene.start.velocity(i, axis) = axis == 0 ? its.vx : its.vy;
            }
        }
        return scene;
    }

  private:
    struct One {
        double x, y, vx, vy, radius, inverse_mass;
    };
    int dimension_;
    std::vector<One> all_;
};

/// One of -1, 0 and 1, rather at rest or rather not.
inline double any_sign(Random& random) { return static_cast<double>(random.below(3)) - 1.0; }

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
            disks.add(0.5 + step * i, 0.5 + step * j, still * any_sign(random),
                      still * any_sign(random), 0.5, w);
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
            disks.add(60.0 + (8.0 + apart) * row, 50.0 - (6.0 + gap) * row + (12.0 + 2.0 * gap) * k,
                      0.0, 0.0, 5.0);
    const double off = random.below(3) == 0 ? 3.0 : 0.0;
    disks.add(30.0, 50.0 + off, 1.0, 0.0, 5.0,
              std::ldexp(1.0, static_cast<int>(random.below(3)) - 1));
    if (random.below(2) == 0) disks.add(110.0, 50.0 + off, -1.0, 0.0, 5.0);
    return disks.in({2, {140.0, 100.0}, {Wall::solid, Wall::solid}}, random);
}

/// Disks that lie in corners, at walls and on one another, and one that is shot at them.
inline TiedScene tied_corner(Random& random) {
    TiedParticles disks(2);
    disks.add(5.0, 5.0, 0.0, 0.0, 5.0, any_inverse_mass(random, false));
    disks.add(15.0, 5.0, 0.0, 0.0, 5.0, any_inverse_mass(random, false));
    if (random.below(2) == 0) disks.add(5.0, 15.0, 0.0, 0.0, 5.0);
    if (random.below(2) == 0) disks.add(13.0, 28.0, -1.0, -1.0, 5.0);
    if (random.below(2) == 0) disks.add(35.0, 5.0, -1.0, 0.0, 5.0);
    disks.add(32.0, 28.0, any_sign(random), -1.0, 5.0, 0.5);
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
        beads.add(x, 0.0, w == 0.0 ? 0.0 : any_sign(random), 0.0, radius, w);
        was_fixed = w == 0.0 || i == 0;  // the first and the last must not both be fixed
        x += 2.0 * radius +
             static_cast<double>(radius == 0.0 ? 1 + random.below(2) : random.below(3));
    }
    const Wall ends = random.below(2) == 0 ? Wall::solid : Wall::periodic;
    x += 1.0;  // beads that fill the wire would collide without end
    return beads.in({1, {x, 0.0}, {ends, Wall::solid}}, random);
}

inline TiedScene tied_scene(std::uint64_t seed) {
    Random random(seed, "contacts that coincide");
    const auto kind = random.below(3);
    return kind == 0 ? tied_lattice(random) : kind == 1 ? tied_rack(random) : tied_corner(random);
}

}  // namespace carom::test
