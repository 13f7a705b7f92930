// Spheres that meet faces, edges, corners, gaps and cuboids: what happens is worked out by hand.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

#include "physics/box.h"
#include "physics/events/event_loop.h"
#include "physics/mechanics.h"
#include "physics/particles.h"
#include "physics/surfaces/surface_problem.h"
#include "support/bodies.h"
#include "support/relative.h"
#include "support/space.h"
#include "util/random.h"

using namespace carom;
using test::cube_of;
using test::relative;
using test::Sphere;
using test::window;

namespace {

struct Spheres {
    Particles particles;
    Sample start;

    explicit Spheres(const std::vector<Sphere>& all) {
        std::tie(particles, start) = test::start_of(all);
    }
};

template <class Scalar = double>
std::vector<Collision> collisions_until(double end, const Box& box, const Spheres& gas,
                                        int bits = 53) {
    EventLoop<3, Scalar, true> loop(box, gas.particles, {.bits = bits});
    loop.start(gas.start);
    std::vector<Collision> all;
    loop.advance(end, &all);
    return all;
}

void check_vec(const Vec& found, const Vec& expected, double tolerance) {
    for (int axis = 0; axis < 3; ++axis) CHECK(std::abs(found[axis] - expected[axis]) < tolerance);
}

// Which of two spheres is the first does not matter.
void check_same(Collision a, const Collision& b, double tolerance = 1e-14) {
    if (a.second.is_particle() && a.first != b.first) {
        const auto first = a.first;
        a.first = a.second.particle();
        a.second = Partner(first);
        std::swap(a.first_after, a.second_after);
    }
    CHECK(a.first == b.first);
    CHECK((a.second == b.second));
    check_vec(a.first_after, b.first_after, tolerance);
}

}  // namespace

TEST_CASE("a sphere between walls that act flies as its three coordinates fold") {
    Box box = cube_of(10.0);
    box.surfaces.sides[4] = Driven{0.0};  // at rest, but a wall that acts
    const Spheres gas({{{2.0, 3.0, 4.0}, {1.0, -0.5, 0.25}, 1.0}});
    EventLoop<3, double, true> loop(box, gas.particles, {});
    loop.start(gas.start);
    loop.advance(200.0, nullptr);
    Sample end;
    loop.sample(200.0, end);
    // Between 1 and 9 along each axis, unfolded: 1 + 200 = 25 * 8 + 1, 2 - 100 = -12 * 8 - 2, 3 +
    // 50 = 6 * 8 + 5.
    CHECK(end.position(0, 0) == relative(8.0, 1e-13));
    CHECK(end.position(0, 1) == relative(3.0, 1e-13));
    CHECK(end.position(0, 2) == relative(6.0, 1e-13));
    CHECK(loop.counts().wall == 25 + 13 + 6);
    CHECK(loop.surfaces(200.0)[4].hits == 3);
    CHECK(loop.surfaces(200.0)[5].hits == 3);
    CHECK(loop.surfaces(200.0)[5].impulse[2] == relative(3 * 0.5, 1e-14));
    CHECK(loop.impulses().wall[5] == relative(3 * 0.5, 1e-14));
}

// The centre comes down 0.6 beside the edge: at contact it is 0.8 above it.
TEST_CASE("a sphere bounces off an edge at the angle at which it touches it") {
    for (const int axis : {0, 1, 2}) {
        CAPTURE(axis);
        const int a = axis == 0 ? 1 : 0, b = axis == 2 ? 1 : 2;
        Box box = cube_of(10.0);
        box.surfaces.partitions = {window(axis, 4.0, {{3.0, 0.0}, {7.0, 10.0}})};
        Sphere sphere{{}, {}, 1.0};
        sphere.place[axis] = 7.0;
        sphere.place[a] = 3.6;
        sphere.place[b] = 5.0;
        sphere.velocity[axis] = -1.0;
        sphere.velocity[b] = 0.25;
        for (const auto& found : {collisions_until(3.0, box, Spheres({sphere})),
                                  collisions_until<Real>(3.0, box, Spheres({sphere}), 200)}) {
            REQUIRE(found.size() == 1);
            CHECK(found[0].time == relative(2.2, 1e-15));
            CHECK(found[0].second.surface() == 6);
            Vec contact, after;
            contact[axis] = 4.0;
            contact[a] = 3.0;
            contact[b] = 5.55;
            check_vec(found[0].second_position, contact, 1e-14);
            // Reflected at the plane perpendicular to (0.8, 0.6): -1 along it becomes 0.28, -0.96.
            after[axis] = -1.0 + 2.0 * 0.8 * 0.8;
            after[a] = 2.0 * 0.8 * 0.6;
            after[b] = 0.25;
            check_vec(found[0].first_after, after, 1e-14);
        }
    }
}

// 2/7, 3/7 and 6/7 of the radius beside and above the corner of an L.
TEST_CASE("a sphere bounces off a corner along the line of centres") {
    const Vec away{6.0 / 7.0, 2.0 / 7.0, 3.0 / 7.0};
    Box with_cuboid = cube_of(10.0), with_gaps = cube_of(10.0);
    with_cuboid.surfaces.obstacles = {
        {"block", Obstacle::Cuboid{{0.0, 0.0, 0.0}, {4.0, 4.0, 4.0}}}};
    with_gaps.surfaces.partitions = {
        {.name = "L",
         .axis = 0,
         .at = 4.0,
         .gaps = {{{0.0, 4.0}, {10.0, 10.0}}, {{4.0, 0.0}, {10.0, 4.0}}}}};
    for (const Box& box : {with_cuboid, with_gaps}) {
        const Vec x = Vec(4.0, 4.0, 4.0) + away + 2.0 * Vec(1.0, 0.0, 0.0);
        const auto found = collisions_until(3.0, box, Spheres({{x, {-1.0, 0.0, 0.0}, 1.0}}));
        REQUIRE(found.size() == 1);
        CHECK(found[0].time == relative(2.0, 1e-14));
        check_vec(found[0].second_position, {4.0, 4.0, 4.0}, 1e-14);
        check_vec(found[0].first_after, Vec(-1.0, 0.0, 0.0) + 2.0 * away[0] * away, 1e-14);
    }
}

TEST_CASE("a sphere passes a gap that is wider than itself, and no other") {
    for (const double height : {1.999, 2.001}) {
        CAPTURE(height);
        Box box = cube_of(10.0);
        box.surfaces.partitions = {
            window(0, 5.0, {{5.0 - 0.5 * height, 3.0}, {5.0 + 0.5 * height, 7.0}})};
        const auto found =
            collisions_until(5.5, box, Spheres({{{2.0, 5.0, 5.0}, {1.0, 0.0, 0.0}, 1.0}}));
        if (height > 2.0) {
            CHECK(found.empty());
            continue;
        }
        // It touches both rims at once, where sqrt(1 - (height / 2)^2) are left.
        REQUIRE(found.size() == 2);
        CHECK(found[0].time == relative(3.0 - std::sqrt(1.0 - 0.25 * height * height), 1e-14));
        check_vec(found[1].first_after, {-1.0, 0.0, 0.0}, 1e-12);
    }
}

TEST_CASE("a sphere reaches a sphere, and falls onto one, where two radii meet") {
    Box box = cube_of(10.0);
    box.surfaces.obstacles = {{"ball", Obstacle::Ball{{5.0, 5.0, 5.0}, 1.5}}};
    // 0.7, 1.5 and sqrt(2.5^2 - 0.7^2 - 1.5^2) = sqrt(3.51) from centre to centre.
    const double above = std::sqrt(3.51);
    const Sphere sphere{{5.7, 6.5, 5.0 + above + 0.5}, {0.0, 0.0, -0.5}, 1.0};
    const auto found = collisions_until(1.5, box, Spheres({sphere}));
    REQUIRE(found.size() == 1);
    CHECK(found[0].time == relative(1.0, 1e-14));
    check_vec(found[0].first_after, Vec(0.0, 0.0, -0.5) + (above / 6.25) * Vec(0.7, 1.5, above),
              1e-14);

    box.surfaces.gravity = {0.0, 0.0, -0.5};
    Sphere at_rest = sphere;
    at_rest.velocity = {};
    const auto fallen = collisions_until(1.9, box, Spheres({at_rest}));
    REQUIRE(fallen.size() == 1);
    CHECK(fallen[0].time == relative(std::sqrt(2.0), 1e-14));
    check_vec(fallen[0].first_before, {0.0, 0.0, -std::sqrt(0.5)}, 1e-14);
}

TEST_CASE("a sphere at rest on a floor in space stays there until it is hit") {
    Box box = cube_of(10.0);
    box.surfaces.gravity = {0.0, 0.0, -1.0};
    const Spheres gas({{{5.0, 5.0, 1.0}, {}, 1.0}, {{5.0, 5.0, 6.5}, {}, 1.0, 0.5}});
    const auto found = collisions_until(2.9, box, gas);
    // The second one falls by 3.5 to a height of 3; both then approach the floor in one instant.
    REQUIRE(found.size() >= 1);
    CHECK(found[0].time == relative(std::sqrt(7.0), 1e-14));
    CHECK(found[0].second.is_particle());
}

// Along its normal as two particles on a line; across it nothing changes.
TEST_CASE("a sphere and a piston exchange momentum as two masses do") {
    for (const int axis : {0, 1, 2}) {
        CAPTURE(axis);
        const int other = (axis + 1) % 3;
        Box box = cube_of(20.0);
        box.surfaces.sides[static_cast<std::size_t>(2 * axis + 1)] =
            Piston{.mass = 3.0, .velocity = -0.25};
        Sphere sphere{{9.0, 9.0, 9.0}, {}, 1.0, 1.0 / 2.0};
        sphere.velocity[axis] = 0.75;
        sphere.velocity[other] = 0.125;
        const Spheres gas({sphere});
        EventLoop<3, double, true> loop(box, gas.particles, {});
        loop.start(gas.start);
        loop.advance(12.0, nullptr);  // from 10 to 20: they meet after 10 s
        Sample end;
        loop.sample(12.0, end);
        CHECK(end.velocity(0, axis) == relative(0.75 - 2.0 * 3.0 / 5.0, 1e-14));
        CHECK(end.velocity(0, other) == 0.125);
        const auto motion = *loop.surfaces(12.0)[static_cast<std::size_t>(2 * axis + 1)].motion;
        CHECK(motion.velocity == relative(-0.25 + 2.0 * 2.0 / 5.0, 1e-14));
        CHECK(motion.place == relative(17.5 + 2.0 * 0.55, 1e-14));
    }
}

TEST_CASE("a demon along z lets through what it is to let through") {
    Box box = cube_of(10.0);
    box.surfaces.partitions = {
        {.name = "demon",
         .axis = 2,
         .at = 5.0,
         .behaviour =
             Membrane{{}, {.faster_than = 1.0}, {.faster_than = 0.0, .slower_than = 1.0}}}};
    const auto surface_of_first = [&](const Vec& x, const Vec& v) {
        const auto found = collisions_until(9.0, box, Spheres({{x, v, 0.5}}));
        REQUIRE(!found.empty());
        return found[0].second.surface();
    };
    CHECK(surface_of_first({5.0, 5.0, 2.0}, {0.0, 0.0, 1.25}) == 5);   // a fast one to the front
    CHECK(surface_of_first({5.0, 5.0, 2.0}, {0.0, 0.0, 0.75}) == 6);   // a slow one is reflected
    CHECK(surface_of_first({5.0, 5.0, 8.0}, {0.0, 0.0, -1.25}) == 6);  // a fast one, too
    CHECK(surface_of_first({5.0, 5.0, 8.0}, {0.0, 0.0, -0.95}) == 4);  // a slow one to the back
}

// The same system moved by a vector, so that cuboid, rims and spheres lie across periodic sides.
// All coordinates are binary fractions, so that moving them rounds nothing.
TEST_CASE("a periodic box has no sides: a cuboid and a window across them act as elsewhere") {
    const auto make = [](const Vec& shift) {
        Box box = cube_of(16.0, Wall::periodic);
        Obstacle::Cuboid cuboid{{4.0, 5.0, 6.0}, {8.0, 9.0, 11.0}};
        cuboid.low += shift;
        cuboid.high += shift;
        box.surfaces.obstacles = {{"block", cuboid}};
        const auto wrapped = [&](double x, int axis) { return box.wrapped(axis, x + shift[axis]); };
        Partition partition{.name = "window", .axis = 0, .at = wrapped(12.0, 0)};
        // The gap from y = 6 to 12 and z = 2 to 6, cut where it crosses a side.
        const auto cut = [](double low, double high) {
            using Parts = std::vector<std::array<double, 2>>;
            return low < high ? Parts{{low, high}} : Parts{{low, 16.0}, {0.0, high}};
        };
        for (const auto& y : cut(wrapped(6.0, 1), wrapped(12.0, 1)))
            for (const auto& z : cut(wrapped(2.0, 2), wrapped(6.0, 2)))
                partition.gaps.push_back({{y[0], z[0]}, {y[1], z[1]}});
        box.surfaces.partitions = {partition};
        std::vector<Sphere> spheres;
        Random random(7, "spheres");
        for (const Vec& x : {Vec(2.0, 2.0, 2.0), Vec(2.0, 10.0, 3.0), Vec(10.0, 2.0, 14.0),
                             Vec(14.0, 12.0, 12.0), Vec(14.0, 4.0, 5.0), Vec(10.0, 12.0, 4.0)}) {
            Sphere sphere{{wrapped(x[0], 0), wrapped(x[1], 1), wrapped(x[2], 2)}, {}, 0.75};
            for (int axis = 0; axis < 3; ++axis) sphere.velocity[axis] = random.uniform(-1.0, 1.0);
            spheres.push_back(sphere);
        }
        return collisions_until<Real>(300.0, box, Spheres(spheres), 512);
    };
    const auto here = make({});
    REQUIRE(here.size() > 60);
    int cuboid = 0, partition = 0;
    for (const Vec& shift : {Vec(8.0, 0.0, 0.0), Vec(10.0, 9.0, 7.0), Vec(0.0, 8.0, -3.0)}) {
        const auto there = make(shift);
        REQUIRE(there.size() == here.size());
        for (std::size_t k = 0; k < here.size(); ++k) {
            CHECK(there[k].time == here[k].time);
            check_same(there[k], here[k]);
            if (here[k].second.is_particle()) continue;
            cuboid += here[k].second.surface() == 7 ? 1 : 0;
            partition += here[k].second.surface() == 6 ? 1 : 0;
        }
    }
    CHECK(cuboid > 20);
    CHECK(partition > 20);
}

TEST_CASE("energy is conserved among all kinds of surfaces in space, and nothing gets into them") {
    Box box = test::space_of({12.0, 11.0, 10.0}, {Wall::solid, Wall::solid, Wall::periodic});
    box.surfaces.gravity = {0.0, -0.5, 0.0};
    constexpr double mass = 30.0, force = -20.0;
    box.surfaces.sides[3] = Piston{.mass = mass, .force = force};
    box.surfaces.partitions = {window(0, 6.0, {{3.0, 0.0}, {5.0, 3.0}})};
    box.surfaces.obstacles = {{"peg", Obstacle::Ball{{3.0, 3.0, 9.5}, 0.7}},
                              {"shelf", Obstacle::Cuboid{{8.0, 2.0, 4.0}, {10.0, 2.5, 11.0}}}};
    std::vector<Sphere> spheres;
    Random random(8, "spheres");
    for (const double x : {1.0, 2.5, 4.0, 7.0, 8.5, 11.0})
        for (const double y : {0.75, 4.5, 6.0})
            for (const double z : {1.0, 3.0, 5.0}) {
                Sphere sphere{{x, y, z}, {}, 0.4, random.below(2) == 0 ? 1.0 : 0.25};
                for (int axis = 0; axis < 3; ++axis) sphere.velocity[axis] = random.normal();
                spheres.push_back(sphere);
            }
    const Spheres gas(spheres);
    EventLoop<3, double, true> loop(box, gas.particles, {});
    loop.start(gas.start);
    Sample now = gas.start;
    const auto energy = [&](double time) {
        const auto lid = *loop.surfaces(time)[3].motion;
        return kinetic_energies(gas.particles, now).sum() +
               (0.5 * now.position.col(1) / gas.particles.inverse_mass).sum() +
               0.5 * mass * lid.velocity * lid.velocity - (force - 0.5 * mass) * lid.place;
    };
    const double at_start = energy(0.0);
    const InitialBarriers barriers(box);
    double deepest = 0.0, error = 0.0;
    for (double time = 0.5; time < 100.0; time += 0.5) {
        loop.advance(time, nullptr);
        loop.sample(time, now);
        error = std::max(error, std::abs(energy(time) / at_start - 1.0));
        for (Eigen::Index i = 0; i < now.position.rows(); ++i) {
            const Vec x = vec_in(now.position, i);
            for (const double less : {1e-9, 1e-6})
                if (x[1] < 10.0 && barriers.surface_in_the_way(box, x, 0.4 - less))
                    deepest = std::max(deepest, less);
        }
    }
    CHECK(deepest == 0.0);
    CHECK(error < 1e-11);
    CHECK(loop.counts().wall > 2000);
    CHECK(loop.counts().particle > 1000);
    for (const std::size_t surface : {0U, 1U, 2U, 3U, 6U, 7U, 8U})
        CHECK(loop.surfaces(100.0)[surface].hits > 20);
}

// A window that opens, a wall that is set in motion and heat are undone on the way back.
TEST_CASE("with many bits a gas among surfaces in space returns to its start") {
    Box box = cube_of(10.0);
    box.surfaces.gravity = {0.0, -0.25, 0.0};
    box.surfaces.sides[5] = Piston{.mass = 8.0, .force = -2.0};
    box.surfaces.partitions = {{.name = "divider", .axis = 0, .at = 5.0},
                               window(1, 5.0, {{1.0, 2.0}, {4.0, 6.0}})};
    box.surfaces.obstacles = {{"block", Obstacle::Cuboid{{6.0, 6.5, 1.0}, {8.5, 8.0, 5.0}}}};
    std::vector<Sphere> spheres;
    Random random(10, "spheres");
    for (const Vec& x : {Vec(2.0, 2.0, 2.0), Vec(2.0, 7.0, 2.0), Vec(3.0, 2.0, 7.0),
                         Vec(7.0, 2.0, 3.0), Vec(7.0, 3.0, 7.0)}) {
        Sphere sphere{x, {}, 0.8};
        for (int axis = 0; axis < 3; ++axis) sphere.velocity[axis] = random.normal();
        spheres.push_back(sphere);
    }
    const Spheres gas(spheres);
    EventLoop<3, Real, true> loop(box, gas.particles, {.bits = 1024});
    loop.start(gas.start);
    const auto start = loop.positions(0.0);
    const auto kinetic = [&](double time) {
        Sample now;
        loop.sample(time, now);
        return kinetic_energies(gas.particles, now).sum();
    };
    loop.advance(6.0, nullptr);
    const double before = kinetic(6.0);
    REQUIRE(loop.heat({.species = {}, .amount = 3.0}, true, 6.0));
    CHECK(kinetic(6.0) == relative(before + 3.0, 1e-14));
    CHECK(loop.heat_of_events() == relative(3.0, 1e-14));
    loop.advance(10.0, nullptr);
    REQUIRE_FALSE(loop.change(SetOpen{6}, true, 10.0).has_value());
    loop.advance(15.0, nullptr);
    REQUIRE_FALSE(loop.change(MoveSurface{1, 0.125}, true, 15.0).has_value());
    loop.advance(20.0, nullptr);
    loop.reverse(20.0);
    loop.advance(40.0, nullptr);
    CHECK(loop.counts().wall > 100);
    CHECK(loop.counts().particle > 4);
    for (const std::size_t surface : {5U, 6U, 7U, 8U}) CHECK(loop.surfaces(40.0)[surface].hits > 0);
    const auto end = loop.positions(40.0);
    double furthest = 0.0;
    for (std::size_t k = 0; k < end.size(); ++k)
        furthest = std::max(furthest, std::abs(static_cast<double>(end[k] - start[k])));
    CHECK(furthest < 1e-100);
}

TEST_CASE("doubles and many bits agree until round-off has grown") {
    Box box = cube_of(10.0);
    box.surfaces.gravity = {0.1, -0.25, 0.05};
    box.surfaces.partitions = {window(2, 5.0, {{2.0, 2.0}, {6.0, 5.0}})};
    box.surfaces.obstacles = {{"block", Obstacle::Cuboid{{6.0, 6.0, 6.0}, {8.0, 8.0, 8.0}}}};
    std::vector<Sphere> spheres;
    Random random(9, "spheres");
    for (const double x : {1.5, 4.0})
        for (const double y : {1.5, 4.5, 8.0})
            for (const double z : {1.5, 8.5}) {
                Sphere sphere{{x, y, z}, {}, 0.7};
                for (int axis = 0; axis < 3; ++axis) sphere.velocity[axis] = random.normal();
                spheres.push_back(sphere);
            }
    const Spheres gas(spheres);
    const auto rough = collisions_until(8.0, box, gas);
    const auto precise = collisions_until<Real>(8.0, box, gas, 200);
    REQUIRE(precise.size() == rough.size());
    REQUIRE(rough.size() > 40);
    for (std::size_t k = 0; k < rough.size(); ++k) {
        check_same(rough[k], precise[k], 1e-6);
        CHECK(std::abs(rough[k].time - precise[k].time) < 1e-7);
    }
}
