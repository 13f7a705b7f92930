// Where a reversed run leaves the way it came, and that a return is asked for, and measured, only
// up to there.
#include "physics/ways_back.h"

#include <doctest/doctest.h>

#include <limits>

#include "physics/gas.h"
#include "physics/reversal/precision.h"
#include "physics/simulation.h"

using namespace carom;

namespace {

const std::int32_t divider = Surfaces{}.first_partition();
const ReverseVelocities reverse{};
const SetOpen open{divider, true}, shut{divider, false};

void check_way(const WayBack& way, double begin, double end, std::size_t event) {
    CHECK(way.begin == begin);
    CHECK(way.end == end);
    REQUIRE(way.event);
    CHECK(*way.event == event);
}

void check_whole(const WayBack& way, double begin) {
    CHECK(way.begin == begin);
    CHECK(way.end == std::numeric_limits<double>::infinity());
    CHECK_FALSE(way.event);
}

Gas gas_beside_divider() {
    Gas gas;
    gas.box.size = {20.0, 10.0};
    gas.box.surfaces.partitions = {{.name = "divider", .at = 10.0}};
    gas.species = {{.name = "disks",
                    .count = 24,
                    .radius = 0.3,
                    .velocity = Temperature{1.0},
                    .position = WithinRegion{{{0.0, 0.0}, {10.0, 10.0}}}}};
    return gas;
}

// It opens at 12 and stays so; home is asked for up to 48.
Run left_open() {
    Run run;
    run.bits = std::nullopt;
    run.until = 60.0;
    run.events = {{12.0, open, false}, {30.0, reverse}};
    return run;
}

}  // namespace

TEST_CASE("what is undone and what is only moved a little lead no run off its way back") {
    CHECK(ways_back({{1.0, open}, {2.0, open, false}}).empty());
    const auto ways = ways_back(
        {{1.0, open}, {2.0, shut}, {4.0, reverse}, {4.0, Perturbation{0, {"1e-9", "0"}}}});
    REQUIRE(ways.size() == 1);
    check_whole(ways[0], 4.0);
}

TEST_CASE("a way back ends at the first event behind that is not undone") {
    const auto ways = ways_back(
        {{1.0, open, false}, {3.0, shut, false}, {4.0, open}, {8.0, reverse}, {20.0, shut}});
    REQUIRE(ways.size() == 1);
    check_way(ways[0], 8.0, 13.0, 1);
    check_way(ways_back({{8.0, open, false}, {8.0, reverse}})[0], 8.0, 8.0, 0);
}

TEST_CASE("a way back ends at an event that was not there on the way out") {
    check_way(ways_back({{8.0, reverse}, {10.0, open}})[0], 8.0, 10.0, 1);
    check_way(ways_back({{8.0, reverse}, {8.0, open}})[0], 8.0, 8.0, 1);
    check_whole(ways_back({{8.0, reverse}, {17.0, open}})[0], 8.0);  // beyond the start all is new
}

TEST_CASE("where a way back has been left, a further reversal comes back all the way") {
    // At 13 the first event is not undone; from then on nothing is where it was at times before 3.
    const auto ways = ways_back({{3.0, open, false}, {8.0, reverse}, {15.0, reverse}});
    REQUIRE(ways.size() == 2);
    check_way(ways[0], 8.0, 13.0, 0);
    check_whole(ways[1], 15.0);
    // Turned before it comes there, the run goes on to what is new to it, and then back past it.
    const auto later =
        ways_back({{3.0, open, false}, {8.0, reverse}, {10.0, reverse}, {14.0, reverse}});
    REQUIRE(later.size() == 3);
    check_whole(later[0], 8.0);
    check_whole(later[1], 10.0);
    check_way(later[2], 14.0, 21.0, 0);
    // One on the way back that is not undone leads the next off as well.
    const auto twice = ways_back({{8.0, reverse}, {10.0, open, false}, {12.0, reverse}});
    check_way(twice[0], 8.0, 10.0, 1);
    check_way(twice[1], 12.0, 14.0, 1);
}

TEST_CASE("home is asked for up to the last event that is mirrored") {
    const Gas gas = gas_beside_divider();
    Run run = left_open();
    Simulation simulation = start_run(gas, run);
    CHECK(simulation.bits() >= 128);
    CHECK(simulation.bits() <= 320);
    simulation.measure_return({36.0, 48.0, 52.0});
    for (const double time : {36.0, 48.0}) {
        const auto distance = simulation.advance_to(time).return_distance;
        REQUIRE(distance);
        CHECK(distance->largest < 1e-9);
    }
    CHECK_FALSE(simulation.advance_to(52.0).return_distance);
    CHECK(simulation.surfaces()[divider].is_open);
    // Behind the divider again, they can be locked in.
    run.events.push_back({48.0, shut});
    CHECK_NOTHROW(start_run(gas, run).advance_to(60.0));
    // And after that the run comes back over all that is new.
    run.events = {{12.0, open, false}, {30.0, reverse}, {55.0, reverse}};
    run.until = 80.0;
    Simulation twice = start_run(gas, run);
    twice.measure_return({79.0});
    const auto distance = twice.advance_to(79.0).return_distance;
    REQUIRE(distance);
    CHECK(distance->largest < 1e-9);
}

TEST_CASE("an event that cannot happen in a trial is named as the run counts it") {
    const Gas gas = gas_beside_divider();
    Run run = left_open();
    run.events.insert(run.events.begin(), {1.0, Perturbation{0, {"1e-30", "0"}}});
    run.events.push_back({31.0, shut});
    try {
        start_run(gas, run);
        FAIL("the gas is in the way of the divider");
    } catch (const RunEventError& error) {
        CHECK(error.event() == 3);
    }
}
