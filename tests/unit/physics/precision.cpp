// The event loop with numbers of many bits: its queue, and that the screen of doubles decides
// nothing.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "physics/events/event_loop.h"
#include "physics/multiprecision/mp_event_queue.h"
#include "physics/multiprecision/multiprecision.h"
#include "physics/placement/placement.h"
#include "support/equal_disks.h"
#include "support/small_scenes.h"
#include "util/random.h"

using namespace carom;

namespace {

struct Course {
    std::vector<Collision> collisions;
    std::vector<Real> places;
};

template <int Dimension, bool has_surfaces = false>
Course course(const Gas& gas, double end, const Arithmetic& arithmetic) {
    const auto [particles, start] = place(gas);
    EventLoop<Dimension, Real, has_surfaces> loop(gas.box, particles, arithmetic);
    loop.start(start);
    Course all;
    loop.advance(end / 2, &all.collisions);
    loop.reverse(end / 2);
    loop.advance(end, &all.collisions);
    all.places = loop.positions(end);
    return all;
}

// A small scene with gravity, a piston and obstacles, as far as there are walls and there is room.
Gas open_scene(std::uint64_t seed) {
    Gas gas = test::small_scene(seed);
    Surfaces& surfaces = gas.box.surfaces;
    if (!gas.box.is_periodic(1)) {
        if (seed % 2 == 0) surfaces.gravity = {seed % 3 == 0 ? 0.1 : 0.0, -0.3};
        surfaces.sides[3] = Piston{.mass = 20.0, .force = -3.0};
    }
    surfaces.obstacles.push_back({"peg", Obstacle::Ball{0.5 * gas.box.size, 0.02}});
    surfaces.obstacles.push_back(
        {"shelf", Obstacle::Lines{{0.2 * gas.box.size, 0.3 * gas.box.size}, false}});
    return gas;
}

bool same(const Collision& a, const Collision& b) {
    return a.time == b.time && a.first == b.first && a.second == b.second &&
           a.first_after == b.first_after && a.second_after == b.second_after;
}

}  // namespace

TEST_CASE("times that are one double are ordered by all their bits, equal ones by number") {
    MpEventQueue queue(4);
    const Real one(1.0, 256);
    const Real none(never<double>, 256);
    const Real later = one + Real::from_text("1e-60", 256);
    const Real earlier = one - Real::from_text("1e-60", 256);
    queue.reset({later, one, one, none});
    CHECK(queue.earliest() == 1);
    queue.schedule(3, earlier);
    CHECK(queue.earliest() == 3);
    queue.schedule(3, later);
    queue.schedule(1, none);
    CHECK(queue.earliest() == 2);
    queue.schedule(2, none);
    CHECK(queue.earliest() == 0);
    queue.schedule(0, none);
    CHECK(queue.earliest() == 3);
    queue.schedule(3, none);
    CHECK(queue.earliest() == -1);
}

TEST_CASE("many events come out of the queue in order of time") {
    Random random(1, "queue");
    constexpr int count = 50;
    MpEventQueue queue(count);
    std::vector<Real> times(count, Real(0.0, 128));
    const auto draw = [&](double from) {
        return Real(from, 128) + Real(static_cast<double>(random.below(8)), 128) * 0x1p-70 +
               static_cast<double>(random.below(3));
    };
    for (Real& time : times) time = draw(0.0);
    queue.reset(times);
    for (int step = 0; step < 5000; ++step) {
        const std::int32_t first = queue.earliest();
        for (int i = 0; i < count; ++i) {
            const auto order = queue.time(first) <=> queue.time(i);
            REQUIRE((order < 0 || (order == 0 && first <= i)));
        }
        queue.schedule(first, queue.time(first) + draw(0.0));
    }
}

TEST_CASE("with and without the screen of doubles: the same events, bit for bit") {
    std::size_t compared = 0;
    for (std::uint64_t seed = 1; seed <= 120; ++seed) {
        CAPTURE(seed);
        const Gas gas = test::small_scene(seed);
        if (test::may_crush(gas)) continue;
        const int bits = 64 << (seed % 4);
        const Course screened = course<2>(gas, 12.0, {bits, true});
        const Course unscreened = course<2>(gas, 12.0, {bits, false});
        REQUIRE(screened.collisions.size() == unscreened.collisions.size());
        for (std::size_t k = 0; k < screened.collisions.size(); ++k)
            REQUIRE(same(screened.collisions[k], unscreened.collisions[k]));
        REQUIRE(screened.places == unscreened.places);
        compared += screened.collisions.size();
    }
    CHECK(compared > 4000);
    for (const double packing : {0.1, 0.4, 0.65}) {
        const Gas gas = test::equal_disks(packing, 100);
        const Course screened = course<2>(gas, 4.0, {160, true});
        CHECK(screened.collisions.size() > 70);
        CHECK(screened.places == course<2>(gas, 4.0, {160, false}).places);
    }
}

TEST_CASE("with and without the screen of doubles: the same hits of surfaces") {
    std::size_t compared = 0, scenes = 0;
    for (std::uint64_t seed = 1; seed <= 120; ++seed) {
        CAPTURE(seed);
        const Gas gas = open_scene(seed);
        if (test::may_crush(gas)) continue;
        const int bits = 64 << (seed % 4);
        Course screened;
        try {
            screened = course<2, true>(gas, 6.0, {bits, true});
        } catch (const std::runtime_error&) {
            continue;  // no room
        }
        const Course unscreened = course<2, true>(gas, 6.0, {bits, false});
        REQUIRE(screened.collisions.size() == unscreened.collisions.size());
        for (std::size_t k = 0; k < screened.collisions.size(); ++k)
            REQUIRE(same(screened.collisions[k], unscreened.collisions[k]));
        REQUIRE(screened.places == unscreened.places);
        compared += screened.collisions.size();
        ++scenes;
    }
    CHECK(compared > 2000);
    CHECK(scenes > 60);
}

TEST_CASE("a piston that a reversal brings back to its start stands still there") {
    for (const std::uint64_t seed : {6U, 34U, 54U, 110U}) {
        CAPTURE(seed);
        const Gas gas = open_scene(seed);
        REQUIRE_FALSE((test::may_crush(gas) || gas.box.is_periodic(1)));
        const auto [particles, start] = place(gas);
        EventLoop<2, Real, true> loop(gas.box, particles, {.bits = 256});
        loop.start(start);
        loop.advance(3.0, nullptr);
        loop.reverse(3.0);
        loop.advance(6.0, nullptr);
        const auto piston = loop.surfaces(6.0)[3].motion.value();
        CHECK(piston.place == doctest::Approx(gas.box.size[1]));
        CHECK(std::abs(piston.velocity) < 1e-9);
    }
}

TEST_CASE("a late start costs the screen its sharpness, not its right") {
    auto [particles, start] = place(test::equal_disks(0.3, 64));
    Box box = test::equal_disks(0.3, 64).box;
    start.time = 1e12;  // a unit in the last place of a double is a tenth of a diameter
    std::vector<Real> places[2];
    for (const bool screened : {false, true}) {
        EventLoop<2, Real> loop(box, particles, {192, screened});
        loop.start(start);
        loop.advance(1e12 + 2.0, nullptr);
        CHECK(loop.counts().particle > 50);
        places[screened ? 1 : 0] = loop.positions(1e12 + 2.0);
    }
    CHECK(places[0] == places[1]);
    box.walls[1] = Wall::solid;
    box.surfaces.sides[3] = Piston{.mass = 50.0};
    for (const bool screened : {false, true}) {
        EventLoop<2, Real, true> loop(box, particles, {192, screened});
        loop.start(start);
        loop.advance(1e12 + 2.0, nullptr);
        places[screened ? 1 : 0] = loop.positions(1e12 + 2.0);
    }
    CHECK(places[0] == places[1]);
}
