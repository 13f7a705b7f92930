// A simulation that was written and read back goes on as the original does, bit for bit, whatever
// its gas and its run are and whenever it is written.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <exception>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "physics/simulation.h"
#include "support/checkpoint.h"
#include "support/equal_disks.h"
#include "support/share_of_cases.h"
#include "support/small_scenes.h"
#include "support/surface_scenes.h"
#include "util/random.h"

using namespace carom;
using test::a_gas, test::CheckpointCase, test::restored, test::start_of, test::written;
using test::Found, test::require_exact_checkpoint, test::require_same, test::Trace;

namespace {

// Among the events of a run, in order.
void insert(std::vector<RunEvent>& events, RunEvent event) {
    const auto later = [&](const RunEvent& one) { return one.at > event.at; };
    events.insert(std::ranges::find_if(events, later), std::move(event));
}

CheckpointCase any_case(std::uint64_t seed) {
    Random random(seed, "checkpoint");
    CheckpointCase its;
    const auto with_surfaces = [&](test::SurfaceScene scene) {
        its.gas = std::move(scene.gas);
        its.run.events = std::move(scene.events);
    };
    bool has_steps = false;
    switch (seed % 7) {
        case 0:
            its.gas = test::small_scene(seed);
            break;
        case 1:
            its.gas = test::small_line(seed);
            break;
        case 2:
            with_surfaces(test::small_wire(seed));
            break;
        case 3:
            its.gas = test::equal_disks(random.uniform(0.1, 0.7), 256);
            break;
        case 4:
            its.gas = test::small_scene(seed);
            has_steps = true;
            break;
        default:
            with_surfaces(test::small_box(seed));
            break;
    }
    its.run.equilibrate = random.uniform() < 0.3 ? 0.5 : 0.0;
    const int any_bits[] = {53, 53, 64, 256};
    its.run.bits = its.gas.species[0].count > 100 ? 53 : any_bits[random.below(4)];
    if (has_steps) {
        its.run.time_step = 0.01;
        its.run.bits = 53;
    }
    for (std::uint64_t k = random.below(3); k > 0; --k) {
        const double at = random.uniform(0.5, 4.0);
        insert(its.run.events, {at, ReverseVelocities{}});
        for (const double after : {0.2, 0.5, 0.5, 1.0}) its.returns.push_back(at + after);
        its.returns.push_back(at);
    }
    if (random.uniform() < 0.3)
        insert(its.run.events, {random.uniform(0.0, 4.0), Perturbation{0, {"1e-9", "0"}}});
    return its;
}

// Anywhere, at an event of the run, at a collision, or at the very start.
double checkpoint_time(const CheckpointCase& its, const Simulation& start, Random& random) {
    const double any = random.uniform(0.0, 4.0);
    if (random.uniform() < 0.3 && !its.run.events.empty())
        return its.run.events[random.below(its.run.events.size())].at;
    if (random.uniform() < 0.1) return 0.0;
    if (random.uniform() < 0.5) return any;
    Simulation probe = start;
    const auto collisions = probe.advance_to(any).collisions;
    return collisions.empty() ? any : collisions.back().time;
}

}  // namespace

TEST_CASE("a simulation that is read back goes on as the original, bit for bit") {
    Found all;
    int runs = 0;
    const int share = test::every_nth(1, 4);
    for (std::uint64_t seed = 1; seed <= 700 / static_cast<std::uint64_t>(share); ++seed) {
        CAPTURE(seed);
        const CheckpointCase its = any_case(seed);
        CAPTURE(*its.run.bits);
        std::optional<Simulation> start;
        try {
            start = start_of(its);
        } catch (const std::exception&) {
            continue;  // no room for the disks, or what no run can be
        }
        Random random(seed, "time of the checkpoint");
        double time = 0.0;
        try {
            time = checkpoint_time(its, *start, random);
        } catch (const std::exception&) {
            time = 0.0;  // the run ends before
        }
        CAPTURE(time);
        const Found found = require_exact_checkpoint(its, *start, time);
        all.collisions += found.collisions;
        all.returns += found.returns;
        all.thrown += found.thrown;
        ++runs;
    }
    CHECK(runs > 500 / share);
    CHECK(all.collisions > 50'000 / share);
    CHECK(all.returns > 200 / share);
    CHECK(all.thrown < 150 / share);
}

TEST_CASE("a checkpoint in the middle of a crowd of events is exact") {
    for (const bool at_once : {false, true}) {
        CheckpointCase its{test::equal_disks(0.5, 2500), {}};
        if (at_once)  // all collide with their neighbours at few times
            its.gas.species[0].velocity = Velocity{{{1.0, 0.0}}};
        its.gas.box.walls = {Wall::solid, Wall::solid};
        its.gas.species[0].position = LatticePlaces{};
        Simulation start = start_of(its);
        Simulation probe = start;
        const auto collisions = probe.advance_to(1.0).collisions;
        REQUIRE(collisions.size() > 100);
        for (const double share : {0.01, 0.5, 0.9}) {
            CAPTURE(share);
            const auto k = static_cast<std::size_t>(share * static_cast<double>(collisions.size()));
            require_exact_checkpoint(its, start, collisions[k].time);
        }
    }
}

TEST_CASE("a checkpoint of so many disks that memory is slow is exact") {
    CheckpointCase its{test::equal_disks(0.4, 36'100), {}};
    Simulation start(its.gas, its.run);
    start.record_collisions(true);
    Simulation probe = start;
    const auto times = {0.7, 3.1};  // the second after the disks were put into another order
    for (const double time : times) {
        probe.advance_to(time);
        const std::string bytes = written(probe);
        Simulation copy = restored(probe, its.run, bytes);
        REQUIRE(written(copy) == bytes);
        Trace one, other;
        Simulation original = probe;
        one.go_on(original, {time + 0.5, time + 0.6});
        other.go_on(copy, {time + 0.5, time + 0.6});
        require_same(one, other);
        CHECK(one.collisions > 20'000);
    }
}

TEST_CASE("disks are put into another order when the original does it") {
    const CheckpointCase its{test::equal_disks(0.4, 4'900), {}};
    Simulation original(its.gas, its.run);
    for (double time = 1.0; time < 8.0; time += 1.0) {
        CAPTURE(time);
        original.advance_to(time);
        Simulation copy = restored(original, its.run, written(original)), other = original;
        copy.advance_to(time + 4.0);
        other.advance_to(time + 4.0);
        REQUIRE(written(copy) == written(other));
    }
}

TEST_CASE("disks that lie on a floor are in a checkpoint") {
    CheckpointCase its;
    its.gas.box.size = {10.0, 10.0};
    its.gas.box.surfaces.gravity = {0.0, -1.0};
    its.gas.species = {
        {.name = "lying", .count = 2, .radius = 0.5, .position = Places{{{2.0, 0.5}, {6.0, 0.5}}}},
        {.name = "falling",
         .count = 1,
         .radius = 0.5,
         .velocity = Velocity{{{0.1, 0.0}}},
         .position = Places{{{1.8, 5.0}}}}};
    for (const double time : {0.0, 1.0, 3.5, 5.0}) {
        CAPTURE(time);
        require_exact_checkpoint(its, start_of(its), time);
    }
}

TEST_CASE("disks that a demon lets through are in a checkpoint") {
    CheckpointCase its = a_gas(70);  // so dense that disks collide while they are in the line
    its.gas.species[0].radius = 0.28;
    its.gas.box.surfaces.partitions = {
        {.name = "demon",
         .at = 4.0,
         .behaviour = Membrane{.upward = {.faster_than = 0.7}, .downward = {.faster_than = 1.2}}}};
    for (double time = 0.05; time < 4.0; time += 0.05) {
        CAPTURE(time);
        require_exact_checkpoint(its, start_of(its), time);
    }
}

TEST_CASE("a wall crushes the gas of a checkpoint when it crushes that of the original") {
    CheckpointCase its = a_gas(3);
    its.gas.box.dimension = 1;
    its.gas.box.surfaces.sides[0] = Driven{1.45};
    const Found found = require_exact_checkpoint(its, start_of(its), 1.0);
    CHECK(found.thrown == 1);
}

TEST_CASE("the events of a run that were replaced are in its checkpoint") {
    CheckpointCase its = a_gas(20);
    Simulation original = start_of(its);
    original.advance_to(1.0);
    original.replace_events({{2.0, ReverseVelocities{}}, {2.5, Perturbation{3, {"1e-6", "0"}}}});
    Simulation copy = restored(original, its.run, written(original));
    CHECK(copy.advance_to(3.0).reversals == 1);
    Trace one, other;
    original.advance_to(3.0);
    one.go_on(original, {4.0});
    other.go_on(copy, {4.0});
    require_same(one, other);
}
