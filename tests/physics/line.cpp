// Beads in a row, of which nearly everything is known exactly; and disks in a row, which must do
// the same.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "physics/gas.h"
#include "support/bodies.h"
#include "support/csv.h"
#include "support/relative.h"
#include "support/test_root.h"
#include "util/random.h"

using namespace carom;
using test::along_a_line;
using test::Bead;

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

std::int64_t collisions(const AdvanceResult& advanced) {
    return advanced.counts.particle + advanced.counts.wall;
}

double number(const nlohmann::json& value) {
    return value.is_string() ? test::fraction(value.get<std::string>()) : value.get<double>();
}

// Where a point that flies freely between 0 and `length` is.
long double folded(long double x, long double length) {
    const long double turn = x - 2.0L * length * std::floor(x / (2.0L * length));
    return turn <= length ? turn : 2.0L * length - turn;
}

// Rods of one length with random gaps and velocities.
std::vector<Bead> random_rods(Random& random, int count, double length, double rod) {
    std::vector<double> free(static_cast<std::size_t>(count));
    for (double& x : free) x = random.uniform(0.0, length - count * rod);
    std::sort(free.begin(), free.end());
    std::vector<Bead> beads;
    for (const double x : free)
        beads.push_back({x + (static_cast<double>(beads.size()) + 0.5) * rod, random.normal()});
    return beads;
}

void check_that_equal_beads_pass_through(int dimension, double rod, int count, Random& random) {
    CAPTURE(dimension);
    CAPTURE(rod);
    CAPTURE(count);
    const double length = 10.0, free = length - count * rod;
    const std::vector<Bead> beads = random_rods(random, count, length, rod);
    Simulation gas = along_a_line(dimension, length, 0.5 * rod, beads);
    for (const double time : {0.3, 7.0, 100.0}) {
        CAPTURE(time);
        const auto n = static_cast<double>(collisions(gas.advance_to(time)));
        std::vector<double> expected;
        for (std::size_t k = 0; k < beads.size(); ++k) {
            const long double x = beads[k].x - (static_cast<double>(k) + 0.5) * rod;
            expected.push_back(
                static_cast<double>(folded(x + static_cast<long double>(beads[k].v) * time, free)));
        }
        std::sort(expected.begin(), expected.end());
        for (std::size_t k = 0; k < beads.size(); ++k) {
            const double x = gas.sample().position(static_cast<Eigen::Index>(k), 0) -
                             (static_cast<double>(k) + 0.5) * rod;
            // Each of the 2 n / count collisions of a bead rounds a coordinate a few times.
            CHECK(std::abs(x - expected[k]) <= epsilon * length * (4.0 + 8.0 * n / count));
        }
    }
}

}  // namespace

TEST_CASE("two beads collide by the exact matrix") {
    for (const int dimension : {1, 2}) {
        for (const auto& row : test::reference_rows("pair_collision_1d.csv")) {
            const double u1 = test::fraction(row[0]), u2 = test::fraction(row[1]);
            const Bead first{100.0, u1, test::fraction(row[2])};
            const Bead second{u1 > u2 ? 101.5 : 98.5, u2, test::fraction(row[3])};
            const bool in_order = u1 > u2;
            Simulation pair =
                along_a_line(dimension, 200.0, 0.5,
                             in_order ? std::vector{first, second} : std::vector{second, first});
            // They meet after 0.5 / |u1 - u2|, and go 40 before a wall is near.
            const AdvanceResult advanced = pair.advance_to(1.0 / std::abs(u1 - u2));
            CHECK(collisions(advanced) == 1);
            const Eigen::ArrayXXd& v = pair.sample().velocity;
            const double size = std::abs(u1) + std::abs(u2);
            CHECK(std::abs(v(in_order ? 0 : 1, 0) - std::stod(row[6])) <= 4.0 * epsilon * size);
            CHECK(std::abs(v(in_order ? 1 : 0, 0) - std::stod(row[7])) <= 4.0 * epsilon * size);
        }
    }
}

TEST_CASE("a heavy bead, a light one and a wall count the digits of pi") {
    for (const int dimension : {1, 2}) {
        for (const auto& row : test::reference_rows("galperin.csv")) {
            const int n = std::stoi(row[0]);
            CAPTURE(n);
            const double heavy = std::pow(100.0, n);
            // The other wall is so far that nobody reaches it.
            Simulation gas =
                along_a_line(dimension, 1e5, 0.5, {{2.0, 0.0}, {4.0, -1.0, 1.0 / heavy}});
            const std::int64_t counted = collisions(gas.advance_to(5e4));
            CHECK(counted == std::stoll(row[1]));
            const Eigen::ArrayXXd& v = gas.sample().velocity;
            CHECK(v(1, 0) > 0.0);
            CHECK(v(0, 0) <= v(1, 0));
            const double energy = 0.5 * (v(0, 0) * v(0, 0) + heavy * v(1, 0) * v(1, 0));
            // A rounding or two in each collision, at worst all in one direction.
            CHECK(energy ==
                  test::relative(0.5 * heavy, epsilon * (4.0 + static_cast<double>(counted))));
        }
    }
}

TEST_CASE("collision by collision, a bead between a wall and one of 1e15 times its mass") {
    // In (sqrt(M) V, sqrt(m) v) each bounce to and fro turns the velocities by 2 theta, with
    // tan(theta) = sqrt(m / M).
    for (const int dimension : {1, 2}) {
        const double ratio = 1e15;
        Simulation gas =
            along_a_line(dimension, 100.0, 0.5, {{2.0, 0.0}, {4.0, -1.0, 1.0 / ratio}});
        gas.record_collisions(true);
        const AdvanceResult advanced = gas.advance_to(2.5 - 1.5e-5);
        const double bounces = static_cast<double>(advanced.counts.particle);
        CHECK(bounces > 40'000.0);
        const double turned = 2.0 * bounces * std::atan(1.0 / std::sqrt(ratio));
        // Every collision rounds a velocity of some `speed` once or twice.
        const double speed = std::sqrt(ratio) * std::sin(turned);
        const Eigen::ArrayXXd& v = gas.sample().velocity;
        CHECK(std::abs(std::abs(v(0, 0)) - speed) <= 4.0 * epsilon * bounces * speed);
        CHECK(v(1, 0) == test::relative(-std::cos(turned), 4.0 * epsilon * bounces));
    }
}

TEST_CASE("Newton's cradle") {
    std::ifstream file(carom::test::checkout().string() + "/tests/reference/newton_cradle.json");
    const auto cases = nlohmann::json::parse(file).at("cases");
    CHECK(cases.size() == 7);
    for (const int dimension : {1, 2}) {
        for (const auto& cradle : cases) {
            CAPTURE(cradle.dump());
            std::vector<Bead> beads;
            double x = 500.0;
            for (std::size_t k = 0; k < cradle.at("v_in").size(); ++k) {
                const double mass = cradle.contains("masses") ? number(cradle["masses"][k]) : 1.0;
                beads.push_back({x, number(cradle["v_in"][k]), 1.0 / mass});
                x += 1.01 + 0.003 * static_cast<double>(k);
            }
            Simulation gas = along_a_line(dimension, 1000.0, 0.5, beads);
            CHECK(collisions(gas.advance_to(100.0)) == cradle.at("collisions").get<int>());
            for (std::size_t k = 0; k < beads.size(); ++k) {
                const double v = gas.sample().velocity(static_cast<Eigen::Index>(k), 0);
                CHECK(std::abs(v - number(cradle["v_out"][k])) <= 8.0 * epsilon);
            }
        }
    }
}

TEST_CASE("equal beads pass their velocities on, as if points flew through each other") {
    Random random(3, "equal rods");
    for (const int count : {20, 1, 2, 2, 2, 2, 2, 3, 3, 3})
        for (const int dimension : {1, 2})
            for (const double rod : {0.0, 0.25})
                if (dimension == 1 || rod > 0.0)  // points of a plane never meet
                    check_that_equal_beads_pass_through(dimension, rod, count, random);
}

TEST_CASE("the force on the ends of a line is twice the energy over the free length") {
    // Seen from the rods' left neighbours, X = x - (k - 1/2) a, only the right end does virial
    // work: L' times what it received = 2 E t - [sum X p], exactly and at any time, for any masses.
    Random random(5, "rods of all masses");
    for (const int dimension : {1, 2}) {
        for (const double rod : {0.0, 0.5}) {
            if (dimension == 2 && rod == 0.0) continue;
            constexpr int count = 7;
            const double length = 9.0, free = length - count * rod;
            std::vector<Bead> beads = random_rods(random, count, length, rod);
            for (Bead& b : beads) b.inverse_mass = 1.0 / random.uniform(0.1, 5.0);
            Simulation gas = along_a_line(dimension, length, 0.5 * rod, beads);
            const Eigen::ArrayXd mass = gas.particles().inverse_mass.inverse();
            const double energy = kinetic_energies(gas.particles(), gas.sample()).sum();
            const auto moment = [&] {
                const Eigen::ArrayXd shift =
                    (Eigen::ArrayXd::LinSpaced(count, 0.0, count - 1.0) + 0.5) * rod;
                return ((gas.sample().position.col(0) - shift) * mass *
                        gas.sample().velocity.col(0))
                    .sum();
            };
            const double moment_before = moment();
            const double most = std::sqrt(2.0 * energy * mass.sum());  // of the momentum
            const double momentum_before = (mass * gas.sample().velocity.col(0)).sum();
            for (const double time : {0.5, 20.0, 2000.0}) {
                CAPTURE(time);
                const AdvanceResult advanced = gas.advance_to(time);
                const double right = advanced.impulses.wall[1], left = advanced.impulses.wall[0];
                const double twice = 2.0 * energy * time;
                // Each collision adds a rounded number.
                const double rounding =
                    epsilon * (16.0 + static_cast<double>(collisions(advanced)));
                CHECK(std::abs(free * right - (twice - moment() + moment_before)) <=
                      rounding * (twice + most * length));
                const double momentum = (mass * gas.sample().velocity.col(0)).sum();
                CHECK(std::abs(right - left - (momentum_before - momentum)) <=
                      rounding * (twice / length + most));
                if (time > 1000.0) CHECK(left / time == test::relative(twice / time / free, 0.01));
            }
        }
    }
}

// Where masses are in a simple ratio, half of the new velocities lie in the middle between two
// numbers: an error of 1 / 3 would round all of them one way, and the energy grow evenly.
TEST_CASE("the energy of beads does not drift, whatever their masses") {
    for (const auto& masses : {std::pair{1.0, 3.0}, {3.0, 7.0}, {0.1, 0.7}}) {
        const auto& first = masses.first;
        const auto& second = masses.second;
        CAPTURE(first);
        CAPTURE(second);
        Gas gas;
        gas.box = {.dimension = 1, .size = {100.0, 0.0}};
        gas.species = {
            {.name = "a", .count = 20, .radius = 0.1, .mass = first, .velocity = Temperature{1.0}},
            {.name = "b",
             .count = 20,
             .radius = 0.1,
             .mass = second,
             .velocity = Temperature{1.0}}};
        Simulation simulation(gas, {});
        const auto energy = [&] {
            return kinetic_energies(simulation.particles(), simulation.sample()).sum();
        };
        const double begin = energy();
        const AdvanceResult advanced = simulation.advance_to(20'000.0);
        const auto collisions = static_cast<double>(advanced.counts.particle);
        REQUIRE(collisions > 5e4);
        // Each changes the energy by some units of round-off of two beads' energy, an average bead
        // having a fortieth: a walk of independent steps, of which five standard deviations are
        // less than this. An even growth by half a unit would be ten times as much.
        const double step = 4.0 * 0x1p-53 / 40.0;
        CHECK(std::abs(energy() / begin - 1.0) < 5.0 * step * std::sqrt(collisions));
    }
}
