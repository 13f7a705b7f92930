// Which velocities an advance has changed, against a comparison of all of them.
#include "physics/collision/velocity_changes.h"

#include <doctest/doctest.h>

#include <array>
#include <map>
#include <utility>

#include "physics/simulation.h"
#include "support/equal_disks.h"
#include "util/random.h"

using namespace carom;

namespace {

using Change = std::pair<Vec, Vec>;

std::map<std::int32_t, Change> changes_in(const VelocityLog& log) {
    std::map<std::int32_t, Change> all;
    const auto changes = log.changes();
    REQUIRE(changes);
    for (const VelocityChange& its : *changes) {
        CHECK_FALSE(all.contains(its.particle));
        all[its.particle] = {its.before, its.after};
    }
    return all;
}

Vec velocity_in(const Sample& sample, Eigen::Index i) {
    return {sample.velocity(i, 0), sample.velocity.cols() > 1 ? sample.velocity(i, 1) : 0.0};
}

// Advances, and says how many have changed, or none if it is not known.
std::optional<std::size_t> changed_in_advance(Simulation& simulation, double to) {
    const Sample before = simulation.sample();
    const AdvanceResult advanced = simulation.advance_to(to);
    if (!advanced.velocities) return std::nullopt;
    Sample expected = before;
    for (const VelocityChange& its : *advanced.velocities) {
        CHECK(velocity_in(before, its.particle) == its.before);
        for (Eigen::Index axis = 0; axis < before.velocity.cols(); ++axis)
            expected.velocity(its.particle, axis) = its.after[axis];
    }
    CHECK((expected.velocity == simulation.sample().velocity).all());
    return advanced.velocities->size();
}

}  // namespace

TEST_CASE("a log of velocities has the first and the last of each particle, again and again") {
    Random random(1, "changes");
    VelocityLog log;
    CHECK_FALSE(log.changes());
    for (const int count : {10'000, 30, 5'000, 0, 800}) {
        log.open(100'000);
        std::map<std::int32_t, Change> expected;
        for (int k = 0; k < count; ++k) {
            const auto particle = static_cast<std::int32_t>(random.uniform(0.0, 4'000.0)) * 1'024;
            const Vec after{random.uniform(), random.uniform()};
            const auto [its, is_new] = expected.try_emplace(particle);
            if (is_new) its->second.first = {random.uniform(), 0.0};
            log.note(particle, is_new ? its->second.first : its->second.second, after);
            its->second.second = after;
        }
        CHECK(changes_in(log) == expected);
    }
}

TEST_CASE("a log of velocities gives up where they are too many, until it is opened again") {
    VelocityLog log;
    log.open(2);
    for (const std::int32_t particle : {5, 7, 5, 7}) log.note(particle, {}, {1.0, 2.0});
    CHECK(log.changes()->size() == 2);
    log.note(8, {}, {});
    CHECK_FALSE(log.changes());
    log.open(2);
    CHECK(log.changes()->empty());
    log.give_up();
    CHECK_FALSE(log.changes());
}

TEST_CASE("the velocities that have changed are those that differ") {
    Gas gas = test::equal_disks(0.3, 2'000);
    for (const Wall wall : {Wall::periodic, Wall::solid}) {
        gas.box.walls = {wall, wall};
        Run run;
        run.equilibrate = 0.5;
        Simulation simulation(gas, run);
        CHECK_FALSE(simulation.advance_to(0.1).velocities);
        simulation.follow_velocities(true);
        const auto few = changed_in_advance(simulation, 0.12),
                   later = changed_in_advance(simulation, 0.15);
        REQUIRE(few);
        REQUIRE(later);
        CHECK(*few > 20);
        CHECK(*later > 20);
        CHECK(changed_in_advance(simulation, 0.15) == 0);
        CHECK_FALSE(changed_in_advance(simulation, 5.0));  // nearly all
        CHECK(changed_in_advance(simulation, 5.01));
    }
}

TEST_CASE("velocities are followed on a line, and not across a reversal") {
    Gas gas{.box = {.dimension = 1, .size = {200.0, 0.0}, .walls = {Wall::solid, Wall::solid}},
            .species = {{.name = "", .count = 100, .radius = 0.2, .velocity = Speed{1.0}}}};
    Run run;
    run.events = {{0.2, ReverseVelocities{}}};
    Simulation simulation(gas, run);
    simulation.follow_velocities(true);
    CHECK(changed_in_advance(simulation, 0.1));
    CHECK_FALSE(changed_in_advance(simulation, 0.3));
    CHECK(changed_in_advance(simulation, 0.4));
}

TEST_CASE("samples of velocities are those of the simulation, however few have changed") {
    Run run;
    run.equilibrate = 0.5;
    run.events = {{2.0, ReverseVelocities{}}};
    Simulation simulation(test::equal_disks(0.3, 2'000), run);
    VelocitySamples velocities;
    int followed = 0;
    double time = 0.0;
    for (int k = 0; k < 60; ++k) {
        time += k % 20 == 10 ? 1.0 : 0.01;  // after which nearly all have changed
        const AdvanceResult advanced = simulation.advance_to(time);
        followed += advanced.velocities.has_value();
        if (k % 7 == 3) {
            velocities.skip();
            continue;
        }
        const Sample sample = velocities.after(simulation, time, advanced);
        CHECK(sample.time == time);
        CHECK(sample.position.size() == 0);
        CHECK((sample.velocity == simulation.sample().velocity).all());
    }
    CHECK(followed > 5);
    CHECK(followed < 50);
}
