// Small random scenes with active surfaces, obstacles, gravity and events, in space, in the plane
// and on a line, each generated from a seed.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "physics/gas.h"
#include "physics/run.h"
#include "util/random.h"

namespace carom::test {

struct SurfaceScene {
    Gas gas;
    std::vector<RunEvent> events = {};
};

/// A random mass, from much lighter to much heavier than a disk.
inline double any_mass(Random& random) { return std::pow(10.0, random.uniform(-4.0, 2.0)); }

/// A random behaviour of a side or a partition in a box of this dimension. `may_move`: it may be a
/// piston or a driven wall.
inline Behaviour any_behaviour(Random& random, int dimension, bool is_side, bool may_move) {
    const double which = random.uniform();
    if (may_move && which < 0.2)
        return Piston{any_mass(random), random.uniform(-1.0, 1.0), random.uniform(-0.5, 0.5)};
    if (may_move && which < 0.35)
        return Driven{random.uniform(-0.3, 0.3), random.uniform() < 0.5 ? 3.0 : 50.0};
    if (which < 0.45) return Bath{random.uniform(0.5, 3.0)};
    if (dimension > 1 && which > 0.88) return Diffuse{};
    if (is_side || which < 0.7) return Reflecting{};
    if (which < 0.8) return Membrane{.species = {static_cast<std::int32_t>(random.below(2))}};
    return Membrane{.upward = {.faster_than = random.uniform(0.0, 2.0)},
                    .downward = {.faster_than = 0.0, .slower_than = random.uniform(0.0, 2.0)}};
}

/// By how much something passes a body, or would overlap it: by very little or by more.
inline double any_miss(Random& random) {
    return std::pow(10.0, random.uniform(-15.0, -2.0)) * (random.uniform() < 0.5 ? 1.0 : -1.0);
}

/// One particle that falls, and would be at this place with this velocity at this time.
inline Species thrown_to(const Vec& place, const Vec& velocity, double time, const Vec& gravity,
                         double radius) {
    return {.name = "thrown",
            .count = 1,
            .radius = radius,
            .velocity = Velocity{{velocity - time * gravity}},
            .position = Places{{place - time * velocity + 0.5 * time * time * gravity}}};
}

/// Random gaps in a partition across `box`, whose other axes are these. Some are narrower than a
/// particle, some begin at a wall; in space some reach along each other.
inline std::vector<Gap> any_gaps(Random& random, const Box& box, const std::vector<int>& others) {
    std::vector<Gap> gaps;
    const double length = box.length(others[0]);
    double from = random.uniform() < 0.2 ? 0.0 : length * random.uniform(0.05, 0.4);
    for (int k = 0; k < 2 && from < 0.9 * length; ++k) {
        const double to = std::min(length, from + length * std::pow(random.uniform(), 2.0) * 0.5);
        Gap gap(from, to);
        if (others.size() > 1) {
            const double across = box.length(others[1]);
            gap.low[1] = random.uniform() < 0.2 ? 0.0 : across * random.uniform(0.0, 0.6);
            gap.high[1] = random.uniform() < 0.2 ? across : random.uniform(gap.low[1], across);
        }
        gaps.push_back(gap);
        from = to + length * random.uniform(0.02, 0.3);
        if (others.size() > 1 && random.uniform() < 0.3) from = to;
    }
    return gaps;
}

inline Partition any_partition(Random& random, const Box& box, bool may_move, std::string name) {
    const int dimension = box.dimension;
    const int axis = static_cast<int>(random.below(static_cast<std::uint64_t>(dimension)));
    const bool has_gaps = random.uniform() < 0.5;
    Partition partition{
        .name = std::move(name),
        .axis = axis,
        .at = box.length(axis) * random.uniform(0.2, 0.8),
        .behaviour = any_behaviour(random, dimension, false, may_move && !box.is_periodic(axis)),
        .is_open = random.uniform() < 0.15};
    if (!has_gaps || std::holds_alternative<Piston>(partition.behaviour)) return partition;
    std::vector<int> others;
    for (int other = 0; other < dimension; ++other)
        if (other != axis) others.push_back(other);
    partition.gaps = any_gaps(random, box, others);
    return partition;
}

/// A sphere or a cuboid.
inline Obstacle any_body_in_space(Random& random, const Box& box, std::string name) {
    Vec at, size;
    for (int axis = 0; axis < 3; ++axis) at[axis] = box.size[axis] * random.uniform(0.15, 0.85);
    if (random.uniform() < 0.3)
        return {std::move(name), Obstacle::Ball{at, random.uniform(0.05, 1.0)}};
    for (int axis = 0; axis < 3; ++axis)
        size[axis] = random.uniform() < 0.2 ? 0.01 : random.uniform(0.1, 1.5);
    return {std::move(name), Obstacle::Cuboid{at - 0.5 * size, at + 0.5 * size}};
}

inline Obstacle any_obstacle(Random& random, const Box& box, std::string name) {
    if (box.dimension == 3) return any_body_in_space(random, box, std::move(name));
    const Vec at{box.size[0] * random.uniform(0.15, 0.85),
                 box.size[1] * random.uniform(0.15, 0.85)};
    const auto near = [&](double far) {
        return at + Vec{random.uniform(-far, far), random.uniform(-far, far)};
    };
    switch (random.below(5)) {
        case 0:
            return {std::move(name), Obstacle::Ball{at, random.uniform(0.05, 1.0)}};
        case 1: {
            const double x = random.uniform(0.1, 1.0), y = random.uniform(0.1, 1.0);
            return {
                std::move(name),
                Obstacle::Lines{{at, at + Vec{x, 0.0}, at + Vec{x, y}, at + Vec{0.0, y}}, true}};
        }
        case 2:
            return {std::move(name),
                    Obstacle::Lines{{near(1.0), near(1.0), near(1.0), near(1.0)}, true}};
        case 3:
            return {std::move(name), Obstacle::Lines{{near(1.5), near(1.5)}, false}};
        default: {  // a corner, often nearly closed
            const double turn = random.uniform(0.0, 6.3), length = random.uniform(1.0, 2.5);
            const double angle = std::pow(10.0, random.uniform(-2.0, 0.0));
            const auto end = [&](double angle_of_it) {
                return at + length * Vec{std::cos(angle_of_it), std::sin(angle_of_it)};
            };
            return {std::move(name), Obstacle::Lines{{end(turn), at, end(turn + angle)}, false}};
        }
    }
}

/// Whether a side or a partition that moves would start inside the obstacle.
inline bool is_across(const Obstacle& obstacle, const Box& box) {
    const auto is_at = [&](int axis, double place) {
        double low = 1e300, high = -1e300;
        const auto include = [&](double from, double to) {
            low = std::min(low, from), high = std::max(high, to);
        };
        if (const auto* ball = std::get_if<Obstacle::Ball>(&obstacle.shape))
            include(ball->center[axis] - ball->radius, ball->center[axis] + ball->radius);
        else if (const auto* cuboid = std::get_if<Obstacle::Cuboid>(&obstacle.shape))
            include(cuboid->low[axis], cuboid->high[axis]);
        else
            for (const auto& corner : std::get<Obstacle::Lines>(obstacle.shape).corners)
                include(corner[axis], corner[axis]);
        return place > low && place < high;
    };
    bool is = false;
    for (const Partition& line : box.surfaces.partitions) is = is || is_at(line.axis, line.at);
    for (int axis = 0; axis < box.dimension; ++axis)
        is = is || is_at(axis, 0.0) || is_at(axis, box.length(axis));
    return is;
}

/// Random events: changes of the first partition, if any, of a side, or of the velocities.
inline std::vector<RunEvent> any_events(Random& random, const Box& box, bool surfaces_move = true) {
    std::vector<RunEvent> events;
    double time = 0.0;
    const auto side =
        static_cast<std::int32_t>(random.below(2 * static_cast<std::uint64_t>(box.dimension)));
    const bool has_partition = !box.surfaces.partitions.empty();
    for (int k = 0; k < 4; ++k) {
        time += random.uniform(0.1, 2.0);
        const bool of_partition = has_partition && random.uniform() < 0.7;
        const std::int32_t which = of_partition ? box.surfaces.first_partition() : side;
        const int axis = of_partition ? box.surfaces.partitions[0].axis : side / 2;
        if (!of_partition && box.is_periodic(axis)) continue;
        const bool may_move = !box.is_periodic(axis) && surfaces_move;
        switch (random.below(5)) {
            case 0:
            case 1:
                if (of_partition)
                    events.push_back({time, SetOpen{which, random.uniform() < 0.5}});
                else if (random.uniform() < 0.5)
                    events.push_back({time, Heat{{}, random.uniform(-1.0, 3.0)}});
                else
                    events.push_back({time, Heat{static_cast<std::int32_t>(random.below(2)),
                                                 Temperature{random.uniform(0.3, 3.0)}}});
                break;
            case 2:
                if (may_move)
                    events.push_back({time, MoveSurface{which, random.uniform(-0.3, 0.3)}});
                break;
            case 3: {
                const bool has_gaps = of_partition && !box.surfaces.partitions[0].gaps.empty();
                events.push_back(
                    {time, ChangeSurface{which, any_behaviour(random, box.dimension, true,
                                                              may_move && !has_gaps)}});
                break;
            }
            default:
                if (!may_move || (of_partition && !box.surfaces.partitions[0].gaps.empty())) break;
                events.push_back({time, ChangeSurface{which, Piston{any_mass(random)}}});
                events.push_back({time + 0.2, HoldPiston{which}});
                events.push_back({time + 0.5, ReleasePiston{which}});
                time += 0.5;
                break;
        }
    }
    return events;
}

/// A random scene of particles among surfaces of all kinds, in the plane or in space.
inline SurfaceScene small_box(std::uint64_t seed, int dimension = 2) {
    Random random(seed, "small box with surfaces");
    SurfaceScene scene;
    Gas& gas = scene.gas;
    gas.seed = seed;
    Box& box = gas.box;
    Surfaces& surfaces = box.surfaces;
    surfaces.seed = seed;
    surfaces.side_count = 2 * dimension;
    box.dimension = dimension;
    const bool in_space = dimension == 3;
    for (int axis = 0; axis < dimension; ++axis)
        box.size[axis] = in_space ? random.uniform(2.5, 6.0) : random.uniform(4.0, 10.0);
    for (Wall& wall : box.walls) wall = random.uniform() < 0.25 ? Wall::periodic : Wall::solid;
    const double falls = random.uniform();
    for (int axis = 0; axis < dimension; ++axis)
        if (!box.is_periodic(axis) && (axis == 1 ? falls < 0.6 : falls < 0.2))
            surfaces.gravity[axis] = random.uniform(-2.0, 1.0);
    const bool may_move = random.uniform() < 0.6;
    for (std::size_t side = 0; side < surfaces.numbered_sides().size(); ++side)
        if (!box.is_periodic(side / 2) && random.uniform() < 0.3)
            surfaces.sides[side] = any_behaviour(random, dimension, true, may_move);
    for (std::uint64_t k = random.below(3); k > 0; --k)
        surfaces.partitions.push_back(any_partition(random, box, may_move, "line"));
    for (std::uint64_t k = random.below(3); k > 0; --k) {
        Obstacle obstacle = any_obstacle(random, box, "body");
        if (!may_move || !is_across(obstacle, box))
            surfaces.obstacles.push_back(std::move(obstacle));
    }
    const double radius =
        random.uniform() < 0.15 ? 0.0 : random.uniform(0.02, in_space ? 0.7 : 0.5);
    for (const char* name : {"one", "other"})
        gas.species.push_back({.name = name,
                               .count = static_cast<std::int64_t>(1 + random.below(5)),
                               .radius = UniformDistribution{0.3 * radius, radius},
                               .mass = ValueRule{UniformDistribution{0.3, 3.0}},
                               .velocity = Temperature{random.uniform(0.1, 2.0)}});
    if (random.uniform() < 0.6) scene.events = any_events(random, box, may_move);
    return scene;
}

/// A random scene of beads between active ends.
inline SurfaceScene small_wire(std::uint64_t seed) {
    Random random(seed, "small wire with surfaces");
    SurfaceScene scene;
    Gas& gas = scene.gas;
    gas.seed = seed;
    Box& box = gas.box;
    box.surfaces.seed = seed;
    box.dimension = 1;
    box.size = {random.uniform(5.0, 15.0), 0.0};
    if (random.uniform() < 0.6) box.surfaces.gravity = {random.uniform(-1.0, 1.0), 0.0};
    for (std::size_t side = 0; side < 2; ++side)
        box.surfaces.sides[side] = any_behaviour(random, 1, true, true);
    const double radius = random.uniform() < 0.3 ? 0.0 : random.uniform(0.01, 0.3);
    for (const char* name : {"one", "other"})
        gas.species.push_back({.name = name,
                               .count = static_cast<std::int64_t>(1 + random.below(5)),
                               .radius = radius,
                               .mass = ValueRule{UniformDistribution{0.2, 5.0}},
                               .velocity = Temperature{random.uniform(0.1, 2.0)}});
    if (random.uniform() < 0.6) scene.events = any_events(random, box);
    return scene;
}

}  // namespace carom::test
