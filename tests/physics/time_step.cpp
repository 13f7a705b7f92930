// Disks that advance in time steps: what that gets right, and what it gets wrong.
#include "physics/events/time_step.h"

#include <doctest/doctest.h>

#include <cstdint>
#include <optional>

#include "physics/gas.h"
#include "physics/placement/overlap.h"
#include "physics/simulation.h"

namespace carom {
namespace {

Run stepped(double until, std::optional<double> step) {
    Run run;
    run.until = until;
    run.time_step = step;
    return run;
}

// Two disks of radius 1 on one line that approach at speed 1 each, with `gap` between them.
Simulation head_on(double gap, double step) {
    const Box box{.size = {100.0, 100.0}};
    const Particles particles{Eigen::Array2d::Constant(1.0), Eigen::Array2d::Constant(1.0),
                              Eigen::Array2i::Zero()};
    Sample start;
    start.position.resize(2, 2);
    start.position << 50.0, 50.0, 52.0 + gap, 50.0;
    start.velocity.resize(2, 2);
    start.velocity << 1.0, 0.0, -1.0, 0.0;
    return Simulation(box, particles, start, stepped(10.0, step));
}

Gas gas_of(int count, std::uint64_t seed) {
    Gas gas{{.size = {30.0, 30.0}}, {}, seed};
    gas.species.resize(1);
    gas.species[0].name = "disks";
    gas.species[0].count = count;
    gas.species[0].radius = 0.8;
    gas.species[0].velocity = Temperature{1.0};
    return gas;
}

}  // namespace

TEST_CASE("in time steps two disks collide at the end of the step in which they meet") {
    // They meet at 0.25, between the steps at 0.2 and 0.3, and are 0.1 deep at 0.3.
    Simulation run = head_on(0.5, 0.1);
    run.record_collisions(true);
    const AdvanceResult result = run.advance_to(0.35);
    REQUIRE(result.collisions.size() == 1);
    CHECK(result.collisions[0].time == doctest::Approx(0.3).epsilon(1e-12));
    CHECK(result.impulses.largest_overlap == doctest::Approx(0.05).epsilon(1e-12));
    CHECK(result.impulses.virial == doctest::Approx(2.0 * 1.9).epsilon(1e-12));
    CHECK(run.sample().velocity(0, 0) == -1.0);
    CHECK(run.sample().velocity(1, 0) == 1.0);
    CHECK(run.sample().position(0, 0) == doctest::Approx(50.3 - 0.05).epsilon(1e-12));
}

TEST_CASE("in time steps fast disks pass through one another") {
    // In a step of 3 they go from 0.5 apart to behind each other.
    Simulation run = head_on(0.5, 3.0);
    CHECK(run.advance_to(9.0).counts.particle == 0);
    CHECK(run.sample().position(0, 0) > run.sample().position(1, 0));
}

TEST_CASE("across a periodic side disks collide in time steps") {
    const Box box{.size = {20.0, 20.0}, .walls = {Wall::periodic, Wall::solid}};
    const Particles particles{Eigen::Array2d::Constant(1.0), Eigen::Array2d::Constant(1.0),
                              Eigen::Array2i::Zero()};
    Sample start;
    start.position.resize(2, 2);
    start.position << 1.5, 5.0, 18.5, 5.0;
    start.velocity.resize(2, 2);
    start.velocity << -1.0, 0.0, 1.0, 0.0;
    Simulation run(box, particles, start, stepped(10.0, 0.01));
    const AdvanceResult result = run.advance_to(2.0);
    CHECK(result.counts.particle == 1);
    CHECK(result.counts.wall == 0);
    CHECK(run.sample().velocity(0, 0) == 1.0);
}

TEST_CASE("energy is conserved in time steps, but disks overlap, the more the longer the step") {
    const Gas gas = gas_of(100, 3);
    const auto largest = [&](double step) {
        Simulation run(gas, stepped(20.0, step));
        const double before = run.energy_account().kinetic;
        const AdvanceResult result = run.advance_to(20.0);
        CHECK(result.counts.particle > 100);
        CHECK(run.energy_account().kinetic == doctest::Approx(before).epsilon(1e-12));
        return result.impulses.largest_overlap;
    };
    const double fine = largest(0.001), coarse = largest(0.2);
    CHECK(fine > 0.0);
    CHECK(coarse > 20.0 * fine);  // of a first order in the step, 200 times
    Simulation exact(gas, stepped(20.0, {}));
    CHECK(exact.advance_to(20.0).impulses.largest_overlap < 1e-12);
}

TEST_CASE("with ever shorter steps the motion comes near the exact one until chaos parts them") {
    const Gas gas = gas_of(30, 5);
    Simulation exact(gas, stepped(2.0, {}));
    exact.advance_to(2.0);
    double before = 1e9;
    for (const double step : {1e-2, 1e-3, 1e-4, 1e-5}) {
        Simulation run(gas, stepped(2.0, step));
        run.advance_to(2.0);
        const double off = (run.sample().position - exact.sample().position).abs().maxCoeff();
        CHECK(off < before);
        before = off;
    }
    CHECK(before < 1e-2);
}

TEST_CASE("a reversal does not bring a gas back in time steps") {
    const Gas gas = gas_of(100, 5);
    Run there_and_back = stepped(40.0, 0.02);
    there_and_back.events = {{.at = 20.0, .action = ReverseVelocities{}}};
    Simulation run(gas, there_and_back);
    run.measure_return({40.0});
    const AdvanceResult result = run.advance_to(40.0);
    CHECK(result.reversals == 1);
    REQUIRE(result.return_distance.has_value());
    CHECK(result.return_distance->largest > 1.0);
}

TEST_CASE("runs that cannot have a time step are refused") {
    const Box plane{.size = {10.0, 10.0}};
    CHECK(!time_step_problem(plane, stepped(1.0, 0.1)));
    CHECK(!time_step_problem(plane, stepped(1.0, {})));
    CHECK(time_step_problem(plane, stepped(1.0, 0.0)));
    CHECK(time_step_problem({.dimension = 1, .size = {10.0, 0.0}}, stepped(1.0, 0.1)));
    for (const std::optional<int> bits : {std::optional(128), std::optional<int>()}) {
        Run run = stepped(1.0, 0.1);
        run.bits = bits;
        CHECK(time_step_problem(plane, run));
    }
    Run heated = stepped(1.0, 0.1);
    heated.events = {{.at = 0.5, .action = Heat{}}};
    CHECK(time_step_problem(plane, heated));
    Box falling = plane;
    falling.surfaces.gravity = {0.0, -1.0};
    CHECK(time_step_problem(falling, stepped(1.0, 0.1)));
}

}  // namespace carom
