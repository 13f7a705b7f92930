#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

#include "physics/events/event_loop.h"
#include "physics/placement/placement.h"
#include "physics/simulation.h"
#include "support/hard_particles.h"
#include "support/relative.h"
#include "support/same_events.h"
#include "support/slow_simulator.h"
#include "support/small_scenes.h"
#include "util/random.h"

using namespace carom;
using test::relative;
using test::small_scene;

namespace {

double ulp(double x) { return std::nextafter(x, std::numeric_limits<double>::max()) - x; }

}  // namespace

TEST_CASE("the same events in the same order as the slow, obvious simulator") {
    int compared = 0;
    for (std::uint64_t seed = 1; seed <= 400; ++seed) {
        CAPTURE(seed);
        const Gas gas = small_scene(seed);
        const auto [particles, start] = place(gas);
        const auto events = static_cast<int>(6 * particles.count());
        compared += test::require_same_events<2, test::SlowSimulator>(gas.box, particles, start,
                                                                      1e6, events);
    }
    CHECK(compared > 5000);
}

TEST_CASE("no overlap after any event, energy and momentum are kept") {
    for (std::uint64_t seed = 1001; seed <= 1200; ++seed) {
        CAPTURE(seed);
        test::require_conserved<2>(small_scene(seed), 200);
    }
}

TEST_CASE("disks crowded in one cell are all found") {
    Gas gas;
    gas.box.size = {30.0, 30.0};
    gas.species = {{.name = "",
                    .count = 40,
                    .radius = 0.05,
                    .velocity = Temperature{1.0},
                    .position = WithinRegion{{{1.0, 1.0}, {2.0, 2.0}}}}};
    const auto [particles, start] = place(gas);
    EventLoop<2> fast(gas.box, particles);
    fast.start(start);
    test::SlowSimulator slow(gas.box, particles, start);
    for (int k = 0; k < 60; ++k) {
        CAPTURE(k);
        const auto expected = slow.next(1e3L);
        Collision found{};
        REQUIRE(fast.advance_one(1e3, found));
        REQUIRE(std::min(found.first,
                         found.second.is_surface() ? found.first : found.second.particle()) ==
                expected->first);
        REQUIRE(std::abs(found.time - static_cast<double>(expected->time)) < 1e-6);
    }
}

TEST_CASE("disks that hang over the sides of their wide cells are found in time") {
    // From five cells along the box, the fewest of which no image comes twice, to many.
    for (const int count : {20, 45, 300}) {
        for (const double packing : {0.05, 0.2, 0.4}) {
            for (const Wall side : {Wall::solid, Wall::periodic}) {
                CAPTURE(count);
                CAPTURE(packing);
                CAPTURE(static_cast<int>(side));
                const double length = std::sqrt(count * std::numbers::pi * 0.25 / packing);
                Gas gas;
                gas.box.size = {length, length};
                gas.box.walls = {side, Wall::periodic};
                gas.species = {{.name = "", .count = count, .velocity = Temperature{1.0}}};
                test::require_hard<2>(gas, 3'000, count < 100 ? 1 : 10);
            }
        }
    }
}

TEST_CASE("two that hang over outwards and turn back at once meet") {
    // As many disks as give five cells of 2 along the box: of two in neighbouring cells that hung
    // over freely the nearest image would not be the one they meet, here across the border.
    constexpr int count = 26;
    const Box box{2, {10.0, 10.0}, {Wall::periodic, Wall::periodic}};
    Particles particles{Eigen::ArrayXd::Constant(count, 0.1), Eigen::ArrayXd::Ones(count),
                        Eigen::ArrayXi::Zero(count)};
    Sample start{0.0, Eigen::ArrayXXd(count, 2), Eigen::ArrayXXd::Zero(count, 2)};
    particles.inverse_mass.segment(2, 2).setZero();  // the two they turn back at
    start.position.topRows(4) << 8.5, 5.0, 1.5, 5.0, 7.0, 5.0, 3.0, 5.0;
    start.velocity.topRows(2) << -1.0, 0.0, 1.0, 0.0;
    for (int k = 4; k < count; ++k)
        start.position.row(k) << 0.5 + 0.9 * (k % 11), k % 2 == 0 ? 1.0 : 9.0;
    EventLoop<2> disks(box, particles);
    disks.start(start);
    std::vector<Collision> collisions;
    disks.advance(4.5, &collisions);
    REQUIRE(collisions.size() == 3);
    CHECK(collisions[2].first + collisions[2].second.particle() == 1);
    CHECK(collisions[2].time == relative(4.0, 1e-14));  // 1.3 to the turn, then 2.7 inwards
}

TEST_CASE("one large disk among many small ones, and many sizes at once") {
    // In the wider box no image of a disk comes twice into question, in the other it does.
    for (const double width : {60.0, 150.0})
        for (const Wall side : {Wall::solid, Wall::periodic}) {
            CAPTURE(width);
            CAPTURE(static_cast<int>(side));
            Gas gas;
            gas.box.size = {width, width - 10.0};
            gas.box.walls = {side, side};
            gas.species = test::giants_and_dust(8.0, 3.0);
            test::require_hard<2>(gas, 30'000, 60);
        }
}

TEST_CASE("giants that meet each other") {
    Gas gas;
    gas.box.size = {60.0, 50.0};
    gas.box.walls = {Wall::periodic, Wall::periodic};
    gas.species = {{.name = "giant", .count = 12, .radius = 5.0, .velocity = Temperature{1.0}},
                   {.name = "dust",
                    .count = 300,
                    .radius = 0.2,
                    .mass = ValueRule{0.1},
                    .velocity = Temperature{1.0}}};
    test::require_hard<2>(gas, 20'000, 20);
}

TEST_CASE("a giant that nearly fills its periodic box is met at each of its images") {
    Gas gas;
    gas.box.size = {21.0, 20.0};
    gas.box.walls = {Wall::periodic, Wall::periodic};
    gas.species = test::one_among_fixed({1.0, 0.1});
    test::require_hard<2>(gas, 3'000, 1);
}

TEST_CASE("a giant ploughs through dust at rest, which looks for nothing itself") {
    // A disk found a cell too late has overlapped before it collides. Whether the rim just reaches
    // a cell depends on the radius: hence several.
    for (const double radius : {7.4, 7.55, 7.7, 7.85, 8.0}) {
        CAPTURE(radius);
        Gas gas;
        gas.box.size = {60.0, 50.0};
        gas.species = {{.name = "giant",
                        .count = 1,
                        .radius = radius,
                        .mass = Density{1000.0},
                        .velocity = Velocity{{{1.0, 0.6}}}},
                       {.name = "dust", .count = 4000, .radius = 0.2, .mass = Density{1.0}}};
        const auto [particles, start] = place(gas);
        EventLoop<2> disks(gas.box, particles);
        disks.start(start);
        std::vector<Collision> collisions;
        disks.advance(20.0, &collisions);
        CHECK(disks.counts().particle > 1000);
        for (const Collision& c : collisions) {
            if (c.second.is_surface()) continue;
            const double sigma = particles.radius[c.first] + particles.radius[c.second.particle()];
            const double distance = length(c.second_position - c.first_position);
            // Places in a box of 60, and times up to 20 at which dust that is crushed against a
            // wall may fly a thousand times as fast as the giant: an ulp of each.
            const double speeds = length(c.second_before - c.first_before);
            REQUIRE(std::abs(distance - sigma) < ulp(60.0) * 8.0 + ulp(20.0) * speeds);
        }
    }
}

TEST_CASE("so many disks that they are put in order in memory again and again") {
    Gas gas;
    gas.box.size = {120.0, 110.0};
    gas.box.walls = {Wall::periodic, Wall::solid};
    gas.species = {{.name = "", .count = 4200, .velocity = Temperature{1.0}}};
    test::require_hard<2>(gas, 160'000, 8'000);
}

TEST_CASE("dense from a lattice, at late and early times alike") {
    Gas gas;
    gas.box.size = {30.0, 26.0};
    gas.box.walls = {Wall::periodic, Wall::solid};
    gas.species = {
        {.name = "", .count = 700, .velocity = Temperature{1.0}, .position = LatticePlaces{}}};
    auto [particles, start] = place(gas);
    for (const double epoch : {0.0, 1e10}) {
        start.time = epoch;
        EventLoop<2> disks(gas.box, particles);
        disks.start(start);
        disks.advance(epoch + 5.0, nullptr);
        CHECK(disks.counts().particle > 20'000);
        Sample sample;
        Collision collision{};
        for (int k = 0; k < 50; ++k) {
            disks.advance_one(epoch + 100.0, collision);
            disks.sample(collision.time, sample);
            REQUIRE(test::deepest_overlap(gas.box, particles, sample) <=
                    test::overlap_bound(gas.box, sample));
        }
        CHECK(kinetic_energies(particles, sample).sum() ==
              relative(kinetic_energies(particles, start).sum(), 1e-13));
    }
}

TEST_CASE("particles keep their numbers when they are sorted in memory") {
    Gas gas;
    gas.box.size = {150.0, 150.0};
    gas.box.walls = {Wall::solid, Wall::periodic};
    gas.species = {{.name = "",
                    .count = 6000,
                    .radius = UniformDistribution{0.3, 0.9},
                    .mass = Density{1.0},
                    .velocity = Temperature{1.0}}};
    const auto [particles, start] = place(gas);
    Simulation simulation(gas.box, particles, start, Run{});
    simulation.record_collisions(true);
    CHECK(((simulation.sample().position - start.position).abs() < 1e-12).all());
    std::int64_t pairs = 0;
    for (double time = 5.0; pairs < 200'000; time += 5.0) {
        const AdvanceResult advanced = simulation.advance_to(time);
        pairs = advanced.counts.particle;
        for (const Collision& c : advanced.collisions) {
            if (c.second.is_surface()) continue;
            const double distance = length(c.second_position - c.first_position);
            REQUIRE(std::abs(distance - particles.radius[c.first] -
                             particles.radius[c.second.particle()]) < 1e-12);
        }
    }
    CHECK(test::deepest_overlap(gas.box, particles, simulation.sample()) <=
          test::overlap_bound(gas.box, simulation.sample()));
    CHECK(kinetic_energies(particles, simulation.sample()).sum() ==
          relative(kinetic_energies(particles, start).sum(), 1e-12));
}

TEST_CASE("a reversal returns everything to its start within what doubles can do") {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        CAPTURE(seed);
        Gas gas;
        gas.seed = seed;
        gas.box.size = {20.0, 20.0};  // packing 0.2
        gas.species = {{.name = "", .count = 100, .velocity = Speed{1.0}}};
        // Some two collisions per particle, which cost 2.5 bits each at this packing.
        test::check_return(gas, 5.0, 2.5);
    }
}

TEST_CASE("two runs of one scene are the same to the last bit") {
    Gas gas;
    gas.box.size = {40.0, 40.0};
    gas.box.walls = {Wall::periodic, Wall::solid};
    gas.species = {{.name = "a", .count = 300, .velocity = Temperature{1.0}},
                   {.name = "b", .count = 10, .radius = 2.0, .mass = ValueRule{16.0}}};
    std::uint64_t hash = 0;
    for (int i = 0; i < 2; ++i) {
        Simulation simulation(gas, Run{});
        simulation.advance_to(7.0);
        const std::int64_t collisions = simulation.advance_to(20.0).counts.particle;
        CHECK(collisions > 3000);
        const std::uint64_t now = test::hash_of(simulation.sample());
        if (i == 1) CHECK(now == hash);
        hash = now;
    }
}

TEST_CASE("the same bits with every compiler, processor and level of optimisation") {
    // The start is made of exact numbers, so that no library function has a part in it.
    constexpr int side = 72;  // above the number from which disks are sorted in memory
    constexpr int count = side * side;
    const Box box{2, {1.5 * side, 1.25 * side}, {Wall::periodic, Wall::solid}};
    Particles particles{Eigen::ArrayXd(count), Eigen::ArrayXd(count), Eigen::ArrayXi::Zero(count)};
    Sample start{0.0, Eigen::ArrayXXd(count, 2), Eigen::ArrayXXd(count, 2)};
    Random random(1, "hash");
    for (int i = 0; i < count; ++i) {
        particles.radius[i] = i % 3 == 0 ? 0.25 : 0.5;
        particles.inverse_mass[i] = i % 3 == 0 ? 2.0 : 1.0;
        start.position.row(i) << 0.75 + 1.5 * (i % side), 0.625 + 1.25 * (i / side);
        start.velocity.row(i) << random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0);
    }
    EventLoop<2> disks(box, particles);
    disks.start(start);
    disks.advance(60.0, nullptr);
    Sample end;
    disks.sample(60.0, end);
    CHECK(disks.counts().particle == 256'074);
    CHECK(test::hash_of(end) == 15148608229584821666ULL);
}

TEST_CASE("very slow disks among very fast ones, and mass ratios to 1e15") {
    Gas gas;
    gas.box.size = {20.0, 20.0};
    gas.species = {{.name = "fast", .count = 3, .velocity = Speed{1e6}},
                   {.name = "slow", .count = 20, .mass = ValueRule{1e15}, .velocity = Speed{1e-12}},
                   {.name = "light", .count = 5, .mass = ValueRule{1e-3}}};
    test::require_hard<2>(gas, 20'000, 10);
}
