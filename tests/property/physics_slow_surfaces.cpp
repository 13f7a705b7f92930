// Boxes whose surfaces act, obstacles, gravity and what events change, against the slow, obvious
// simulator, event by event.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>

#include "physics/multiprecision/multiprecision.h"
#include "support/goodness_of_fit.h"
#include "support/same_surface_events.h"
#include "support/surface_scenes.h"
#include "util/random.h"

using namespace carom;
using test::SurfaceTally;

namespace {

// A disk on a parabola that comes within a little of a body at its nearest to it.
test::SurfaceScene grazing_scene(std::uint64_t seed) {
    Random random(seed, "grazing parabolas");
    test::SurfaceScene scene;
    Box& box = scene.gas.box;
    box.size = {40.0, 40.0};
    const double turn = random.uniform(0.0, 6.3), radius = random.uniform(0.05, 1.0);
    const Vec center{20.0, 20.0}, away{std::cos(turn), std::sin(turn)};
    double distance = radius;
    if (random.uniform() < 0.5) {
        box.surfaces.obstacles = {{"end", Obstacle::Lines{{center, center - away}, false}}};
    } else {
        const double peg = random.uniform(0.1, 2.0);
        box.surfaces.obstacles = {{"peg", Obstacle::Ball{center, peg}}};
        distance += peg;
    }
    box.surfaces.gravity = {random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)};
    const double miss = test::any_miss(random);
    const Vec nearest = center + (distance + miss) * away;
    const Vec velocity = random.uniform(1.0, 3.0) * Vec{-away[1], away[0]};
    const double time = random.uniform(0.5, 3.0);
    scene.gas.species = {test::thrown_to(nearest, velocity, time, box.surfaces.gravity, radius)};
    return scene;
}

}  // namespace

TEST_CASE("disks among surfaces do what the slow, obvious simulator says") {
    SurfaceTally tally;
    for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
        CAPTURE(seed);
        test::require_same_surface_events<2>(test::small_box(seed), seed, tally, 60);
    }
    CHECK(tally.pairs > 15'000);
    CHECK(tally.hits > 80'000);
    CHECK(tally.events > 4'000);
    CHECK(tally.refused > 25);
    CHECK(tally.ended < 300);
    test::check_random_walls(tally);
}

TEST_CASE("beads between ends that act do what the slow, obvious simulator says") {
    SurfaceTally tally;
    for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
        CAPTURE(seed);
        test::require_same_surface_events<1>(test::small_wire(seed), seed, tally, 60);
    }
    CHECK(tally.pairs > 20'000);
    CHECK(tally.hits > 10'000);
    CHECK(tally.events > 2'000);
    CHECK(test::chance(tally.flux, [](double v) { return 1.0 - std::exp(-0.5 * v * v); }) > 1e-6);
}

TEST_CASE("in many bits they do what the slow, obvious simulator says") {
    SurfaceTally tally;
    for (std::uint64_t seed = 5001; seed <= 5150; ++seed) {
        CAPTURE(seed);
        test::require_same_surface_events<2, Real>(test::small_box(seed), seed, tally, 30,
                                                   {.bits = 128});
        test::require_same_surface_events<1, Real>(test::small_wire(seed), seed, tally, 30,
                                                   {.bits = 128});
    }
    CHECK(tally.pairs > 1'000);
    CHECK(tally.hits > 2'000);
}

TEST_CASE("a parabola that grazes a body touches it, or does not") {
    SurfaceTally tally;
    for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
        CAPTURE(seed);
        test::require_same_surface_events<2>(grazing_scene(seed), 0, tally, 10);
    }
    CHECK(tally.scenes > 1500);
    CHECK(tally.hits > 1000);
}
