// The slow simulator of surfaces in space, against what is known without one.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <exception>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "physics/placement/placement.h"
#include "support/bodies.h"
#include "support/scattered.h"
#include "support/slow_surfaces.h"
#include "support/space.h"
#include "support/surface_scenes.h"
#include "util/random.h"

using namespace carom;
using test::SlowSurfaces;
using test::SlowVector;
using test::Sphere;

namespace {

// Where a cuboid, which may be a thin plate, or a plate with one rectangular hole is nearest to a
// point: by clamping its coordinates, not by faces, edges and corners.
SlowVector nearest_of(const Obstacle::Cuboid& cuboid, const SlowVector& x) {
    SlowVector nearest;
    for (int axis = 0; axis < 3; ++axis)
        nearest[axis] = std::clamp<long double>(x[axis], cuboid.low[axis], cuboid.high[axis]);
    return nearest;
}

SlowVector nearest_of(const Partition& plate, const SlowVector& x) {
    SlowVector nearest = x;
    nearest[plate.axis] = plate.at;
    const Gap& gap = plate.gaps.at(0);
    const int axes[] = {plate.axis == 0 ? 1 : 0, plate.axis == 2 ? 1 : 2};
    long double least = test::infinite;
    SlowVector rim = nearest;
    for (const std::size_t k : {0U, 1U}) {
        const long double place = x[axes[k]];
        if (place <= gap.low[k] || place >= gap.high[k]) return nearest;
        for (const long double end : {gap.low[k], gap.high[k]}) {
            if (std::abs(place - end) >= least) continue;
            least = std::abs(place - end);
            rim = nearest;
            rim[axes[k]] = end;
        }
    }
    return rim;
}

// A sphere among the walls of a box and one body.
struct Flight {
    Box box;
    Sphere sphere;
    Obstacle::Cuboid solid = {};  // the body, unless it is a plate with a hole

    SlowVector at(long double t) const {
        return test::slow(sphere.place) +
               t * (test::slow(sphere.velocity) + 0.5L * t * test::slow(box.surfaces.gravity));
    }
    SlowVector nearest(const SlowVector& x) const {
        const std::vector<Partition>& plates = box.surfaces.partitions;
        const bool has_hole = !plates.empty() && plates[0].gaps.size() == 1;
        return has_hole ? nearest_of(plates[0], x) : nearest_of(solid, x);
    }
    long double to_walls(const SlowVector& x) const {
        long double least = test::infinite;
        for (int axis = 0; axis < 3; ++axis)
            least = std::min({least, x[axis], box.size[axis] - x[axis]});
        return least - sphere.radius;
    }
    long double to_body(const SlowVector& x) const { return size(x - nearest(x)) - sphere.radius; }
    long double clearance(const SlowVector& x) const { return std::min(to_walls(x), to_body(x)); }

    // The smallest clearance before `end`, found by steps in which nothing can be reached.
    long double least_before(long double end) const {
        const long double fastest =
            length(sphere.velocity) + static_cast<double>(end) * length(box.surfaces.gravity);
        long double least = test::infinite;
        for (long double t = 0.0L; t < end;) {
            const long double now = clearance(at(t));
            least = std::min(least, now);
            t += std::max(now / fastest, 1e-4L);
        }
        return least;
    }
};

Flight any_flight(std::uint64_t seed) {
    Random random(seed, "a sphere and a body");
    Flight flight{test::space_of({8.0, 8.0, 8.0}), {}};
    Sphere& sphere = flight.sphere;
    Surfaces& surfaces = flight.box.surfaces;
    const auto anywhere = [&](double from, double to) {
        return Vec{random.uniform(from, to), random.uniform(from, to), random.uniform(from, to)};
    };
    if (random.uniform() < 0.8) surfaces.gravity = anywhere(-2.0, 2.0);
    sphere.radius = random.uniform(0.1, 1.0);
    if (seed % 3 == 0) {
        const Vec low = anywhere(2.5, 4.0);
        flight.solid = {low, low + anywhere(0.1, 1.5)};
        surfaces.obstacles = {{"block", flight.solid}};
    } else {
        Partition plate{.name = "plate", .axis = static_cast<int>(random.below(3)), .at = 4.0};
        const int axes[] = {plate.axis == 0 ? 1 : 0, plate.axis == 2 ? 1 : 2};
        std::array<double, 2> low{}, high{};
        for (const std::size_t k : {0U, 1U}) {
            low[k] = random.uniform(2.0, 3.9);
            high[k] = low[k] + random.uniform(0.5, 4.0);
        }
        if (seed % 3 == 1) {
            plate.gaps = {{low, high}};
        } else {  // nothing but this rectangle is left of it
            plate.gaps = {{{0.0, 0.0}, {low[0], 8.0}},
                          {{low[0], 0.0}, {high[0], low[1]}},
                          {{low[0], high[1]}, {high[0], 8.0}},
                          {{high[0], 0.0}, {8.0, 8.0}}};
            flight.solid.low[plate.axis] = flight.solid.high[plate.axis] = plate.at;
            for (const std::size_t k : {0U, 1U}) {
                flight.solid.low[axes[k]] = low[k];
                flight.solid.high[axes[k]] = high[k];
            }
        }
        surfaces.partitions = {plate};
    }
    do {
        sphere.place = anywhere(sphere.radius, 8.0 - sphere.radius);
        sphere.velocity = 0.5 * (anywhere(3.0, 5.0) - sphere.place) + anywhere(-0.2, 0.2);
    } while (flight.to_body(test::slow(sphere.place)) < 0.01L);
    return flight;
}

}  // namespace

TEST_CASE("a flying or falling sphere meets faces, edges and corners when it is as near to them") {
    std::array<int, 4> met{};  // walls, faces, edges, corners
    for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
        CAPTURE(seed);
        const Flight flight = any_flight(seed);
        const auto [particles, start] = test::start_of(std::vector<Sphere>{flight.sphere});
        SlowSurfaces slow(flight.box, particles, start);
        const auto contact = slow.advance(50.0L);
        if (!contact) {
            REQUIRE(flight.least_before(50.0L) > 0.0L);
            continue;
        }
        const SlowVector x = slow.bodies()[0].x, before = slow.bodies()[0].v;
        REQUIRE(size(x - flight.at(slow.time())) < 1e-15L * (1.0L + slow.time()));
        REQUIRE(flight.least_before(slow.time()) > -1e-10L);
        const bool is_wall = contact->second >= -6;
        REQUIRE(std::abs(is_wall ? flight.to_walls(x) : flight.to_body(x)) < 1e-10L);
        const SlowVector from = flight.nearest(x);
        slow.collide(*contact, {});
        if (is_wall) {
            ++met[0];
            continue;
        }
        const SlowVector normal = (1.0L / size(x - from)) * (x - from);
        const SlowVector after = before - 2.0L * dot(normal, before) * normal;
        REQUIRE(dot(normal, before) < 0.0L);
        // The slack of a contact turns its normal by as much relative to the radius.
        REQUIRE(size(slow.bodies()[0].v - after) < 1e-9L * size(before));
        int directions = 0;
        for (int axis = 0; axis < 3; ++axis) directions += normal[axis] != 0.0L ? 1 : 0;
        ++met.at(static_cast<std::size_t>(directions));
    }
    for (const int each : met) CHECK(each > 20);
}

TEST_CASE("a sphere goes through a window that is a little wider, not through a narrower one") {
    for (const double wider : {-1e-9, 1e-9})
        for (const int axis : {0, 1, 2}) {
            CAPTURE(axis);
            Flight flight{test::space_of({8.0, 8.0, 8.0}), {{4.0, 4.0, 4.0}, {}, 0.5}};
            flight.sphere.place[axis] = 1.0;
            flight.sphere.velocity[axis] = 1.0;
            const double low = 3.5 - wider, high = 4.5 + wider;
            flight.box.surfaces.partitions = {
                {.name = "window", .axis = axis, .at = 4.0, .gaps = {{{low, low}, {high, high}}}}};
            const auto [particles, start] = test::start_of(std::vector<Sphere>{flight.sphere});
            SlowSurfaces slow(flight.box, particles, start);
            const auto contact = slow.advance(20.0L);
            REQUIRE(contact.has_value());
            CHECK(contact->second == (wider > 0.0 ? -1 - (2 * axis + 1) : -1 - 6));
            // It meets edges where it reaches over them by 1e-9, at a grazing angle.
            const long double away = std::sqrt(0.25L - (0.5L - 1e-9L) * (0.5L - 1e-9L));
            const long double early = slow.slack() * (wider > 0.0 ? 1.0L : 0.5L / away);
            CHECK(std::abs(slow.time() - (wider > 0.0 ? 6.5L : 3.0L - away)) < 2.0L * early);
        }
}

TEST_CASE("pistons, driven walls, membranes and demons act on spheres along their own axis") {
    for (const int axis : {0, 1, 2}) {
        CAPTURE(axis);
        const auto after_hit = [&](const Behaviour& behaviour, double speed) {
            Box box = test::space_of({8.0, 8.0, 8.0});
            box.surfaces.partitions = {
                {.name = "wall", .axis = axis, .at = 4.0, .behaviour = behaviour}};
            Sphere sphere{{2.0, 2.0, 2.0}, {0.25, 0.25, 0.25}, 0.5, 1.0};
            sphere.velocity[axis] = speed;
            const auto [particles, start] = test::start_of(std::vector<Sphere>{sphere});
            SlowSurfaces slow(box, particles, start);
            const auto contact = slow.advance(20.0L);
            REQUIRE(contact.has_value());
            slow.collide(*contact, {});
            struct Found {
                long double time, velocity, of_wall;
                bool is_of_wall;
            };
            for (int other = 0; other < 3; ++other)
                if (other != axis && contact->second == -7)
                    REQUIRE(slow.bodies()[0].v[other] == 0.25L);
            return Found{slow.time(), slow.bodies()[0].v[axis], slow.movers()[6].velocity,
                         contact->second == -7};
        };
        const auto near = [](long double found, long double expected) {
            return std::abs(found - expected) < 1e-11L;
        };
        const auto piston = after_hit(Piston{.mass = 3.0, .force = 0.0, .velocity = -0.5}, 1.0);
        CHECK(near(piston.time, 1.0L));
        CHECK(near(piston.velocity, 1.0L - 2.0L * 0.75L * 1.5L));
        CHECK(near(piston.of_wall, -0.5L + 2.0L * 0.25L * 1.5L));
        const auto driven = after_hit(Driven{.velocity = -0.5}, 1.0);
        CHECK(near(driven.time, 1.0L));
        CHECK(near(driven.velocity, -2.0L));
        const auto reflected = after_hit(Reflecting{}, 1.0);
        CHECK(near(reflected.time, 1.5L));
        CHECK(near(reflected.velocity, -1.0L));
        CHECK(!after_hit(Membrane{.species = {0}}, 1.0).is_of_wall);
        const Membrane demon{.species = {}, .upward = {.faster_than = 1.5}, .downward = {}};
        CHECK(after_hit(demon, 1.0).is_of_wall);
        CHECK(!after_hit(demon, 1.5).is_of_wall);  // the speed, not its component
    }
}

namespace {

// Two boxes that are the same but for the order and the number of axes: axis k of the first is axis
// to[k] of the second.
struct Mapping {
    std::array<int, 3> to{0, 1, 2};
    std::int32_t sides = 6;  // of the first

    Vec of(const Vec& a) const {
        Vec b;
        for (std::size_t k = 0; k < 3; ++k) b[to[k]] = a[k];
        return b;
    }
    std::int32_t of_surface(std::int32_t k) const {
        return k < sides ? 2 * to.at(static_cast<std::size_t>(k / 2)) + k % 2 : k - sides + 6;
    }
    std::int32_t of_partner(std::int32_t second) const {
        return second < 0 ? -1 - of_surface(-1 - second) : second;
    }
    std::vector<RunEvent> of(std::vector<RunEvent> events) const {
        for (RunEvent& event : events)
            std::visit(
                [&](auto& action) {
                    if constexpr (requires { action.surface; })
                        action.surface = of_surface(action.surface);
                },
                event.action);
        return events;
    }
};

// What happens in two boxes, until round-off has grown. Returns how many contacts were compared.
int compare(SlowSurfaces first, const std::vector<RunEvent>& events, SlowSurfaces second,
            const Mapping& mapping) {
    const std::vector<RunEvent> others = mapping.of(events);
    long double off = 1e-12L;  // the slack of contacts
    int compared = 0;
    const auto go_on = [&](long double end) {
        while (compared < 30 && off < 1e-7L) {
            const auto expected = first.advance(end), found = second.advance(end);
            CAPTURE(compared);
            CAPTURE(static_cast<double>(first.time()));
            CAPTURE(static_cast<double>(second.time()));
            CAPTURE(static_cast<double>(off));
            REQUIRE(found.has_value() == expected.has_value());
            if (!expected) return true;
            REQUIRE(found->first == expected->first);
            REQUIRE(found->second == mapping.of_partner(expected->second));
            const long double now = std::abs(first.time() - second.time());
            REQUIRE(now < 1e4L * off);
            off = std::max(off, now);
            first.collide(*expected, {});
            second.collide(*found, {});
            ++compared;
            if (first.least_room() < 1e-6L) return false;
        }
        return false;
    };
    std::vector<std::int32_t> in_the_way;
    for (std::size_t k = 0; k < events.size(); ++k) {
        if (!go_on(events[k].at)) return compared;
        const bool can_be = first.apply(events[k], in_the_way);
        REQUIRE(second.apply(others[k], in_the_way) == can_be);
        if (!can_be) return compared;
    }
    go_on(20.0L);
    return compared;
}

// Whether nothing in the scene is random.
bool is_determined(const test::SurfaceScene& scene) {
    const Surfaces& its = scene.gas.box.surfaces;
    return std::ranges::none_of(its.sides, is_random) &&
           std::ranges::none_of(its.partitions, is_random, &Partition::behaviour) &&
           std::ranges::none_of(scene.events, [](const RunEvent& event) {
               const auto given = given_behaviour(event);
               return given && is_random(given->second);
           });
}

}  // namespace

TEST_CASE("no axis of space differs from another") {
    int compared = 0, scenes = 0;
    const std::array<std::array<int, 3>, 5> orders{
        {{1, 2, 0}, {2, 0, 1}, {1, 0, 2}, {0, 2, 1}, {2, 1, 0}}};
    for (std::uint64_t seed = 1; seed <= 400; ++seed) {
        CAPTURE(seed);
        const test::SurfaceScene scene = test::small_box(seed, 3);
        if (!is_determined(scene)) continue;
        const Box& box = scene.gas.box;
        Random random(seed, "spheres among surfaces");
        const std::vector<Sphere> spheres = test::scattered(box, random, 4, 0.1, 0.5);
        auto [particles, start] = test::start_of(spheres);
        particles.species << 0, 1, 0, 1;
        const SlowSurfaces first(box, particles, start);
        if (first.least_gap() < 0.01L) continue;
        const Mapping mapping{orders.at(seed % orders.size())};
        Box other = test::space_of(mapping.of(box.size));
        other.surfaces.gravity = mapping.of(box.surfaces.gravity);
        for (std::size_t axis = 0; axis < 3; ++axis)
            other.walls.at(static_cast<std::size_t>(mapping.to.at(axis))) = box.walls.at(axis);
        for (std::int32_t side = 0; side < 6; ++side)
            other.surfaces.sides.at(static_cast<std::size_t>(mapping.of_surface(side))) =
                box.surfaces.sides.at(static_cast<std::size_t>(side));
        for (Partition partition : box.surfaces.partitions) {
            const auto corner = [&](const Gap& gap, bool high) {
                Vec at;
                std::size_t k = 0;
                for (int axis = 0; axis < 3; ++axis)
                    if (axis != partition.axis) at[axis] = (high ? gap.high : gap.low)[k++];
                return mapping.of(at);
            };
            const int axis = mapping.to.at(static_cast<std::size_t>(partition.axis));
            for (Gap& gap : partition.gaps) {
                const Vec low = corner(gap, false), high = corner(gap, true);
                const int a = axis == 0 ? 1 : 0, b = axis == 2 ? 1 : 2;
                gap = {{low[a], low[b]}, {high[a], high[b]}};
            }
            partition.axis = axis;
            other.surfaces.partitions.push_back(partition);
        }
        for (Obstacle obstacle : box.surfaces.obstacles) {
            if (auto* ball = std::get_if<Obstacle::Ball>(&obstacle.shape))
                ball->center = mapping.of(ball->center);
            else if (auto* cuboid = std::get_if<Obstacle::Cuboid>(&obstacle.shape))
                *cuboid = {mapping.of(cuboid->low), mapping.of(cuboid->high)};
            other.surfaces.obstacles.push_back(obstacle);
        }
        std::vector<Sphere> moved = spheres;
        for (Sphere& sphere : moved) {
            sphere.place = mapping.of(sphere.place);
            sphere.velocity = mapping.of(sphere.velocity);
        }
        const Sample there = test::start_of(moved).second;
        compared += compare(first, scene.events, SlowSurfaces(other, particles, there), mapping);
        ++scenes;
    }
    CHECK(scenes > 60);
    CHECK(compared > 1'000);
}

TEST_CASE("spheres in one plane meet the same surfaces as disks") {
    int compared = 0, scenes = 0;
    for (std::uint64_t seed = 1; seed <= 500; ++seed) {
        CAPTURE(seed);
        test::SurfaceScene scene = test::small_box(seed);
        if (!is_determined(scene)) continue;
        // A temperature is an energy for each degree of freedom, of which spheres have more.
        std::erase_if(scene.events, [](const RunEvent& event) {
            const auto* heat = std::get_if<Heat>(&event.action);
            return heat != nullptr && std::holds_alternative<Temperature>(heat->amount);
        });
        Box& box = scene.gas.box;
        constexpr double depth = 12.0;  // more than all other lengths
        Box other = test::space_of({box.size[0], box.size[1], depth}, box.walls);
        other.walls[2] = seed % 2 == 0 ? Wall::solid : Wall::periodic;
        for (std::size_t side = 0; side < 4; ++side)
            other.surfaces.sides[side] = box.surfaces.sides[side];
        other.surfaces.gravity = box.surfaces.gravity;
        for (Partition partition : box.surfaces.partitions) {
            for (Gap& gap : partition.gaps) gap.high[1] = depth;
            other.surfaces.partitions.push_back(partition);
        }
        std::vector<Obstacle> obstacles;
        for (const Obstacle& obstacle : box.surfaces.obstacles) {
            Obstacle one = obstacle;
            if (auto* ball = std::get_if<Obstacle::Ball>(&one.shape)) {
                ball->center[2] = 0.5 * depth;
            } else {
                const auto& lines = std::get<Obstacle::Lines>(one.shape);
                const Vec low = lines.corners.front(), size = lines.corners.at(1) - low;
                // Rectangles are listed from their lower left corner.
                if (!lines.is_closed || size[1] != 0.0) continue;
                Vec high = lines.corners.at(2);
                high[2] = depth;
                one.shape = Obstacle::Cuboid{low, high};
            }
            obstacles.push_back(obstacle);
            other.surfaces.obstacles.push_back(one);
        }
        box.surfaces.obstacles = obstacles;
        std::optional<std::pair<Particles, Sample>> placed;
        try {
            placed = place(scene.gas);
        } catch (const std::exception&) {
            continue;  // the disks do not fit
        }
        const auto& [particles, start] = *placed;
        if ((particles.radius == 0.0).any()) continue;  // the slack loses the side of a point
        compared +=
            compare(SlowSurfaces(box, particles, start), scene.events,
                    SlowSurfaces(other, particles, test::in_space(start, depth)), {.sides = 4});
        ++scenes;
    }
    CHECK(scenes > 100);
    CHECK(compared > 2'000);
}
