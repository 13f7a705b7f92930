#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "physics/gas.h"
#include "physics/placement/line_room.h"
#include "physics/placement/placement.h"
#include "support/placement_error.h"
#include "support/relative.h"

using namespace carom;
using test::placement_error;
using test::relative;

namespace {

Gas line_of(double length, std::vector<Species> species, Wall ends = Wall::solid) {
    Gas gas;
    gas.box = {1, {length, 0.0}, {ends, Wall::solid}};
    gas.species = std::move(species);
    return gas;
}

Places at(const std::vector<double>& x) {
    Places places;
    for (const double place : x) places.values.push_back({place, 0.0});
    return places;
}

std::vector<Eigen::Index> from_left_to_right(const Sample& sample) {
    std::vector<Eigen::Index> order(static_cast<std::size_t>(sample.position.rows()));
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) {
        return sample.position(a, 0) < sample.position(b, 0);
    });
    return order;
}

// All gaps between neighbours and to the ends, from left to right.
std::vector<double> gaps(const Gas& gas, const Particles& particles, const Sample& sample) {
    const std::vector<Eigen::Index> order = from_left_to_right(sample);
    const bool ring = gas.box.is_periodic(0);
    std::vector<double> found;
    double before = 0.0;
    for (const Eigen::Index i : order) {
        const double x = sample.position(i, 0), r = particles.radius[i];
        if (!ring || i != order.front()) found.push_back(x - r - before);
        before = x + r;
    }
    const double turn = sample.position(order.front(), 0) - particles.radius[order.front()];
    found.push_back(gas.box.size[0] - before + (ring ? turn : 0.0));
    return found;
}

double least_gap(const Gas& gas, const Particles& particles, const Sample& sample) {
    const std::vector<double> all = gaps(gas, particles, sample);
    return *std::min_element(all.begin(), all.end());
}

}  // namespace

TEST_CASE("beads never overlap, even where they fill the line, and depend on the seed only") {
    for (const Wall ends : {Wall::solid, Wall::periodic})
        for (const double filled : {0.0, 0.5, 0.999, 1.0}) {
            CAPTURE(filled);
            Gas gas = line_of(100.0,
                              {{.name = "short", .count = 50, .radius = 0.6 * filled},
                               {.name = "long", .count = 10, .radius = 2.0 * filled}},
                              ends);
            const auto [particles, start] = place(gas);
            CHECK(start.position.cols() == 1);
            CHECK(start.velocity.cols() == 1);
            CHECK(least_gap(gas, particles, start) > (filled == 0.0 ? 0.0 : -1e-12));
            if (ends == Wall::periodic) CHECK(start.position.minCoeff() >= 0.0);
            if (ends == Wall::periodic) CHECK(start.position.maxCoeff() < 100.0);
            CHECK((place(gas).second.position == start.position).all());
            gas.seed = 2;
            CHECK((place(gas).second.position != start.position).any());
        }
}

TEST_CASE("random beads are uniform over all arrangements") {
    // Free places of rods are those of points on a shorter line: the k-th of N has x ~ Beta(k, N +
    // 1 - k) whatever the lengths. Mean and variance over many seeds, to 4.5 standard errors of 16.
    constexpr int seeds = 4000;
    const std::vector<double> radii{1.0, 0.0, 2.0, 0.5};
    const double free = 10.0;
    Eigen::Array4d sum = Eigen::Array4d::Zero(), squares = Eigen::Array4d::Zero();
    Eigen::Array4d first = Eigen::Array4d::Zero();
    for (int seed = 1; seed <= seeds; ++seed) {
        Gas gas = line_of(17.0, {{.name = "a", .count = 2, .radius = std::vector{1.0, 0.0}},
                                 {.name = "b", .count = 2, .radius = std::vector{2.0, 0.5}}});
        gas.seed = static_cast<std::uint64_t>(seed);
        const auto [particles, start] = place(gas);
        double before = 0.0;
        const std::vector<Eigen::Index> order = from_left_to_right(start);
        first[order[0]] += 1.0 / seeds;
        for (int k = 0; k < 4; ++k) {
            const Eigen::Index i = order[static_cast<std::size_t>(k)];
            const double x = (start.position(i, 0) - particles.radius[i] - before) / free;
            before += 2.0 * particles.radius[i];
            sum[k] += x;
            squares[k] += x * x;
        }
    }
    for (int k = 0; k < 4; ++k) {
        const double a = k + 1, b = 4 - k, mean = a / (a + b);
        const double variance = a * b / ((a + b) * (a + b) * (a + b + 1.0));
        CHECK(std::abs(sum[k] / seeds - mean) < 4.5 * std::sqrt(variance / seeds));
        // The variance of a squared deviation is at most 2 variance^2 (kurtosis below 3).
        CHECK(std::abs(squares[k] / seeds - mean * mean - variance) <
              4.5 * variance * std::sqrt(2.0 / seeds) + 9.0 * mean * std::sqrt(variance / seeds));
        CHECK(std::abs(first[k] - 0.25) < 4.5 * std::sqrt(0.1875 / seeds));
    }
}

TEST_CASE("on a ring no place is like the ends of a line") {
    // Gaps of N beads on a ring are those of N - 1 points: the mean square is 2 / (N (N + 1)).
    constexpr int seeds = 4000;
    double square = 0.0, left_half = 0.0, across_the_end = 0.0;
    for (int seed = 1; seed <= seeds; ++seed) {
        Gas gas = line_of(8.0, {{.name = "", .count = 3, .radius = 1.0}}, Wall::periodic);
        gas.seed = static_cast<std::uint64_t>(seed);
        const auto [particles, start] = place(gas);
        for (const double gap : gaps(gas, particles, start)) square += gap * gap / 4.0 / 3.0;
        const auto from_end = (start.position.col(0) - 4.0).abs();
        across_the_end += double((from_end > 3.0).count());
        left_half += (start.position.col(0) < 4.0).cast<double>().sum() / 3.0;
    }
    // Four standard errors of 0.4 %
    CHECK(square / seeds == relative(1.0 / 6.0, 0.016));
    CHECK(std::abs(left_half / seeds - 0.5) < 4.5 * std::sqrt(0.25 / seeds));
    CHECK(std::abs(across_the_end / seeds - 0.75) < 4.5 * std::sqrt(0.1875 / seeds));
}

TEST_CASE("a lattice has equal gaps, and stands in the order of the numbers") {
    for (const Wall ends : {Wall::solid, Wall::periodic})
        for (const int count : {1, 2, 7, 1000}) {
            Gas gas = line_of(50.0, {{.name = "", .count = count, .radius = 0.02}}, ends);
            gas.species[0].position = LatticePlaces{};
            const auto [particles, start] = place(gas);
            const double gap = (50.0 - 0.04 * count) / (count + (ends == Wall::solid ? 1 : 0));
            for (const double found : gaps(gas, particles, start))
                REQUIRE(found == relative(gap, 1e-11));
            const std::vector<Eigen::Index> order = from_left_to_right(start);
            CHECK(std::is_sorted(order.begin(), order.end()));
        }
    // Around a piston at 3 : 1: of 40 points 31 and 9 have gaps of at least 30/32, 30 and 10 of
    // 10/11.
    Gas gas = line_of(41.0, {{.name = "piston", .count = 1, .radius = 0.5, .position = at({30.5})},
                             {.name = "a", .count = 20, .radius = 0.0},
                             {.name = "b", .count = 20, .radius = 0.0}});
    gas.species[1].position = gas.species[2].position = LatticePlaces{};
    const auto [particles, start] = place(gas);
    CHECK((start.position.col(0) < 30.0).count() == 31);
    CHECK(least_gap(gas, particles, start) == relative(30.0 / 32.0, 1e-13));
    CHECK((start.position.middleRows(1, 20) < 30.0).count() != 20);  // mixed
}

TEST_CASE("random beads go around listed ones, and stay in their part of the line") {
    for (const Wall ends : {Wall::solid, Wall::periodic}) {
        Gas gas = line_of(100.0,
                          {{.name = "listed", .count = 3, .radius = 2.0},
                           {.name = "part", .count = 40, .radius = 0.1},
                           {.name = "inner", .count = 10, .radius = 0.05},
                           {.name = "any", .count = 60, .radius = UniformDistribution{0.0, 0.5}}},
                          ends);
        gas.species[0].position = at({40.0, 2.0, 50.0});
        gas.species[1].position = WithinRegion{{{20.0, 0.0}, {60.0, 0.0}}};
        gas.species[2].position = WithinRegion{{{44.0, 0.0}, {45.2, 0.0}}};
        const auto [particles, start] = place(gas);
        CHECK(least_gap(gas, particles, start) > -1e-12);
        CHECK(start.position(1, 0) == 2.0);
        CHECK(start.position.middleRows(3, 40).minCoeff() >= 20.1);
        CHECK(start.position.middleRows(3, 40).maxCoeff() <= 59.9);
        CHECK(start.position.middleRows(43, 10).minCoeff() >= 44.05);
        CHECK(start.position.middleRows(43, 10).maxCoeff() <= 45.15);
        CHECK(start.position.bottomRows(60).minCoeff() < 20.0);
    }
}

TEST_CASE("each stretch gets points in proportion to its length") {
    Gas gas = line_of(10.0, {{.name = "walls", .count = 2, .radius = 0.5},
                             {.name = "", .count = 20000, .radius = 0.0}});
    gas.species[0].position = at({2.5, 6.5});  // free: 2, 3 and 3
    const auto [particles, start] = place(gas);
    const auto x = start.position.col(0).tail(20000);
    CHECK(std::abs(double((x < 2.5).count()) / 20000.0 - 0.25) < 4.5 * std::sqrt(0.1875 / 20000));
    CHECK(std::abs(double((x > 6.5).count()) / 20000.0 - 0.375) < 4.5 * std::sqrt(0.2344 / 20000));
}

TEST_CASE("points where numbers are scarce have different places all the same") {
    Gas gas = line_of(2.0, {{.name = "", .count = 3, .radius = 0.0}});
    gas.species[0].position = WithinRegion{{{1.0, 0.0}, {1.0 + 0x1p-49, 0.0}}};  // 7 between
    for (gas.seed = 1; gas.seed <= 100; ++gas.seed) {
        const auto [particles, start] = place(gas);
        REQUIRE(least_gap(gas, particles, start) > 0.0);
        REQUIRE(start.position.minCoeff() > 1.0);
        REQUIRE(start.position.maxCoeff() < 1.0 + 0x1p-49);
    }
    gas.species[0].count = 8;
    CHECK(placement_error(gas).starts_with("8 beads do not fit in their part of the wire"));
}

TEST_CASE("rods that just fit into their stretches are found room, whatever the luck") {
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        Gas gas = line_of(
            10.0, {{.name = "piston", .count = 1, .radius = 0.5}, {.name = "rods", .count = 4}});
        gas.species[0].position = at({4.5});                        // free: 4 and 5
        gas.species[1].radius = std::vector{1.25, 1.25, 1.5, 0.5};  // 2.5 + 2.5, 3 + 1
        gas.seed = seed;
        const auto [particles, start] = place(gas);
        REQUIRE(least_gap(gas, particles, start) > -1e-12);
    }
}

TEST_CASE("very many beads find their places at once") {
    std::vector<double> posts;
    for (int i = 0; i < 100'000; ++i) posts.push_back(1.0 + i);
    Gas gas = line_of(100'001.0, {{.name = "posts", .count = 100'000, .radius = 0.1},
                                  {.name = "", .count = 200'000, .radius = 0.1}});
    gas.species[0].position = at(posts);
    const auto [particles, start] = place(gas);
    CHECK(least_gap(gas, particles, start) > -1e-12 * 1e5);
}

TEST_CASE("no room on the line: one sentence with the numbers and a way out") {
    CHECK(
        placement_error(line_of(10.0, {{.name = "rods", .count = 11, .radius = 0.5}})) ==
        "the beads are 11 long together, longer than the wire of 10; fewer or shorter beads, or a "
        "wire of about 22");
    Gas gas = line_of(10.0, {{.name = "piston", .count = 1, .radius = 0.5},
                             {.name = "rods", .count = 3, .radius = 1.4}});
    gas.species[0].position = at({4.0});
    CHECK(placement_error(gas) ==
          "3 beads of species \"rods\" do not fit on the wire: together they are 8.4 long, and "
          "the free stretches 9, the widest 5.5; fewer or shorter beads, or a longer wire");
    gas.species[1].position = WithinRegion{{{5.0, 0.0}, {9.0, 0.0}}};
    CHECK(placement_error(gas) ==
          "3 beads, 8.4 long together, do not fit into its region, 4 long; fewer or shorter beads "
          "or more room");
    gas.species[1].position = WithinRegion{{{3.0, 0.0}, {10.0, 0.0}}};
    gas.species[1].count = 2;
    gas.species[1].radius = 1.6;
    CHECK(placement_error(gas) ==
          "2 beads of species \"rods\" do not fit in their part of the wire: together they are "
          "6.4 long, and the free stretches 6, the widest 5.5; fewer or shorter beads, or a "
          "longer part");
    gas = line_of(10.0, {{.name = "", .count = 1, .mass = Density{2.0}}});
    gas.species[0].radius = 0.0;
    CHECK(placement_error(gas) ==
          "a point, of radius 0, has no mass from a density; give a radius, or a mass instead");
}

TEST_CASE("listed places are checked, across the ends of a ring too") {
    Gas gas = line_of(10.0, {{.name = "p", .count = 2, .radius = 0.5}});
    gas.species[0].position = at({0.5, 9.8});
    CHECK(placement_error(gas) ==
          "particle 1 (p) of radius 0.5 is not inside the wire from 0 to 10; its centre must lie "
          "between 0.5 and 9.5");
    gas.box.walls[0] = Wall::periodic;
    CHECK(placement_error(gas) ==
          "particle 1 (p) overlaps particle 0 (p): 0.7 apart, at least 1 needed; move one of them, "
          "or make them shorter");
    gas.species[0].position = at({0.3, 9.3});  // touching, but for round-off
    CHECK(placement_error(gas).empty());
    gas.species[0].radius = 0.0;
    gas.species[0].position = at({3.0, 3.0});
    CHECK(placement_error(gas) ==
          "particle 1 (p) is at the place of particle 0 (p); beads have an order on the wire: move "
          "one "
          "of them");
    gas.species[0].position = at({0.0, 10.0});  // one place on a ring
    CHECK(placement_error(gas) ==
          "particle 1 (p) is at the place of particle 0 (p); beads have an order on the wire: move "
          "one "
          "of them");
    gas.box.walls[0] = Wall::solid;
    CHECK(placement_error(gas).empty());
}

TEST_CASE("masses and velocities of beads follow their rules") {
    Gas gas =
        line_of(100.0, {{.name = "dense", .count = 1, .radius = 2.0, .mass = Density{3.0}},
                        {.name = "list", .count = 2, .radius = 0.0},
                        {.name = "speed", .count = 400, .radius = 0.0, .velocity = Speed{3.0}},
                        {.name = "warm",
                         .count = 2000,
                         .radius = 0.0,
                         .mass = ValueRule{4.0},
                         .velocity = Temperature{2.0}}});
    gas.species[1].velocity = Velocity{{{1.0, 0.0}, {-2.0, 0.0}}};
    const auto [particles, start] = place(gas);
    CHECK(particles.inverse_mass[0] == relative(1.0 / 12.0, 4e-16));
    CHECK(start.velocity(1, 0) == 1.0);
    CHECK(start.velocity(2, 0) == -2.0);
    CHECK((speeds(start).segment(3, 400) == 3.0).all());
    // As many to the left as to the right, to 4 standard errors.
    CHECK(std::abs(start.velocity.col(0).segment(3, 400).sum() / 3.0) < 4.0 * 20.0);
    // <m v^2> = T in 1-D, with a standard error of T sqrt(2/2000)
    CHECK(2.0 * kinetic_energies(particles, start).tail(2000).mean() ==
          relative(2.0, 4.0 * std::sqrt(2.0 / 2000.0)));
    gas.box.walls[0] = Wall::periodic;
    const Sample balanced = place(gas).second;
    CHECK(balanced.velocity.col(0).segment(3, 400).sum() == 0.0);
    CHECK((speeds(balanced).segment(3, 400) == 3.0).all());
    CHECK(std::abs(balanced.velocity.col(0).tail(2000).sum()) < 1e-12);
}

TEST_CASE("two beads alone on a ring never start at rest for want of momentum") {
    int to_the_right = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        Gas gas = line_of(10.0, {{.name = "", .count = 2, .radius = 0.0, .velocity = Speed{1.0}}},
                          Wall::periodic);
        gas.seed = seed;
        const Sample start = place(gas).second;
        REQUIRE(start.velocity.col(0).abs().minCoeff() == 1.0);
        REQUIRE(start.velocity.col(0).sum() == 0.0);
        to_the_right += start.velocity(0, 0) > 0.0;
    }
    CHECK(std::abs(to_the_right - 100) < 4.5 * std::sqrt(50.0));
}
