// Every gas returns: few and many collisions, few and many particles, dilute and dense, mixed.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <string>

#include "physics/reversal/precision.h"
#include "physics/simulation.h"
#include "support/equal_disks.h"
#include "support/nudged_echo.h"

using namespace carom;

namespace {

// The time by which each particle has had so many collisions with others, whole steps of it.
double time_of_collisions(const Gas& gas, Run run, double of_each) {
    run.bits = bits_of_double;
    Simulation simulation(gas, run);
    const double wanted = 0.5 * of_each * static_cast<double>(simulation.particles().count());
    double time = 0.0;
    while (static_cast<double>(simulation.advance_to(time).counts.particle) < wanted) time += 0.25;
    return time;
}

// Back within the tolerance, in smallest radii, by as many events; with the bits that are found.
// Returns these.
int check_comes_home(const Gas& gas, double of_each) {
    Run run{.until = 0.0, .equilibrate = 1.0, .events = {}};
    const double out = time_of_collisions(gas, run, of_each);
    run.until = 2.0 * out;
    run.events = {{out, ReverseVelocities{}}};
    run.bits = std::nullopt;
    const int bits = bits_for_return(gas, run);
    run.bits = bits;
    Simulation simulation(gas, run);
    const ExactPositions start = simulation.exact_positions();
    const CollisionCounts there = simulation.advance_to(out).counts;
    const CollisionCounts back = simulation.advance_to(2.0 * out).counts;
    CHECK(back.particle == 2 * there.particle);
    CHECK(back.wall == 2 * there.wall);
    const double radius = simulation.particles().radius.minCoeff();
    CHECK(return_distance(start, simulation.exact_positions()).largest < 1e-9 * radius);
    return bits;
}

}  // namespace

TEST_CASE("equal disks return, and the rule for the first guess is enough") {
    for (const double packing : {0.1, 0.2, 0.3, 0.4, 0.5}) {
        for (const int count : {50, 200}) {
            for (const double of_each : {10.0, 50.0, 200.0}) {
                CAPTURE(packing);
                CAPTURE(count);
                CAPTURE(of_each);
                Gas gas = test::equal_disks(packing, count);
                gas.box.walls = {Wall::solid, Wall::solid};
                const int bits = check_comes_home(gas, of_each);
                const double lost = 3.85 * std::log2(1.0 + 0.115 / packing) * (of_each + 2.0);
                CHECK(bits < 31.0 + 24.0 + lost + 2.0 * std::sqrt(lost) + 64.0);
            }
        }
    }
}

TEST_CASE("mixtures of sizes and masses return, with fixed and driven disks too") {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        for (const bool driven : {false, true}) {
            CAPTURE(seed);
            CAPTURE(driven);
            Gas gas;
            gas.seed = seed;
            gas.box.size = {30.0, 24.0};
            gas.box.walls = {seed % 2 == 0 ? Wall::periodic : Wall::solid, Wall::solid};
            gas.species = {{.name = "small",
                            .count = 60,
                            .radius = UniformDistribution{0.2, 0.5},
                            .mass = Density{1.0},
                            .velocity = Temperature{1.0}},
                           {.name = "large", .count = 6, .radius = 2.0, .mass = ValueRule{50.0}}};
            if (driven)
                gas.species.push_back({.name = "driven",
                                       .count = 1,
                                       .radius = 1.0,
                                       .mass = Infinite{},
                                       .velocity = Velocity{{{0.1, 0.05}}}});
            else
                gas.species.push_back({.name = "fixed", .count = 2, .mass = Infinite{}});
            check_comes_home(gas, 60.0);
        }
    }
}

TEST_CASE("nudged echoes fail when the growth law says, from 1e-20 to 1e-120") {
    for (const auto& [packing, bits] : test::measured_growth()) {
        if (packing > 0.45) continue;
        for (const char* by : {"1e-20", "1e-40", "1e-80", "1e-120"}) {
            for (const std::uint64_t seed : {2, 3}) {
                CAPTURE(packing);
                CAPTURE(by);
                CAPTURE(seed);
                const double expected = -std::log2(std::stod(by)) / bits;
                const double each =
                    test::collisions_until_astray(packing, by, 1.6 * expected, seed);
                CHECK(each > expected / 1.5);
                CHECK(each < expected * 1.5);
            }
        }
    }
}
