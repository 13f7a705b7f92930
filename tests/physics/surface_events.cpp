// What events change in boxes with surfaces, that a reversed run changes it back, and that many
// bits bring all of it home.
#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "physics/gas.h"
#include "physics/mechanics.h"
#include "physics/reversal/precision.h"
#include "physics/simulation.h"
#include "physics/surface.h"
#include "support/relative.h"

using namespace carom;
using test::relative;

namespace {

Partition divider_at(double x, Behaviour behaviour = Reflecting{}) {
    return {.name = "divider", .axis = 0, .at = x, .behaviour = behaviour};
}

const std::int32_t divider = Surfaces{}.first_partition();

// Disks in the left part of a box with a divider.
Gas gas_beside_divider(int count, Behaviour behaviour = Reflecting{}) {
    Gas gas;
    gas.box.size = {20.0, 10.0};
    gas.box.surfaces.partitions = {divider_at(10.0, behaviour)};
    gas.species = {{.name = "disks",
                    .count = count,
                    .radius = 0.3,
                    .velocity = Temperature{1.0},
                    .position = WithinRegion{{{0.0, 0.0}, {10.0, 10.0}}}}};
    return gas;
}

double most_right(Simulation& simulation) { return simulation.sample().position.col(0).maxCoeff(); }

// How far the present positions are from others.
double distance(Simulation& simulation, const Sample& other) {
    return (simulation.sample().position - other.position).abs().maxCoeff();
}

void check_account(const Simulation& simulation) {
    CHECK(simulation.energy_account().relative_error.value() < 1e-12);
}

}  // namespace

TEST_CASE("a gas expands freely, keeps its temperature, and comes back behind the divider") {
    Run run;
    run.bits = std::nullopt;
    run.until = 60.0;
    run.events = {{2.0, SetOpen{divider, true}}, {30.0, ReverseVelocities{}}};
    Simulation simulation = start_run(gas_beside_divider(24), run);
    const Sample start = simulation.sample();
    const double energy = kinetic_energies(simulation.particles(), start).sum();
    simulation.advance_to(2.0 - 1e-9);
    CHECK(most_right(simulation) < 10.0);
    const auto collisions = simulation.advance_to(29.0).counts.particle;
    CHECK(collisions > 100);
    CHECK(most_right(simulation) > 12.0);
    CHECK(simulation.surfaces()[divider].is_open);
    CHECK(kinetic_energies(simulation.particles(), simulation.sample()).sum() ==
          relative(energy, 1e-13));
    simulation.advance_to(58.0);
    CHECK_FALSE(simulation.surfaces()[divider].is_open);
    CHECK(most_right(simulation) < 10.0);
    simulation.advance_to(60.0);
    CHECK(distance(simulation, start) < 1e-9);
}

TEST_CASE("a divider does not close on a disk, and stays open after a reversal unless mirrored") {
    Gas gas = gas_beside_divider(1);
    gas.species[0].position = Places{{{9.0, 5.0}}};
    gas.species[0].velocity = Velocity{{{1.0, 0.0}}};
    Run run;
    run.events = {{0.5, SetOpen{divider, true}}, {1.1, SetOpen{divider, false}}};
    Simulation in_the_way(gas, run);
    CHECK_THROWS_WITH_AS(in_the_way.advance_to(2.0),
                         "the partition cannot close at time 1.1: particle 0 is in its way",
                         RunEventError);
    run.events = {{0.5, SetOpen{divider, true}, false}, {1.0, ReverseVelocities{}}};
    Simulation left_open(gas, run);
    left_open.advance_to(3.0);
    CHECK(left_open.surfaces()[divider].is_open);
}

TEST_CASE("a run reversed twice opens, closes and opens again") {
    Run run;
    run.events = {
        {1.0, SetOpen{divider, true}}, {1.5, ReverseVelocities{}}, {2.5, ReverseVelocities{}}};
    Simulation simulation(gas_beside_divider(6), run);
    const auto is_open = [&](double time) {
        simulation.advance_to(time);
        return simulation.surfaces()[divider].is_open;
    };
    CHECK(is_open(1.9));
    CHECK_FALSE(is_open(2.1));  // the mirror of 1.0
    CHECK_FALSE(is_open(2.9));
    CHECK(is_open(3.1));  // and its mirror
}

TEST_CASE("a wall that events move does its work, stops, and goes back the same way") {
    Gas gas = gas_beside_divider(10);
    gas.box.surfaces.partitions.clear();
    Run run;
    run.bits = 256;
    run.events = {
        {1.0, MoveSurface{1, -1.0}}, {9.0, MoveSurface{1, 0.0}}, {12.0, ReverseVelocities{}}};
    Simulation simulation(gas, run);
    const Sample start = simulation.sample();
    simulation.advance_to(10.0);
    CHECK(simulation.surfaces()[1].motion->place == relative(12.0, 1e-14));
    CHECK(simulation.surfaces()[1].hits > 0);
    CHECK(simulation.energy_account().work == relative(simulation.surfaces()[1].work, 1e-13));
    check_account(simulation);
    simulation.advance_to(24.0);
    CHECK(simulation.surfaces()[1].motion->place == relative(20.0, 1e-14));
    CHECK(distance(simulation, start) < 1e-12);
    check_account(simulation);
    CHECK(std::abs(simulation.energy_account().work) < 1e-12);
}

TEST_CASE("a piston that is held stands still, released it moves again; reversed it comes home") {
    Run run;
    run.bits = 512;
    run.events = {
        {8.0, HoldPiston{divider}}, {10.0, ReleasePiston{divider}}, {16.0, ReverseVelocities{}}};
    Simulation simulation(gas_beside_divider(8, Piston{.mass = 5.0}), run);
    const Sample start = simulation.sample();
    simulation.advance_to(8.0);
    const auto held = *simulation.surfaces()[divider].motion;
    CHECK(held.place > 10.2);
    CHECK(held.velocity == 0.0);
    simulation.advance_to(10.0);
    CHECK(simulation.surfaces()[divider].motion->place == held.place);
    check_account(simulation);
    simulation.advance_to(14.0);
    CHECK(simulation.surfaces()[divider].motion->place != held.place);
    check_account(simulation);
    simulation.advance_to(32.0);
    CHECK(simulation.surfaces()[divider].motion->place == relative(10.0, 1e-14));
    CHECK(distance(simulation, start) < 1e-12);
    check_account(simulation);
}

TEST_CASE("heat raises the energy by what it says, or to a temperature, and no kept momentum") {
    for (const auto& [across, up] : {std::pair{Wall::solid, Wall::solid},
                                     {Wall::periodic, Wall::solid},
                                     {Wall::periodic, Wall::periodic}})
        for (const bool is_divided : {false, true})
            for (const int bits : {bits_of_double, 128}) {
                Gas gas = gas_beside_divider(10);
                if (!is_divided) gas.box.surfaces = {};
                gas.box.walls = {across, up};
                gas.species.push_back({.name = "heavy",
                                       .count = 4,
                                       .radius = 0.2,
                                       .mass = ValueRule{3.0},
                                       .velocity = Velocity{{{1.0, 0.5}}}});
                Run run;
                run.bits = bits;
                run.events = {{1.0, Heat{{}, 7.0}},
                              {2.0, Heat{1, Temperature{3.0}}},
                              {2.5, Heat{{}, Temperature{2.0}}}};
                Simulation simulation(gas, run);
                const Particles& particles = simulation.particles();
                const auto energy = [&] {
                    return kinetic_energies(particles, simulation.sample()).sum();
                };
                const double before = energy();
                const Eigen::ArrayXd kept = momentum(particles, simulation.sample());
                simulation.advance_to(1.0);
                CHECK(energy() == relative(before + 7.0, 1e-13));
                CHECK(simulation.energy_account().heat == relative(7.0, 1e-12));
                // What the program shows as temperature, of the heated.
                simulation.advance_to(2.0);
                CHECK(thermal_motion(gas.box, particles, simulation.sample(), {10, 11, 12, 13})
                          .temperature() == relative(3.0, 1e-12));
                simulation.advance_to(2.5);
                CHECK(thermal_motion(gas.box, particles, simulation.sample()).temperature() ==
                      relative(2.0, 1e-12));
                const Eigen::ArrayXd after = momentum(particles, simulation.sample());
                for (int axis = 0; axis < 2; ++axis)
                    if (conserves_momentum(gas.box, particles, axis))
                        CHECK(std::abs(after[axis] - kept[axis]) < 1e-11);
                check_account(simulation);
            }
}

TEST_CASE("a single disk between walls is heated, one that goes round keeps its velocity") {
    Gas gas = gas_beside_divider(1);
    gas.box.surfaces = {};
    Run run;
    run.events = {{1.0, Heat{{}, Temperature{3.0}}}};
    Simulation simulation(gas, run);
    simulation.advance_to(1.0);
    CHECK(kinetic_energies(simulation.particles(), simulation.sample())[0] == relative(3.0, 1e-14));
    gas.box.walls = {Wall::periodic, Wall::periodic};
    gas.species[0].velocity = Velocity{{{1.0, 0.5}}};
    Simulation round(gas, run);
    CHECK_THROWS_AS(round.advance_to(2.0), RunEventError);
}

TEST_CASE("heat is taken back by a reversal, and cannot be taken where there is too little") {
    Run run;
    run.bits = 256;
    run.events = {{1.0, Heat{{}, 20.0}}, {3.0, ReverseVelocities{}}};
    Simulation simulation(gas_beside_divider(10), run);
    const Sample start = simulation.sample();
    simulation.advance_to(6.0);
    CHECK(distance(simulation, start) < 1e-12);
    CHECK(std::abs(simulation.energy_account().heat) < 1e-12);
    run.events = {{1.0, Heat{{}, -1000.0}}};
    Simulation cold(gas_beside_divider(10), run);
    CHECK_THROWS_AS(cold.advance_to(2.0), RunEventError);
}

TEST_CASE("many bits bring a gas home past obstacles, pistons, membranes, gaps and gravity") {
    Gas gas = gas_beside_divider(16);
    Surfaces& surfaces = gas.box.surfaces;
    surfaces.partitions[0].behaviour = Membrane{.species = {1}};
    surfaces.partitions.push_back({.name = "window", .axis = 0, .at = 15.0, .gaps = {{4.0, 6.0}}});
    surfaces.gravity = {0.1, -0.4};
    surfaces.sides[3] = Piston{.mass = 10.0, .force = -2.0};
    surfaces.sides[0] = Driven{.velocity = 0.05, .until = 9.0};
    surfaces.obstacles = {{"peg", Obstacle::Ball{{4.0, 7.0}, 0.8}},
                          {"wedge", Obstacle::Lines{{{6.0, 1.0}, {8.0, 1.5}, {7.0, 3.0}}, true}},
                          {"shelf", Obstacle::Lines{{{12.0, 3.0}, {14.0, 4.0}}, false}}};
    gas.species.push_back(
        {.name = "small", .count = 10, .radius = 0.15, .mass = 0.25, .velocity = Temperature{1.0}});
    Run run;
    run.bits = std::nullopt;
    run.until = 40.0;
    run.events = {{20.0, ReverseVelocities{}}};
    Simulation simulation = start_run(gas, run);
    CHECK(simulation.bits() > 53);
    const Sample start = simulation.sample();
    CHECK(simulation.advance_to(20.0).counts.particle > 60);
    check_account(simulation);
    simulation.advance_to(40.0);
    CHECK(distance(simulation, start) < 1e-9);
    check_account(simulation);
}

// p(h) of the length is proportional to h^N (E - F h)^((N-1)/2) (walls-and-gravity, beads): its
// mean is 2/3 E / F for any N.
TEST_CASE("a piston on beads of no length stands at two thirds of E / F on average") {
    constexpr int count = 6;
    constexpr double force = 2.0;
    Gas gas;
    gas.box.dimension = 1;
    gas.box.size = {10.0, 1.0};
    gas.box.surfaces.sides[1] = Piston{.mass = 3.7, .force = -force};
    gas.species = {{.name = "beads",
                    .count = count,
                    .radius = 0.0,
                    .mass = std::vector<double>{1.0, 2.3, 0.7, 1.9, 3.1, 1.3},
                    .velocity = Temperature{2.0}}};
    Run run;
    run.equilibrate = 100.0;
    Simulation simulation(gas, run);
    const EnergyAccount account = simulation.energy_account();
    const double in_all = account.in_all();
    std::vector<double> blocks;
    double time = 0.0;
    for (int block = 0; block < 40; ++block) {
        double sum = 0.0;
        constexpr int samples = 500;
        for (int k = 0; k < samples; ++k) {
            simulation.advance_to(time += 1.7);
            sum += simulation.surfaces()[1].motion->place;
        }
        blocks.push_back(sum / samples);
    }
    double mean = 0.0, squares = 0.0;
    for (const double x : blocks) mean += x / 40.0;
    for (const double x : blocks) squares += (x - mean) * (x - mean);
    const double error = std::sqrt(squares / 39.0 / 40.0);
    CAPTURE(mean);
    CHECK(std::abs(mean - in_all / force * 2.0 / 3.0) < 5.0 * error);
    CHECK(error < 0.02 * mean);
    check_account(simulation);
}

TEST_CASE("beads beside baths, under gravity and between driven ends do what disks do") {
    Gas gas;
    gas.box.dimension = 1;
    gas.box.size = {10.0, 1.0};
    gas.species = {{.name = "bead",
                    .count = 1,
                    .radius = 0.5,
                    .velocity = Velocity{{{0.0, 0.0}}},
                    .position = Places{{{4.5, 0.0}}}}};
    SUBCASE("a bead that falls bounces to its height") {
        gas.box.surfaces.gravity = {-2.0, 0.0};  // from 4 above the floor, in 2 each way
        Simulation simulation(gas, {});
        simulation.advance_to(4.0);
        CHECK(simulation.sample().position(0, 0) == relative(4.5, 1e-14));
        simulation.advance_to(2.0 + 4.0 * 250);
        CHECK(simulation.sample().position(0, 0) == relative(0.5, 1e-9));
        CHECK(simulation.surfaces()[0].hits == 251);
    }
    SUBCASE("a driven end reflects v to 2u - v") {
        gas.box.surfaces.sides[0] = Driven{.velocity = 1.0};
        Simulation simulation(gas, {});
        simulation.advance_to(4.1);
        CHECK(simulation.sample().velocity(0, 0) == 2.0);
        CHECK(simulation.energy_account().work == relative(2.0, 1e-14));
        check_account(simulation);
    }
    SUBCASE("a bead between baths leaves them with the energy of the flux, T for one direction") {
        gas.box.surfaces.sides = {Bath{2.0}, Bath{0.5}};
        gas.species[0].velocity = Velocity{{{1.0, 0.0}}};
        Simulation simulation(gas, {});
        simulation.record_collisions(true);
        double left = 0.0, count = 0.0;
        for (const Collision& hit : simulation.advance_to(40'000.0).collisions) {
            if (hit.second.surface() != 0) continue;
            left += 0.5 * square(hit.first_after);
            count += 1.0;
        }
        // Each energy is exponential with mean and deviation T = 2.
        CHECK(count > 1000.0);
        CHECK(std::abs(left / count - 2.0) < 5.0 * 2.0 / std::sqrt(count));
        CHECK(std::abs(simulation.surfaces()[0].heat + simulation.surfaces()[1].heat) < 10.0);
    }
}

TEST_CASE("beads come home in many bits between a piston and a driven end, under gravity") {
    Gas gas;
    gas.box.dimension = 1;
    gas.box.size = {20.0, 1.0};
    gas.box.surfaces.sides = {Driven{.velocity = 0.1, .until = 5.0},
                              Piston{.mass = 2.0, .force = -1.0}};
    gas.box.surfaces.gravity = {-0.3, 0.0};
    gas.species = {{.name = "beads",
                    .count = 9,
                    .radius = 0.2,
                    .mass = std::vector<double>{1, 2, 1, 3, 1, 2, 1, 3, 1},
                    .velocity = Temperature{1.0}}};
    Run run;
    run.bits = std::nullopt;
    run.until = 60.0;
    run.events = {{30.0, ReverseVelocities{}}};
    Simulation simulation = start_run(gas, run);
    const Sample start = simulation.sample();
    CHECK(simulation.advance_to(30.0).counts.particle > 100);
    simulation.advance_to(60.0);
    CHECK(distance(simulation, start) < 1e-9);
    CHECK(simulation.surfaces()[0].motion->place == doctest::Approx(0.0).epsilon(1e-12));
    check_account(simulation);
}

TEST_CASE("events that no box can have are refused") {
    const auto is_refused = [](const auto& action, Behaviour behaviour = Reflecting{}) {
        Run run;
        run.events = {{1.0, action}};
        CHECK_THROWS_AS(Simulation(gas_beside_divider(2, behaviour), run), std::invalid_argument);
    };
    is_refused(SetOpen{1, true});            // a side
    is_refused(SetOpen{divider + 1, true});  // there is none
    is_refused(MoveSurface{-1, 0.5});
    is_refused(MoveSurface{1, NAN});
    is_refused(HoldPiston{divider});
    is_refused(ReleasePiston{divider}, Driven{0.1});
    is_refused(ChangeSurface{1, Bath{-1.0}});
    Run run;
    run.events = {{0.5, ChangeSurface{divider, Piston{2.0}}}, {1.0, HoldPiston{divider}}};
    Simulation(gas_beside_divider(2), run).advance_to(2.0);
}

// A driven partition that has been opened stops where its motion ends, and stays open; what an
// event left out of the mirror has done to a surface stays when another is undone.
TEST_CASE("the end of a motion and what is undone change nothing else of a surface") {
    Gas gas;
    gas.box.size = {20.0, 10.0};
    gas.box.surfaces.partitions = {
        {.name = "p", .axis = 0, .at = 5.0, .behaviour = Driven{.velocity = 0.5, .until = 8.0}}};
    gas.species = {{.name = "points", .count = 1, .radius = 0.0, .velocity = Temperature{1.0}}};
    const std::int32_t p = Surfaces{}.first_partition();
    SUBCASE("the end of a motion") {
        Run run;
        run.events = {{4.0, SetOpen{p, true}}};
        Simulation simulation(gas, run);
        simulation.advance_to(12.0);
        CHECK(simulation.surfaces()[p].is_open);
        CHECK(simulation.surfaces()[p].motion->velocity == 0.0);
        CHECK(simulation.surfaces()[p].motion->place == doctest::Approx(9.0));
    }
    SUBCASE("what is undone") {
        Run run;
        run.events = {{2.0, MoveSurface{p, 0.25}},
                      {4.0, SetOpen{p, true}, false},
                      {6.0, ReverseVelocities{}}};
        Simulation simulation(gas, run);
        simulation.advance_to(10.5);
        CHECK(simulation.surfaces()[p].is_open);
        CHECK(simulation.surfaces()[p].motion->velocity == -0.5);
    }
}
