// Paths of particles that lie on a floor under gravity, and of gases that events heat: what is
// averaged over them does not depend on how often they are seen.
#include <doctest/doctest.h>

#include <numeric>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "physics/gas.h"
#include "stats/cell_averages.h"
#include "stats/pairs/pair_correlation.h"
#include "stats/paths/free_flights.h"
#include "stats/paths/lag_averages.h"
#include "stats/paths/line_crossings.h"
#include "stats/paths/paths.h"
#include "stats/paths/thermal_times.h"
#include "support/bodies.h"
#include "support/relative.h"

using namespace carom;
using test::Disk;
using test::relative;

namespace {

Box box_with_shelf(double gravity = -1.0) {
    Box box;
    box.size = {20.0, 20.0};
    box.surfaces.gravity = {0.0, gravity};
    box.surfaces.partitions = {{.name = "shelf", .axis = 1, .at = 10.0}};
    return box;
}

const std::int32_t shelf = Surfaces{}.first_partition();

// A run that is seen at these times.
template <class Seen>
void see(Simulation simulation, const std::vector<double>& times, Seen&& seen) {
    simulation.record_collisions(true);
    for (const double time : times) {
        const AdvanceResult advanced = simulation.advance_to(time);
        seen(simulation.sample(), advanced.collisions);
    }
}

std::vector<double> steps_up_to(double until, int steps) {
    std::vector<double> times;
    for (int k = 0; k <= steps; ++k) times.push_back(until * k / steps);
    return times;
}

std::vector<Eigen::Index> all_of(const Simulation& simulation) {
    std::vector<Eigen::Index> all(static_cast<std::size_t>(simulation.particles().count()));
    std::iota(all.begin(), all.end(), 0);
    return all;
}

// The kinetic energy of all, integrated over the time.
double energy_of(const Simulation& simulation, const std::vector<double>& times,
                 std::vector<double> changes = {}) {
    ThermalTimes thermal(simulation.box(), simulation.particles(), {{all_of(simulation), {}}},
                         std::move(changes));
    double energy = 0.0;
    see(simulation, times, [&](const Sample& sample, std::span<const Collision> collisions) {
        energy = thermal.see(sample, collisions).at(0).energy;
    });
    return energy;
}

}  // namespace

TEST_CASE("what lies on a floor goes nowhere, has no energy and crosses nothing") {
    Box wire;
    wire.dimension = 1;
    wire.size = {20.0, 0.0};
    wire.surfaces.gravity = {-1.0, 0.0};
    const std::vector<Simulation> lying{
        test::simulation_of(box_with_shelf(), {{4, 10.5, 0, 0}, {8, 10.5, 0, 0}, {12, 0.5, 0, 0}}),
        test::simulation_of(box_with_shelf(1.0), {{4, 9.5, 0, 0}, {8, 19.5, 0, 0}}),
        test::simulation_of(wire, {{0.5, 0, 0, 0}})};
    for (const Simulation& simulation : lying) {
        const Box& box = simulation.box();
        const int down = box.dimension - 1;
        const std::vector<double> times{0.0, 7.0, 100.0};
        Paths paths(box, {});
        FreeFlights flights(box, true, {});
        LagAverages ways(box, LagAverages::Of::displacements, {all_of(simulation)}, 0.0, 20.0, 3,
                         {});
        LineCrossings crossings(box, simulation.particles(), {.axis = down, .at = 9.2},
                                all_of(simulation), {});
        CellAverages cells(box, simulation.particles(), slabs(box, down, 5), {.temperature = true},
                           {});
        see(simulation, times, [&](const Sample& sample, std::span<const Collision> collisions) {
            paths(sample, collisions, [](const PathPiece& piece) {
                CHECK(piece.velocity == Vec());
                CHECK(piece.place_after(piece.span()) == piece.place);
            });
            CHECK(flights.see(sample, collisions).empty());
            for (const FlightTotals& one : flights.totals()) CHECK(one.way == 0.0);
            ways.see(sample, collisions);
            CHECK(crossings.see(sample, collisions).count == std::array<std::int64_t, 2>{0, 0});
            cells.see(sample, collisions);
        });
        CHECK(energy_of(simulation, times) == 0.0);
        CHECK(ways.averages()(0, 2) == 0.0);
        CHECK(cells.sums().speed.maxCoeff() == 0.0);
        CHECK(cells.sums().thermal_energy.maxCoeff() == 0.0);
    }
}

TEST_CASE("what rolls along a floor keeps its speed, and what is let go falls from the start") {
    const std::vector<double> times{0.0, 2.0};
    CHECK(energy_of(test::simulation_of(box_with_shelf(), {{4, 10.5, 3, 0}}), times) ==
          relative(2.0 * 4.5, 1e-14));
    // (g t)^2 / 2, integrated.
    CHECK(energy_of(test::simulation_of(box_with_shelf(), {{4, 13, 0, 0}}), times) ==
          relative(8.0 / 6.0, 1e-14));
}

TEST_CASE("what lies on a shelf falls from when it opens") {
    Run run;
    run.events = {{10.3, SetOpen{shelf, true}}};
    const Simulation simulation = test::simulation_of(box_with_shelf(), {{4, 10.5, 0, 0}}, run);
    // The time at which it falls is that of its last velocity over gravity, to the digits of 12.
    CHECK(energy_of(simulation, {0.0, 10.0, 12.0}) == relative(1.7 * 1.7 * 1.7 / 6.0, 1e-13));
    CHECK(energy_of(simulation, {0.0, 12.0}) == relative(1.7 * 1.7 * 1.7 / 6.0, 1e-13));
}

TEST_CASE("velocities that are turned round between two samples let lie what lies") {
    Run run;
    run.events = {{5.0, ReverseVelocities{}}};
    const Simulation simulation =
        test::simulation_of(box_with_shelf(), {{4, 10.5, 0, 0}, {8, 11.3, 0, 0}}, run);
    // The other bounces from 11.3 - 10.5: its energy is 0.8 less its height, in each period of
    // 2 sqrt(1.6) two thirds of 0.4 on average; seen often, as no collision is between.
    const double often = energy_of(simulation, steps_up_to(10.0, 1000), velocity_changes(run));
    const double rarely = energy_of(simulation, {0.0, 3.3, 10.0}, velocity_changes(run));
    CHECK(rarely == relative(often, 1e-10));
}

TEST_CASE("a cell and pairs with some that lie and some that fall are seen as often as one likes") {
    const Simulation simulation = test::simulation_of(box_with_shelf(), {{4, 10.5, 0, 0},
                                                                         {8, 10.5, 0, 0},
                                                                         {6, 12.5, 0.1, 0.4},
                                                                         {10, 14.0, -0.2, 0},
                                                                         {15, 0.5, 0, 0}});
    const Box& box = simulation.box();
    const auto averages = [&](int steps) {
        CellAverages cells(box, simulation.particles(), slabs(box, 1, 2), {.temperature = true},
                           {});
        PairCorrelation pairs(box, simulation.particles(), {.to = 9.0, .rings = 18}, {});
        see(simulation, steps_up_to(6.0, steps),
            [&](const Sample& sample, std::span<const Collision> collisions) {
                cells.see(sample, collisions);
                pairs.see(sample, collisions, sides_of(box));
            });
        return std::pair{cells.sums().temperature(), pairs.values()};
    };
    const auto rarely = averages(2), often = averages(600);
    CHECK(rarely.first[1] > 0.1);
    CHECK(rarely.first[1] == relative(often.first[1], 1e-10));
    // Chords keep within a thousandth of a ring.
    CHECK(rarely.second.maxCoeff() > 1.0);
    CHECK((rarely.second - often.second).abs().maxCoeff() < 2e-3 * often.second.maxCoeff());
}

TEST_CASE("heat, and heat that is undone on the way back, is on the path where it happens") {
    Gas gas;
    gas.box.size = {30.0, 20.0};
    gas.species = {{.name = "a", .count = 40, .radius = 0.2, .velocity = Temperature{1.0}}};
    Run run;
    run.bits = 256;
    run.until = 40.0;
    run.events = {{10.3, Heat{{}, Temperature{25.0}}}, {20.0, ReverseVelocities{}}};
    CHECK(velocity_changes(run) == std::vector<double>{10.3, 20.0, 29.7});
    const Simulation simulation(gas, run);
    const double cold =
        kinetic_energies(simulation.particles(), Simulation(simulation).sample()).sum();
    // 25 for each disk while it is hot. Paths end within rounding of their times and places.
    const double exact = 20.6 * cold + 19.4 * 25.0 * 40.0;
    for (const int steps : {9, 40, 160}) {
        CAPTURE(steps);
        CHECK(energy_of(simulation, steps_up_to(40.0, steps), velocity_changes(run)) ==
              relative(exact, 1e-9));
    }
    const auto crossings = [&](int steps) {
        LineCrossings all(gas.box, simulation.particles(), {.axis = 0, .at = 15.0},
                          all_of(simulation), velocity_changes(run));
        CrossingTotals totals;
        see(simulation, steps_up_to(40.0, steps),
            [&](const Sample& sample, std::span<const Collision> collisions) {
                totals = all.see(sample, collisions);
            });
        return totals;
    };
    CHECK(crossings(13).count == crossings(1600).count);
}

TEST_CASE("several changes between two samples are all on the path") {
    Gas gas;
    gas.box.size = {30.0, 20.0};
    gas.species = {{.name = "a", .count = 10, .radius = 0.2, .velocity = Temperature{1.0}}};
    Run run;
    run.until = 3.0;
    run.events = {{1.0, Heat{{}, Temperature{4.0}}}, {1.5, ReverseVelocities{}}};
    run.events[0].is_mirrored = false;
    const Simulation simulation(gas, run);
    const double cold =
        kinetic_energies(simulation.particles(), Simulation(simulation).sample()).sum();
    CHECK(energy_of(simulation, {0.0, 3.0}, velocity_changes(run)) ==
          relative(cold + 2.0 * 4.0 * 10.0, 1e-9));
}
