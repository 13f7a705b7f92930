// The event loop of spheres against an independent program, against the slow, obvious simulator
// where contacts coincide, and against that of disks.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "physics/events/event_loop.h"
#include "physics/multiprecision/multiprecision.h"
#include "physics/placement/placement.h"
#include "support/relative.h"
#include "support/same_instants.h"
#include "support/slow_simulator.h"
#include "support/small_scenes.h"
#include "support/space.h"
#include "support/sphere_trajectories.h"
#include "support/tied_scenes.h"

using namespace carom;
using test::relative;

TEST_CASE("spheres that meet at once do what the slow, obvious simulator says") {
    test::InstantTally tally;
    for (std::uint64_t seed = 1; seed <= 600; ++seed) {
        CAPTURE(seed);
        const test::TiedScene scene = test::tied_scene(seed, 3);
        const auto compare = [&]<class Loop>(std::type_identity<Loop>) {
            test::InstantComparison<3, test::SlowSimulator, Loop>(
                scene.box, scene.particles, scene.start, {.bits = bits_of_double}, tally)
                .run(100.0, 20);
        };
        compare(std::type_identity<EventLoop<3>>());
        compare(std::type_identity<EventLoop<3, double, true>>());
    }
    CHECK(tally.instants > 1'200);
    CHECK(tally.contacts > 6'000);
    CHECK(tally.doubtful < 100);
}

TEST_CASE("spheres of many bits follow the trajectories of an independent program to the end") {
    for (const test::Trajectory& reference : test::sphere_trajectories()) {
        CAPTURE(reference.name);
        const auto [particles, start] = test::start_of(reference.start);
        EventLoop<3, Real> loop(reference.box, particles, {.bits = 2048});
        loop.start(start);
        Collision found{};
        std::int64_t number = 0;
        for (const test::Trajectory::Event& expected : reference.events) {
            CAPTURE(expected.number);
            for (; number < expected.number; ++number)
                REQUIRE(loop.advance_one(reference.end, found));
            const std::int32_t second =
                found.second.is_surface() ? -1 - found.second.surface() : found.second.particle();
            REQUIRE(std::min(found.first, second < 0 ? found.first : second) == expected.first);
            REQUIRE((second < 0 ? second : std::max(found.first, second)) == expected.second);
            REQUIRE(found.time == relative(expected.time, 0x1p-52));
        }
        REQUIRE(!loop.advance_one(reference.end, found));
        Sample end;
        loop.sample(reference.end, end);
        for (Eigen::Index i = 0; i < particles.count(); ++i) {
            const test::Sphere& expected = reference.there[static_cast<std::size_t>(i)];
            for (int axis = 0; axis < 3; ++axis) {
                CHECK(end.position(i, axis) == relative(expected.place[axis], 0x1p-52));
                CHECK(end.velocity(i, axis) == relative(expected.velocity[axis], 0x1p-52));
            }
        }
    }
}

TEST_CASE("spheres in one plane of space do what disks do") {
    int compared = 0;
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        CAPTURE(seed);
        const Gas gas = test::small_scene(seed);
        const auto [particles, start] = place(gas);
        const double depth = 4.0 * particles.radius.maxCoeff();
        const Box box = test::space_of(
            {gas.box.size[0], gas.box.size[1], depth},
            {gas.box.walls[0], gas.box.walls[1], seed % 2 == 0 ? Wall::solid : Wall::periodic});
        EventLoop<2> disks(gas.box, particles);
        EventLoop<3> spheres(box, particles);
        disks.start(start);
        spheres.start(test::in_space(start, depth));
        double off = 1e-15;
        while (off < 1e-9 && compared < 100 * static_cast<int>(seed)) {
            Collision expected{}, found{};
            const bool is = disks.advance_one(1e6, expected);
            REQUIRE(spheres.advance_one(1e6, found) == is);
            if (!is) break;
            const auto pair = [](const Collision& its) {
                return its.second.is_surface() ? std::pair{-1 - its.second.surface(), its.first}
                                               : std::minmax({its.first, its.second.particle()});
            };
            REQUIRE(pair(found) == pair(expected));
            REQUIRE(found.first_after[2] == 0.0);
            const double now = std::abs(found.time / expected.time - 1.0);
            REQUIRE(now < 1e4 * off);
            off = std::max(off, now);
            ++compared;
        }
    }
    CHECK(compared > 1'000);
}
