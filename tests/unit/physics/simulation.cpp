#include "physics/simulation.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "support/bodies.h"
#include "support/equal_disks.h"
#include "support/relative.h"

using namespace carom;
using test::Disk;
using test::relative;
using test::simulation_of;

namespace {

Box box_of(double width, double height, Wall x = Wall::solid, Wall y = Wall::solid) {
    return Box{2, {width, height}, {x, y}};
}

}  // namespace

TEST_CASE("collisions are told exactly, those at the end included") {
    Simulation simulation = simulation_of(box_of(10.0, 10.0), {{2, 5, 1, 0}, {5, 5, 0, 0}});
    simulation.record_collisions(true);
    CHECK(simulation.advance_to(1.75).collisions.empty());
    AdvanceResult advanced = simulation.advance_to(2.0);
    REQUIRE(advanced.collisions.size() == 1);
    const Collision pair = advanced.collisions[0];
    CHECK(pair.time == 2.0);
    CHECK(pair.first == 0);
    CHECK(pair.second == 1);
    CHECK(pair.first_position[0] == 4.0);
    CHECK(pair.second_position[0] == 5.0);
    CHECK(simulation.sample().velocity(0, 0) == 0.0);
    CHECK(simulation.sample().velocity(1, 0) == 1.0);
    CHECK(pair.first_before[0] == 1.0);
    CHECK(pair.second_before[0] == 0.0);
    CHECK(pair.first_after[0] == 0.0);
    CHECK(pair.second_after[0] == 1.0);
    advanced = simulation.advance_to(7.0);
    REQUIRE(advanced.collisions.size() == 1);
    CHECK(advanced.collisions[0].time == 6.5);
    CHECK(advanced.collisions[0].second == Side::right);
    CHECK(advanced.collisions[0].second_position[0] == 10.0);
    CHECK(advanced.collisions[0].first_before[0] == 1.0);
    CHECK(advanced.collisions[0].first_after[0] == -1.0);
    CHECK(advanced.collisions[0].second_before[0] == 0.0);
    CHECK(advanced.counts.particle == 1);
    CHECK(advanced.counts.wall == 1);
    CHECK(simulation.sample().position(1, 0) == 9.0);
    simulation.record_collisions(false);
    CHECK(simulation.advance_to(20.0).collisions.empty());
}

TEST_CASE("a gas at rest, and an empty one, stay so for ever") {
    Simulation at_rest = simulation_of(box_of(10.0, 10.0), {{2, 5, 0, 0}, {3, 5, 0, 0}});
    CHECK(at_rest.advance_to(1e300).counts.particle == 0);
    CHECK(at_rest.sample().position(1, 0) == 3.0);
    Simulation empty = simulation_of(box_of(10.0, 10.0), {});
    CHECK(empty.advance_to(5.0).counts.wall == 0);
    CHECK(empty.sample().position.rows() == 0);
}

TEST_CASE("the account has no error where an infinite mass moves, and one where it stands") {
    const auto has_error = [](const Box& box, double velocity) {
        Simulation simulation =
            simulation_of(box, {{5, 5, 0, velocity, 1.0, 0.0}, {2, 5, 1, 0.3}, {8, 5, -1, 0.2}});
        simulation.advance_to(20.0);
        return simulation.energy_account().relative_error.has_value();
    };
    Box box = box_of(10.0, 10.0);
    box.surfaces.sides[1] = Piston{.mass = 30.0, .force = -3.0};
    CHECK(has_error(box, 0.0));
    CHECK_FALSE(has_error(box, 1.0));
    box.surfaces.gravity = {0.0, -1.0};
    CHECK_FALSE(has_error(box, 0.0));
    // A wall that moves sets it in motion.
    box.surfaces.gravity = {0.0, 0.0};
    box.surfaces.sides[3] = Driven{.velocity = -0.5, .until = 12.0};
    CHECK_FALSE(has_error(box, 0.0));
}

TEST_CASE("looking at the state changes nothing") {
    const std::vector<Disk> disks{{2, 5, 1, 0.3}, {5, 5.3, -0.2, 0.4}, {7, 2, 0.9, 0.7, 1.0, 3.0}};
    Simulation often = simulation_of(box_of(10.0, 10.0), disks);
    Simulation once = simulation_of(box_of(10.0, 10.0), disks);
    for (int i = 1; i <= 1000; ++i) {
        often.advance_to(i * 0.1);
        often.sample();
    }
    once.advance_to(1000 * 0.1);
    CHECK((often.sample().position == once.sample().position).all());
    CHECK((often.sample().velocity == once.sample().velocity).all());
}

TEST_CASE("time before t = 0 is not counted") {
    Simulation simulation = simulation_of(box_of(10.0, 10.0), {{2, 5, 1, 0}, {5, 5, 0, 0}},
                                          {.until = 0.0, .equilibrate = 5.0, .events = {}});
    CHECK(simulation.sample().position(1, 0) == 8.0);
    CHECK(simulation.sample().time == 0.0);
    const AdvanceResult advanced = simulation.advance_to(1.5);
    CHECK(advanced.counts.particle == 0);
    CHECK(advanced.counts.wall == 1);
}

TEST_CASE("a reversal at its time, also when several lie in one advance") {
    const Run run{.until = 20.0,
                  .equilibrate = 0.0,
                  .events = {{3.0, ReverseVelocities{}},
                             {4.0, ReverseVelocities{}},
                             {4.0, ReverseVelocities{}},
                             {5.0, ReverseVelocities{}}}};
    Simulation simulation = simulation_of(box_of(10.0, 10.0), {{2, 5, 1, 0}, {5, 5, 0, 0}}, run);
    CHECK(simulation.advance_to(2.5).reversals == 0);
    CHECK(simulation.advance_to(3.0).reversals == 1);
    CHECK(simulation.sample().velocity(1, 0) == -1.0);
    // back to the collision at 4, processed at the instant of the second and third reversal
    CHECK(simulation.advance_to(3.999).counts.particle == 1);
    const AdvanceResult advanced = simulation.advance_to(4.0);
    CHECK(advanced.reversals == 3);
    CHECK(advanced.counts.particle >= 2);
    CHECK(simulation.advance_to(6.0).reversals == 4);
}

TEST_CASE("a simulation can be moved") {
    Simulation a = simulation_of(box_of(10.0, 10.0), {{2, 5, 1, 0}, {5, 5, 0, 0}});
    a.advance_to(1.0);
    Simulation b = std::move(a);
    CHECK(b.advance_to(2.5).counts.particle == 1);
    CHECK(b.particles().count() == 2);
    CHECK(b.box().size[0] == 10.0);
}

TEST_CASE("two disks around a periodic box meet on both sides") {
    // Two nearly fill it, and each meets two images of the other.
    Simulation pair =
        simulation_of(box_of(2.5, 4.0, Wall::periodic), {{0.5, 2, 0, 0}, {1.5, 2, 1, 0}});
    const AdvanceResult advanced = pair.advance_to(0.5 + 0.5 + 0.25);
    CHECK(advanced.counts.particle == 2);  // at 0.5 across the border, at 1.0 inside
}

TEST_CASE(
    "disks that fill the box and push each other round without end are an error, not a hang") {
    Simulation jammed = simulation_of(box_of(3.0, 4.0, Wall::periodic),
                                      {{0.5, 2, 0, 0}, {1.5, 2, 0, 0}, {2.5, 2, 0.5, 0}});
    CHECK_THROWS_WITH_AS(jammed.advance_to(1.0),
                         "disks collide without end at t = 0: they fill the box along a line, or "
                         "are squeezed between infinite or far heavier masses",
                         std::runtime_error);
}

TEST_CASE("a disk that falls between two images of another hits both") {
    // Half of the box apart along x, to the last bit: which image is nearest does not tell.
    Simulation simulation =
        simulation_of(box_of(1.75, 10.0, Wall::periodic), {{0.4375, 2, 0, 0}, {1.3125, 5, 0, -1}});
    const AdvanceResult advanced = simulation.advance_to(6.0);
    CHECK(advanced.counts.particle >= 2);
    CHECK(simulation.sample().velocity.square().sum() == relative(1.0, 1e-14));
    CHECK(std::abs(simulation.sample().velocity.col(0).sum()) <= 1e-15);
}

TEST_CASE("ties are counted") {
    // One disk hits two at rest at the same instant; later they reach the walls at the same time,
    // which is none.
    Simulation simulation =
        simulation_of(box_of(20.0, 20.0), {{5, 10, 1, 0}, {8, 10.5, 0, 0}, {8, 9.5, 0, 0}});
    CHECK(simulation.advance_to(2.0).counts.ties.instants == 0);
    const AdvanceResult advanced = simulation.advance_to(30.0);
    CHECK(advanced.counts.particle == 2);
    CHECK(advanced.counts.wall > 2);
    CHECK(advanced.counts.ties.contacts == 2);
}

TEST_CASE("a reversal is refused after touching disks at rest were pushed apart at once") {
    for (const double apart : {0.5, 0.75}) {
        Simulation simulation = simulation_of(
            box_of(20.0, 20.0), {{5, 10, 1, 0}, {8, 10 + apart, 0, 0}, {8, 10 - apart, 0, 0}});
        simulation.replace_events({{4.0, ReverseVelocities{}}});
        if (apart > 0.5) {  // they do not touch: each goes back the way it came
            simulation.advance_to(8.0);
            CHECK(simulation.sample().position(0, 0) == relative(5.0, 1e-13));
            continue;
        }
        CHECK_THROWS_WITH_AS(simulation.advance_to(8.0),
                             "the gas cannot go back from time 4: at time 2.133974596 several "
                             "contacts coincided and pushed particles apart that touched at rest; "
                             "reversed, all of them would meet at once",
                             RunEventError);
    }
}

TEST_CASE("what changes hands is added up") {
    // Disk 0 gives its momentum 3 to the resting disk 1 of equal mass, which gives twice to the
    // right wall.
    Simulation simulation = simulation_of(
        box_of(10.0, 10.0), {{2, 5, 1, 0, 0.5, 1.0 / 3.0}, {5, 5, 0, 0, 0.5, 1.0 / 3.0}});
    CHECK(simulation.advance_to(1.0).impulses.virial == 0.0);
    const ImpulseTotals impulses = simulation.advance_to(7.0).impulses;
    CHECK(impulses.virial == 3.0);  // a distance of 1 times a momentum of 3
    CHECK(impulses.wall[0] == 0.0);
    CHECK(impulses.wall[1] == 6.0);
    CHECK(impulses.largest_overlap == 0.0);
}

TEST_CASE("beads that overlap across the end of a ring are refused") {
    const Box ring{.dimension = 1, .size = {10.0, 0.0}, .walls = {Wall::periodic, Wall::solid}};
    const Particles particles{Eigen::ArrayXd::Constant(2, 0.5), Eigen::ArrayXd::Ones(2),
                              Eigen::ArrayXi::Zero(2)};
    Sample start{0.0, Eigen::ArrayXXd::Zero(2, 1), Eigen::ArrayXXd::Zero(2, 1)};
    start.position << 0.25, 9.25;
    CHECK_NOTHROW(Simulation(ring, particles, start, {}));
    start.position << 0.25, 9.5;
    CHECK_THROWS_AS(Simulation(ring, particles, start, {}), std::invalid_argument);
}

TEST_CASE("a gas tells how far it has equilibrated, and is none the worse for it") {
    const Gas gas = test::equal_disks(0.3, 100);
    for (const int bits : {bits_of_double, least_bits}) {
        CAPTURE(bits);
        const Run run{.until = 1.0, .equilibrate = 200.0, .events = {}, .bits = bits};
        std::vector<double> times;
        Simulation told(gas, run, [&](double time) { times.push_back(time); });
        CHECK(times.size() > 5);
        CHECK(std::ranges::is_sorted(times));
        CHECK(times.front() < -150.0);
        CHECK(times.front() >= -200.0);
        CHECK(times.back() > -50.0);
        CHECK(times.back() <= 0.0);
        Simulation untold(gas, run);
        CHECK((told.sample().position == untold.sample().position).all());
    }
}

TEST_CASE("return distances are measured on the way, at the times asked for") {
    for (const int bits : {53, 128}) {
        CAPTURE(bits);
        Run run{.until = 12.0, .events = {}};
        run.bits = bits;
        run.events = {{5.0, ReverseVelocities{}}, {8.0, ReverseVelocities{}}};
        const Gas gas = test::equal_disks(0.3, 64);
        const auto distance = [&](double first, double again) {
            Simulation simulation(gas, run);
            simulation.advance_to(first);
            const ExactPositions before = simulation.exact_positions();
            simulation.advance_to(again);
            return return_distance(before, simulation.exact_positions());
        };
        Simulation simulation(gas, run);
        simulation.measure_return({10.5, 2.0, 5.0, 6.25, 8.0, 12.0});
        CHECK(!simulation.advance_to(2.0).return_distance);  // before the first reversal
        CHECK(simulation.advance_to(5.0).return_distance->largest == 0.0);
        Simulation copy = simulation;
        const auto at_6 = simulation.advance_to(6.25).return_distance;
        REQUIRE(at_6);
        CHECK(at_6->log10_largest == distance(3.75, 6.25).log10_largest);
        CHECK(at_6->root_mean_square == distance(3.75, 6.25).root_mean_square);
        CHECK(simulation.advance_to(6.25).return_distance->largest == at_6->largest);
        CHECK(copy.advance_to(6.25).return_distance->largest == at_6->largest);
        CHECK(!simulation.advance_to(7.0).return_distance);  // not asked for
        CHECK(simulation.advance_to(8.0).return_distance->largest == 0.0);
        CHECK(simulation.advance_to(10.5).return_distance->largest == distance(5.5, 10.5).largest);
        CHECK(!simulation.advance_to(12.0).return_distance);  // beyond the branch before
    }
}
