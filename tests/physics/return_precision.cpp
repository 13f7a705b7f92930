// How many bits it takes to return is found by trial; and what a nudge does to an echo.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "physics/placement/placement.h"
#include "physics/reversal/precision.h"
#include "physics/simulation.h"
#include "support/bodies.h"
#include "support/equal_disks.h"
#include "support/nudged_echo.h"
#include "support/small_scenes.h"

using namespace carom;

namespace {

Run reversed_at(const std::vector<double>& times, double until) {
    Run run{.until = until, .events = {}, .bits = std::nullopt};
    for (const double at : times) run.events.push_back({at, ReverseVelocities{}});
    return run;
}

Run with_bits(Run run, int bits) {
    run.bits = bits;
    return run;
}

// How far from each other the gas is at two times of one run.
ReturnDistance between(const Gas& gas, const Run& run, double first, double second) {
    Simulation simulation(gas, run);
    simulation.advance_to(first);
    const ExactPositions before = simulation.exact_positions();
    simulation.advance_to(second);
    return return_distance(before, simulation.exact_positions());
}

}  // namespace

TEST_CASE("with the bits that were found a gas returns, event by event") {
    for (const Gas& gas : {test::equal_disks(0.15, 49), test::equal_disks(0.4, 49),
                           test::equal_spheres(0.1, 108), test::equal_spheres(0.3, 108)}) {
        CAPTURE(gas.box.dimension);
        CAPTURE(gas.box.size[0]);
        const Run run = reversed_at({15.0}, 30.0);
        const int bits = bits_for_return(gas, run);
        CHECK(bits % 64 == 0);
        CHECK(bits >= 128);
        CHECK(bits <= 320);
        Simulation simulation(gas, with_bits(run, bits));
        CHECK(simulation.bits() == bits);
        const ExactPositions start = simulation.exact_positions();
        simulation.record_collisions(true);
        auto out = simulation.advance_to(15.0);
        const std::int64_t there = out.counts.particle;
        const AdvanceResult back = simulation.advance_to(30.0);
        CHECK(there > 200);
        CHECK(back.counts.particle == 2 * there);
        const ReturnDistance returned = return_distance(start, simulation.exact_positions());
        CHECK(returned.largest < 0.5e-9);
        CHECK(returned.largest > 0.0);
        CHECK(returned.root_mean_square <= returned.largest);
        CHECK(returned.log10_largest == doctest::Approx(std::log10(returned.largest)));
    }
}

TEST_CASE("trials tell how far they have come") {
    const Gas gas = test::equal_disks(0.3, 36);
    const Run run = reversed_at({5.0}, 10.0);
    std::vector<std::pair<int, double>> told;
    const int bits = bits_for_return(
        gas, run, [&](int trying, double time) { told.emplace_back(trying, time); });
    REQUIRE(told.size() > 20);
    CHECK(told.front().first == 53);
    CHECK(told.back() == std::pair{bits, 10.0});
    for (std::size_t k = 1; k < told.size(); ++k)
        CHECK((told[k].first > told[k - 1].first || told[k].second >= told[k - 1].second));
    for (const auto& [trying, time] : told) CHECK(time > 0.0);
}

TEST_CASE("a finer tolerance takes more bits") {
    const Gas gas = test::equal_disks(0.3, 36);
    Run run = reversed_at({5.0}, 10.0);
    const int usual = bits_for_return(gas, run);
    run.tolerance = 1e-300;
    const int fine = bits_for_return(gas, run);
    CHECK(fine >= usual + 900);
    const ReturnDistance returned = between(gas, with_bits(run, fine), 0.0, 10.0);
    CHECK(returned.log10_largest < -300.0);
    CHECK(returned.log10_largest > -400.0);
    CHECK(between(gas, with_bits(run, 2048), 0.0, 10.0).largest == 0.0);  // no double is so small
    CHECK(between(gas, with_bits(run, 2048), 0.0, 10.0).log10_largest < -550.0);
}

TEST_CASE("a gas returns after several reversals, and beyond the start") {
    const Gas gas = test::equal_disks(0.3, 36);
    // To 8, back to 3, on to 9, at the start at 9 + 15, into the time before it, and at the start
    // again.
    const Run run = reversed_at({8.0, 13.0, 19.0, 33.0}, 45.0);
    const int bits = bits_for_return(gas, run);
    const Run certain = with_bits(run, bits);
    CHECK(between(gas, certain, 3.0, 13.0).largest < 0.5e-9);
    CHECK(between(gas, certain, 0.0, 28.0).largest < 0.5e-9);
    CHECK(between(gas, certain, 0.0, 38.0).largest < 0.5e-9);
    CHECK(between(gas, certain, 7.0, 45.0).largest < 0.5e-9);
    CHECK(between(gas, certain, 0.0, 33.0).largest > 0.1);
}

TEST_CASE("times that have no double on the other side do not ask for bits without end") {
    const Gas gas = test::equal_disks(0.3, 16);
    Run run = reversed_at({1.1, 1.7, 2.9, 4.2}, 7.3);
    run.tolerance = 1e-60;
    const int bits = bits_for_return(gas, run);
    CHECK(bits >= 256);
    CHECK(bits <= 512);
}

TEST_CASE("mixtures, walls of all kinds and lines find their bits") {
    int found = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        CAPTURE(seed);
        const bool on_line = seed % 3 == 0;
        const Gas gas =
            on_line ? test::small_line(seed) : test::small_scene(seed, seed % 3 == 1 ? 2 : 3);
        if (!on_line && test::may_crush(gas)) continue;
        Run run = reversed_at({10.0}, 20.0);
        run.equilibrate = seed % 4 == 0 ? 2.0 : 0.0;
        const int bits = bits_for_return(gas, run);
        double smallest = 1e9;
        const Particles particles = place(gas).first;
        smallest = particles.radius.minCoeff();
        if (smallest == 0.0) smallest = gas.box.size[0] / static_cast<double>(particles.count());
        CHECK(between(gas, with_bits(run, bits), 0.0, 20.0).largest < 1e-9 * smallest);
        ++found;
    }
    CHECK(found >= 50);
}

TEST_CASE("no bits are needed where nothing turns round") {
    const Gas gas = test::equal_disks(0.3, 9);
    Run run = reversed_at({}, 10.0);
    CHECK(bits_for_return(gas, run) == 53);
    run.events.push_back({5.0, Perturbation{2, {"1e-300", "0"}}});
    const int bits = bits_for_return(gas, run);
    CHECK(bits >= 1000 + 64);
    CHECK(bits <= 1200);
}

TEST_CASE("what cannot return is refused with what to change") {
    const Gas gas = test::equal_disks(0.05, 16);
    const Run run = reversed_at({20'000.0}, 40'000.0);
    std::string message, hint;
    try {
        bits_for_return(gas, run);
    } catch (const PrecisionError& error) {
        message = error.what();
        hint = error.hint();
    }
    CHECK(message.find("the limit is 16384") != std::string::npos);
    CHECK(message.find("collisions of each particle") != std::string::npos);
    CHECK(hint.find("previous reversal") != std::string::npos);
}

TEST_CASE("a nudge moves one particle by what it says, to the last digit") {
    for (const int dimension : {1, 2}) {
        for (const bool precise : {false, true}) {
            CAPTURE(dimension);
            CAPTURE(precise);
            Run run{.until = 10.0, .events = {}};
            run.bits = precise ? 1200 : 53;
            run.events = {{2.0, Perturbation{1, {precise ? "1e-300" : "0.001", "0"}}}};
            const Box box{dimension, {20.0, 20.0}, {}};
            Simulation nudged = test::simulation_of(
                box, {{5.0, 5.0, 0.0, 0.0}, {10.0, 5.0, 0.0, 0.0}, {15.0, 5.0, 0.0, 0.0}}, run);
            const ExactPositions before = nudged.exact_positions();
            nudged.advance_to(1.9);
            CHECK(return_distance(before, nudged.exact_positions()).largest == 0.0);
            nudged.advance_to(2.0);
            const ReturnDistance moved = return_distance(before, nudged.exact_positions());
            CHECK(moved.log10_largest == doctest::Approx(precise ? -300.0 : -3.0).epsilon(1e-12));
            if (!precise) CHECK(nudged.sample().position(1, 0) == 10.001);
        }
    }
}

TEST_CASE("how far nudges move a gas: of one particle they add up") {
    const Perturbation right{2, {"3e-400", "0"}}, up{2, {"0", "4e-400"}},
        other{5, {"0", "-12e-400"}};
    const ReturnDistance moved = moved_by({right, up, other}, 2);
    CHECK(moved.log10_largest == doctest::Approx(std::log10(12.0) - 400.0).epsilon(1e-12));
    CHECK(moved.log10_root_mean_square ==
          doctest::Approx(std::log10(13.0 / std::sqrt(2.0)) - 400.0).epsilon(1e-12));
    CHECK(moved_by({Perturbation{0, {"0.25", "0"}}}, 1).largest == 0.25);
    CHECK(moved_by({Perturbation{0, {"0.25", "0"}}}, 4).root_mean_square == 0.125);
    CHECK(moved_by({}, 4).log10_largest == -std::numeric_limits<double>::infinity());
}

TEST_CASE("a wall is where it has moved to when a nudge is checked") {
    for (const int bits : {53, 128}) {
        Box box{2, {20.0, 10.0}, {Wall::solid, Wall::solid}};
        box.surfaces.sides[3] = Driven{.velocity = 1.0, .until = 100.0};
        Run run{.until = 40.0, .events = {{20.0, Perturbation{0, {"0.001", "0"}}}}};
        run.bits = bits;
        Simulation nudged = test::simulation_of(box, {{10.0, 5.0, 0.1, 0.9}}, run);
        nudged.advance_to(21.0);  // at 23.9, the wall at 31
        CHECK(nudged.sample().position(0, 0) == doctest::Approx(12.101).epsilon(1e-12));
        for (const char* up : {"6.6", "9"}) {  // into the wall, and beyond it
            run.events = {{20.0, Perturbation{0, {"0", up}}}};
            Simulation pushed = test::simulation_of(box, {{10.0, 5.0, 0.1, 0.9}}, run);
            CHECK_THROWS_AS(pushed.advance_to(21.0), RunEventError);
        }
    }
}

TEST_CASE("a nudge into another particle or a wall is refused") {
    for (const int dimension : {1, 2}) {
        for (const int bits : {53, 128}) {
            CAPTURE(dimension);
            CAPTURE(bits);
            const auto message = [&](const char* by, bool ring) {
                Run run{.until = 10.0, .events = {}};
                run.bits = bits;
                run.events = {{2.0, ReverseVelocities{}}, {2.0, Perturbation{1, {by, "0"}}}};
                const Wall wall = ring ? Wall::periodic : Wall::solid;
                Simulation nudged =
                    test::simulation_of(Box{dimension, {20.0, 20.0}, {wall, wall}},
                                        {{1.0, 5.0, 0.0, 0.0}, {18.0, 5.0, 0.0, 0.0}}, run);
                try {
                    nudged.advance_to(3.0);
                } catch (const RunEventError& error) {
                    CHECK(error.event() == 1);
                    return std::string(error.what());
                }
                return std::string();
            };
            CHECK(message("1.4", false).empty());
            CHECK(message("1.6", false) == "the nudge at time 2 would push particle 1 into a wall");
            CHECK(message("1.6", true).empty());
            CHECK(message("2.1", true) ==
                  "the nudge at time 2 would push particle 1 into particle 0");
            CHECK(message("-15.9", false).empty());
            CHECK(message("-16.1", false) ==
                  "the nudge at time 2 would push particle 1 into particle 0");
        }
    }
}

TEST_CASE("a nudged echo fails when the growth law says") {
    const std::map<double, double> growth = test::measured_growth();
    for (const auto& tried : {std::pair{0.1, "1e-20"},
                              {0.2, "1e-20"},
                              {0.3, "1e-20"},
                              {0.4, "1e-20"},
                              {0.4, "1e-60"}}) {
        const auto& packing = tried.first;
        const auto& by = tried.second;
        CAPTURE(packing);
        CAPTURE(by);
        const double expected = -std::log2(std::stod(by)) / growth.at(packing);
        const double each = test::collisions_until_astray(packing, by, 1.6 * expected);
        CHECK(each > expected / 1.5);
        CHECK(each < expected * 1.5);
    }
}

TEST_CASE("trials of a precision tell how far they are, while they equilibrate too") {
    Run run = reversed_at({5.0}, 10.0);
    run.equilibrate = 400.0;
    std::map<int, std::pair<double, double>> times;  // the first and the last, by bits
    const int bits = bits_for_return(test::equal_disks(0.3, 49), run, [&](int tried, double time) {
        times.emplace(tried, std::pair{time, time}).first->second.second = time;
    });
    REQUIRE(times.contains(bits));
    for (const auto& trial : times) {
        const auto& tried = trial.first;
        const auto& of_trial = trial.second;
        CAPTURE(tried);
        CHECK(of_trial.first < -100.0);
        CHECK(of_trial.second > 0.0);
    }
}
