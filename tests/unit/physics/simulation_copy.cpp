// A copy of a simulation goes on like the original, bit for bit, and neither changes the other.
#include <doctest/doctest.h>

#include <iterator>
#include <stdexcept>
#include <vector>

#include "physics/simulation.h"
#include "support/equal_disks.h"

using namespace carom;

namespace {

Gas beads(Wall wall) {
    Gas gas;
    gas.box = {.dimension = 1, .size = {30.0, 0.0}, .walls = {wall, wall}};
    gas.species = {{.name = "light", .count = 9, .radius = 0.1, .velocity = Temperature{1.0}},
                   {.name = "heavy",
                    .count = 4,
                    .radius = 0.3,
                    .mass = ValueRule{5.0},
                    .velocity = Temperature{1.0}}};
    return gas;
}

Gas mixture() {
    Gas gas;
    gas.box.size = {20.0, 15.0};
    gas.species = {{.name = "small", .count = 60, .radius = 0.2, .velocity = Temperature{1.0}},
                   {.name = "large", .count = 3, .radius = 1.5, .velocity = Temperature{1.0}}};
    return gas;
}

bool same(const Sample& a, const Sample& b) {
    return a.time == b.time && (a.position == b.position).all() && (a.velocity == b.velocity).all();
}

void check_same(Simulation& a, Simulation& b, double time) {
    const AdvanceResult one = a.advance_to(time), two = b.advance_to(time);
    CHECK(one.counts.particle > 0);
    CHECK(one.counts.particle == two.counts.particle);
    CHECK(one.counts.wall == two.counts.wall);
    CHECK(one.reversals == two.reversals);
    CHECK(one.impulses.virial == two.impulses.virial);
    CHECK(one.impulses.wall == two.impulses.wall);
    REQUIRE(one.collisions.size() == two.collisions.size());
    for (std::size_t k = 0; k < one.collisions.size(); ++k) {
        REQUIRE(one.collisions[k].time == two.collisions[k].time);
        REQUIRE(one.collisions[k].first == two.collisions[k].first);
        REQUIRE(one.collisions[k].second == two.collisions[k].second);
    }
    CHECK(same(a.sample(), b.sample()));
    CHECK(return_distance(a.exact_positions(), b.exact_positions()).largest == 0.0);
}

}  // namespace

TEST_CASE("a copy in the middle of a run goes on like the original, bit for bit") {
    const Gas gases[] = {test::equal_disks(0.3, 64), mixture(), beads(Wall::solid),
                         beads(Wall::periodic)};
    for (std::size_t g = 0; g < std::size(gases); ++g) {
        CAPTURE(g);
        for (const int bits : {53, 128}) {
            CAPTURE(bits);
            Run run{.until = 20.0, .equilibrate = 1.0, .events = {}};
            run.events = {{12.0, ReverseVelocities{}}};
            run.bits = bits;
            Simulation original(gases[g], run);
            original.record_collisions(true);
            original.advance_to(5.25);
            Simulation copy = original;
            check_same(original, copy, 10.0);
            copy = original;  // assigned over another state
            check_same(original, copy, 20.0);
        }
    }
}

TEST_CASE("a copy made before the original went on is not changed by it") {
    Run run{.until = 20.0, .events = {}};
    run.bits = 128;
    Simulation original(test::equal_disks(0.3, 64), run);
    Simulation copy = original;
    original.advance_to(20.0);
    copy.advance_to(20.0);
    CHECK(same(original.sample(), copy.sample()));
}

TEST_CASE("a copy of many disks, which are sorted again now and then, goes on alike") {
    const Run run{.until = 4.0, .events = {}};
    Simulation original(test::equal_disks(0.3, 4900), run);
    original.advance_to(2.0);
    Simulation copy = original;
    check_same(original, copy, 4.0);
}

TEST_CASE("a copy that is perturbed goes astray, the original does not") {
    for (const int bits : {53, 128}) {
        CAPTURE(bits);
        Run run{.until = 20.0, .events = {}};
        run.bits = bits;
        const Gas gas = test::equal_disks(0.3, 64);
        Simulation alone(gas, run), original(gas, run);
        alone.advance_to(20.0);
        original.advance_to(5.0);
        Simulation copy = original;
        copy.replace_events({{6.0, Perturbation{3, {"1e-6", "0"}}}});
        copy.advance_to(20.0);
        original.advance_to(20.0);
        CHECK(return_distance(alone.exact_positions(), original.exact_positions()).largest == 0.0);
        CHECK(return_distance(alone.exact_positions(), copy.exact_positions()).largest > 1e-6);
    }
}

TEST_CASE("events that replace those of a run lie ahead, in order of time") {
    Run run{.until = 20.0, .events = {}};
    run.events = {{2.0, ReverseVelocities{}}, {8.0, ReverseVelocities{}}};
    Simulation simulation(test::equal_disks(0.3, 16), run);
    simulation.advance_to(5.0);
    CHECK_THROWS_AS(simulation.replace_events({{4.0, ReverseVelocities{}}}), std::invalid_argument);
    CHECK_THROWS_AS(
        simulation.replace_events({{7.0, ReverseVelocities{}}, {6.0, ReverseVelocities{}}}),
        std::invalid_argument);
    simulation.replace_events({{5.0, ReverseVelocities{}}});
    CHECK(simulation.advance_to(20.0).reversals == 2);
}
