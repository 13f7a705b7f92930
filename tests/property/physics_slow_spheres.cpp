// The slow simulators of spheres themselves, against what is known without one.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "physics/placement/placement.h"
#include "support/bodies.h"
#include "support/scattered.h"
#include "support/slow_simulator.h"
#include "support/slow_surfaces.h"
#include "support/small_scenes.h"
#include "support/space.h"
#include "util/random.h"

using namespace carom;
using test::SlowContact;
using test::SlowEvent;
using test::SlowSimulator;
using test::SlowSurfaces;
using test::SlowVector;
using test::Sphere;

namespace {

constexpr long double ever = 1e9L;

// The next contact among surfaces, which is carried out.
std::optional<std::pair<long double, SlowContact>> next(SlowSurfaces& slow, long double end) {
    const auto contact = slow.advance(end);
    if (!contact) return std::nullopt;
    slow.collide(*contact, {});
    return std::pair{slow.time(), *contact};
}

long double apart(const SlowVector& a, const SlowVector& b) { return size(a - b); }

// Unit vectors with rational components.
const std::vector<SlowVector>& rational_normals() {
    static const std::vector<SlowVector> all = [] {
        std::vector<SlowVector> some;
        for (const std::array<int, 4>& q : {std::array{1, 2, 2, 3},
                                            {-2, 3, 6, 7},
                                            {4, -4, 7, 9},
                                            {-6, -7, 6, 11},
                                            {8, 1, -4, 9},
                                            {0, 3, 4, 5}})
            some.push_back((1.0L / q[3]) * SlowVector{static_cast<long double>(q[0]),
                                                      static_cast<long double>(q[1]),
                                                      static_cast<long double>(q[2])});
        return some;
    }();
    return all;
}

Vec rounded(const SlowVector& a) {
    return {static_cast<double>(a.x), static_cast<double>(a.y), static_cast<double>(a.z)};
}

}  // namespace

TEST_CASE("a sphere alone flies from wall to wall as in an unfolded box") {
    const Box box = test::space_of({5.0, 4.0, 3.0});
    const std::vector<Sphere> spheres{{{1.25, 2.0, 1.5}, {0.7, -1.1, 0.4}, 0.25}};
    const auto [particles, start] = test::start_of(spheres);
    SlowSimulator slow(box, particles, start);
    SlowSurfaces among_surfaces(box, particles, start);
    std::array<int, 6> hits{};
    // Of 300 additions to lengths and times up to 500.
    constexpr long double rounding = 300.0L * 500.0L * std::numeric_limits<long double>::epsilon();
    for (int k = 0; k < 300; ++k) {
        const SlowEvent event = *slow.next(ever);
        const auto other = *next(among_surfaces, ever);
        REQUIRE(event.first == 0);
        REQUIRE(other.second.second == event.second);
        REQUIRE(std::abs(other.first - event.time) < 1e-9L);
        ++hits.at(static_cast<std::size_t>(-1 - event.second));
        for (int axis = 0; axis < 3; ++axis) {
            const long double room = box.size[axis] - 2.0 * 0.25;
            const long double flown =
                spheres[0].place[axis] - 0.25L +
                static_cast<long double>(spheres[0].velocity[axis]) * event.time;
            const long double wave = std::abs(std::remainder(flown, 2.0L * room));
            REQUIRE(std::abs(slow.place(0)[axis] - 0.25L - wave) < rounding);
            REQUIRE(std::abs(among_surfaces.bodies()[0].x[axis] - 0.25L - wave) < 1e-9L);
        }
        const int axis = (-1 - event.second) / 2;
        const long double wall = event.second % 2 == 0 ? box.size[axis] - 0.25L : 0.25L;
        REQUIRE(std::abs(slow.place(0)[axis] - wall) < rounding);
    }
    for (std::size_t side = 0; side < 6; side += 2)
        CHECK(std::abs(hits[side] - hits[side + 1]) < 2);
}

TEST_CASE("two spheres meet at the exact time and part with the exact velocities") {
    constexpr long double time = 1.75L;
    for (const Wall walls : {Wall::solid, Wall::periodic})
        for (const SlowVector& normal : rational_normals()) {
            Box box = test::space_of({40.0, 44.0, 48.0}, {walls, walls, walls});
            const SlowVector va{0.5L, -0.25L, 1.0L};
            const SlowVector vb = va - 2.0L * normal + SlowVector{0.25L, 0.125L, -0.375L};
            const SlowVector meeting = walls == Wall::solid ? SlowVector{20.0L, 20.0L, 20.0L}
                                                            : SlowVector{0.5L, 43.5L, 47.75L};
            const auto inside = [&](const SlowVector& x) {
                const Vec place = rounded(x);
                return Vec{box.wrapped(0, place[0]), box.wrapped(1, place[1]),
                           box.wrapped(2, place[2])};
            };
            const auto [particles, start] = test::start_of(
                {{inside(meeting - time * va), rounded(va), 0.75, 1.0},
                 {inside(meeting + 2.0L * normal - time * vb), rounded(vb), 1.25, 0.25}});
            const long double approach = dot(normal, vb - va);
            const SlowVector after_a = va + (1.6L * approach) * normal,
                             after_b = vb - (0.4L * approach) * normal;
            SlowSimulator slow(box, particles, start);
            const SlowEvent event = *slow.next(ever);
            // Places and velocities of the start are rounded to doubles.
            CHECK(std::abs(event.time - time) < 1e-13L);
            CHECK(event.first == 0);
            CHECK(event.second == 1);
            CHECK(apart(slow.velocity(0), after_a) < 1e-13L);
            CHECK(apart(slow.velocity(1), after_b) < 1e-13L);
            SlowSurfaces among_surfaces(box, particles, start);
            const auto found = *next(among_surfaces, ever);
            CHECK(std::abs(found.first - time) < 1e-10L);  // its slack
            CHECK(found.second.second == 1);
            CHECK(apart(among_surfaces.bodies()[0].v, after_a) < 1e-10L);
            CHECK(apart(among_surfaces.bodies()[1].v, after_b) < 1e-10L);
        }
}

TEST_CASE("spheres keep their energy, and between periodic sides their momentum") {
    for (const Wall walls : {Wall::solid, Wall::periodic}) {
        Random random(3, "slow spheres");
        const Box box = test::space_of({4.0, 5.0, 4.5}, {walls, walls, walls});
        const std::vector<Sphere> spheres = test::scattered(box, random, 9, 0.2, 0.8);
        const auto [particles, start] = test::start_of(spheres);
        SlowSimulator slow(box, particles, start);
        const auto energy_and_momentum = [&] {
            long double energy = 0.0L;
            SlowVector momentum;
            for (std::int32_t i = 0; i < 9; ++i) {
                const long double mass = 1.0L / spheres[static_cast<std::size_t>(i)].inverse_mass;
                energy += 0.5L * mass * dot(slow.velocity(i), slow.velocity(i));
                momentum = momentum + mass * slow.velocity(i);
            }
            return std::pair{energy, momentum};
        };
        const auto [energy, momentum] = energy_and_momentum();
        int pairs = 0;
        for (int k = 0; k < 1000; ++k) {
            pairs += slow.next(ever)->second >= 0 ? 1 : 0;
            for (std::int32_t i = 0; i < 9; ++i)
                for (std::int32_t j = 0; j < i; ++j) {
                    const Vec r = box.nearest(rounded(slow.place(i) - slow.place(j)));
                    REQUIRE(length(r) > particles.radius[i] + particles.radius[j] - 1e-14);
                }
        }
        CHECK(pairs > 200);
        const auto [end_energy, end_momentum] = energy_and_momentum();
        CHECK(std::abs(end_energy / energy - 1.0L) < 1e-15L);
        if (walls == Wall::periodic) CHECK(apart(end_momentum, momentum) < 1e-15L * 30.0L);
    }
}

TEST_CASE("spheres in one plane do what disks do, to the last bit") {
    int compared = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        CAPTURE(seed);
        const Gas gas = test::small_scene(seed);
        const auto [particles, start] = place(gas);
        const double depth = gas.box.longest_side();  // the steps of the simulators are the same
        const Wall back_and_front = seed % 2 == 0 ? Wall::solid : Wall::periodic;
        const Box box = test::space_of({gas.box.size[0], gas.box.size[1], depth},
                                       {gas.box.walls[0], gas.box.walls[1], back_and_front});
        SlowSimulator disks(gas.box, particles, start),
            spheres(box, particles, test::in_space(start, depth));
        for (int k = 0; k < 40; ++k) {
            const auto expected = disks.next(ever), found = spheres.next(ever);
            REQUIRE(expected.has_value() == found.has_value());
            if (!expected) break;
            REQUIRE(found->time == expected->time);
            REQUIRE(found->first == expected->first);
            REQUIRE(found->second == expected->second);
            ++compared;
        }
        for (std::int32_t i = 0; i < particles.count(); ++i) {
            REQUIRE(apart(spheres.velocity(i), disks.velocity(i)) == 0.0L);
            REQUIRE(spheres.place(i).z == 0.5L * depth);
        }
    }
    CHECK(compared > 2'000);
}

TEST_CASE("the events of spheres in a periodic box do not depend on how fast all of them fly") {
    int compared = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        CAPTURE(seed);
        Random random(seed, "boosted spheres");
        const Box box =
            test::space_of({4.0, 4.5, 5.0}, {Wall::periodic, Wall::periodic, Wall::periodic});
        std::vector<Sphere> spheres = test::scattered(box, random, 6, 0.3, 0.9);
        const auto [particles, start] = test::start_of(spheres);
        const Vec boost{1.5, -2.25, 0.75};
        for (Sphere& sphere : spheres) sphere.velocity += boost;
        const auto [again, boosted] = test::start_of(spheres);
        SlowSimulator one(box, particles, start), other(box, again, boosted);
        long double off = 1e-15L;  // grows by some bits with each collision
        while (off < 1e-9L) {
            const SlowEvent expected = *one.next(ever), found = *other.next(ever);
            REQUIRE(found.first == expected.first);
            REQUIRE(found.second == expected.second);
            const long double now = std::abs(found.time - expected.time);
            REQUIRE(now < 1e4L * off);
            off = std::max(off, now);
            ++compared;
        }
    }
    CHECK(compared > 300);
}
