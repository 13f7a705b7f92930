// Small random scenes of every kind, in space, in the plane and on a line, each generated from a
// seed.
#pragma once

#include <cmath>
#include <cstdint>

#include "physics/gas.h"
#include "util/random.h"

namespace carom::test {

inline Wall any_wall(Random& random) {
    return random.uniform() < 0.5 ? Wall::periodic : Wall::solid;
}

/// A small random scene: mixed radii and masses, fixed and moving particles of infinite mass, all
/// kinds of walls, boxes with few cells as well as dilute ones. In the plane, or in space.
inline Gas small_scene(std::uint64_t seed, int dimension = 2) {
    Random random(seed, "small scene");
    Gas gas;
    gas.seed = seed;
    gas.box.dimension = dimension;
    gas.box.surfaces.side_count = 2 * dimension;
    const bool in_space = dimension == 3;
    const double longest = in_space ? 6.0 : 9.0;
    for (int axis = 0; axis < dimension; ++axis) gas.box.size[axis] = random.uniform(2.5, longest);
    for (int axis = 0; axis < dimension; ++axis)
        gas.box.walls[static_cast<std::size_t>(axis)] = any_wall(random);
    const double r = 0.5 * std::pow(gas.box.content(), 1.0 / dimension) * random.uniform(0.08, 0.2);
    gas.species.push_back({.name = "small",
                           .count = 1 + static_cast<int>(random.below(5)),
                           .radius = UniformDistribution{0.3 * r, r},
                           .mass = UniformDistribution{0.1, 10.0},
                           .velocity = Temperature{1.0}});
    gas.species.push_back({.name = "large",
                           .count = 1 + static_cast<int>(random.below(3)),
                           .radius = random.uniform(1.0, 2.4) * r,
                           .mass = ValueRule{random.uniform(0.01, 100.0)},
                           .velocity = Speed{random.uniform(0.0, 2.0)}});
    if (random.uniform() < 0.3)
        gas.species.push_back({.name = "fixed", .count = 1, .radius = r, .mass = Infinite{}});
    if (random.uniform() < 0.15)
        gas.species.push_back({.name = "driven",
                               .count = 1,
                               .radius = r,
                               .mass = Infinite{},
                               .velocity = Velocity{{{random.uniform(-1, 1), 0.3,
                                                      in_space ? random.uniform(-1, 1) : 0.0}}}});
    // The speed of a single particle in a periodic box, which would let the gas drift, is refused.
    const bool is_periodic =
        on_each_axis(dimension, [&](int axis) { return gas.box.is_periodic(axis); });
    if (is_periodic && gas.species.size() == 2 && gas.species[1].count == 1)
        gas.species[1].velocity =
            Velocity{{{random.uniform(-2.0, 2.0), 0.5, in_space ? 0.3 : 0.0}}};
    return gas;
}

/// Whether a particle may be trapped between a moving and a fixed particle of infinite mass, where
/// collisions accumulate without end.
inline bool may_crush(const Gas& gas) { return gas.species.size() > 3; }

/// A small random line: points and rods, mixed masses, a fixed bead, walls or a ring, a single
/// bead, beads all at rest.
inline Gas small_line(std::uint64_t seed) {
    Random random(seed, "small wire");
    Gas gas;
    gas.seed = seed;
    const double length = random.uniform(5.0, 20.0);
    const Wall ends = random.uniform() < 0.5 ? Wall::periodic : Wall::solid;
    gas.box = {1, {length, 0.0}, {ends, Wall::solid}};
    const double rod = random.uniform() < 0.4 ? 0.0 : 0.04 * length * random.uniform();
    gas.species.push_back({.name = "points",
                           .count = 1 + static_cast<int>(random.below(5)),
                           .radius = 0.0,
                           .mass = UniformDistribution{0.1, 10.0},
                           .velocity = Temperature{1.0}});
    gas.species.push_back({.name = "rods",
                           .count = static_cast<int>(random.below(5)),
                           .radius = rod,
                           .mass = ValueRule{random.uniform(0.01, 100.0)},
                           .velocity = Speed{random.uniform() < 0.2 ? 0.0 : 1.0}});
    if (random.uniform() < 0.3)
        gas.species.push_back({.name = "fixed", .count = 1, .radius = rod, .mass = Infinite{}});
    // So are the speeds of an odd number of equal beads on a ring.
    if (ends == Wall::periodic && gas.species.size() == 2 && gas.species[1].count % 2 == 1)
        gas.species[1].velocity = Velocity{{{random.uniform(-1.0, 1.0), 0.0}}};
    return gas;
}

}  // namespace carom::test
