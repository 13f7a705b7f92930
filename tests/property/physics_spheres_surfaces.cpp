// Spheres in boxes whose surfaces act, among obstacles and under gravity, against the slow, obvious
// simulator, and the account of their energy.
#include <doctest/doctest.h>

#include <cstdint>

#include "physics/multiprecision/multiprecision.h"
#include "support/same_surface_events.h"
#include "support/space.h"
#include "support/surface_account.h"
#include "support/surface_scenes.h"
#include "util/random.h"

using namespace carom;

namespace {

// A sphere on a parabola that comes within a little of a body at its nearest to it: a ball, or an
// edge or a corner of a cuboid.
test::SurfaceScene grazing_scene(std::uint64_t seed) {
    Random random(seed, "grazing parabolas in space");
    test::SurfaceScene scene;
    Box& box = scene.gas.box;
    box = test::space_of({40.0, 40.0, 40.0});
    const double radius = random.uniform(0.05, 1.0);
    const Vec center{20.0, 20.0, 20.0};
    const auto direction = [&] {
        const Vec one{random.normal(), random.normal(), random.normal()};
        return one / length(one);
    };
    Vec away = direction();
    double distance = radius;
    if (const auto which = random.below(3); which == 0) {
        const double ball = random.uniform(0.1, 2.0);
        box.surfaces.obstacles = {{"ball", Obstacle::Ball{center, ball}}};
        distance += ball;
    } else {
        // The centre lies on an edge along z, or is a corner; the body extends away from it.
        if (which == 1) away = Vec{away[0], away[1]} / length(Vec{away[0], away[1]});
        Vec low = center, high = center;
        for (int axis = 0; axis < 3; ++axis)
            (away[axis] > 0.0 ? low : high)[axis] += away[axis] > 0.0 ? -2.0 : 2.0;
        if (which == 1) low[2] = 19.0, high[2] = 21.0;
        box.surfaces.obstacles = {{"block", Obstacle::Cuboid{low, high}}};
    }
    box.surfaces.gravity = random.uniform(0.0, 1.5) * direction();
    const double miss = test::any_miss(random);
    const Vec nearest = center + (distance + miss) * away;
    const Vec some = direction();
    const Vec velocity = random.uniform(1.0, 3.0) * (some - dot(some, away) * away);
    const double time = random.uniform(0.5, 3.0);
    scene.gas.species = {test::thrown_to(nearest, velocity, time, box.surfaces.gravity, radius)};
    return scene;
}

}  // namespace

TEST_CASE("spheres among surfaces do what the slow, obvious simulator says") {
    test::SurfaceTally tally;
    for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
        CAPTURE(seed);
        test::require_same_surface_events<3>(test::small_box(seed, 3), seed, tally, 60);
    }
    CHECK(tally.pairs > 3'000);
    CHECK(tally.hits > 35'000);
    CHECK(tally.events > 1'200);
    CHECK(tally.ended < 100);
    test::check_random_walls(tally);
    CHECK(tally.turns.size() == tally.sines.size());
}

TEST_CASE("spheres among surfaces in many bits do what the slow, obvious simulator says") {
    test::SurfaceTally tally;
    for (std::uint64_t seed = 5001; seed <= 5060; ++seed) {
        CAPTURE(seed);
        test::require_same_surface_events<3, Real>(test::small_box(seed, 3), seed, tally, 30,
                                                   {.bits = 128});
    }
    CHECK(tally.pairs > 100);
    CHECK(tally.hits > 600);
}

TEST_CASE("a parabola that grazes an edge, a corner or a ball touches it, or does not") {
    test::SurfaceTally tally;
    for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
        CAPTURE(seed);
        test::require_same_surface_events<3>(grazing_scene(seed), 0, tally, 10);
    }
    CHECK(tally.scenes > 1500);
    CHECK(tally.hits > 1000);
}

TEST_CASE("the energy of spheres among surfaces that act is accounted for") {
    int whole = 0;
    for (std::uint64_t seed = 1; seed <= 150; ++seed) {
        CAPTURE(seed);
        whole += test::check_account(test::small_box(seed, 3)) ? 1 : 0;
    }
    CHECK(whole > 80);
}
