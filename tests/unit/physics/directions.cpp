// Directions at given speeds whose momenta sum to zero.
#include "physics/sampling/directions.h"

#include <doctest/doctest.h>

#include <cmath>
#include <set>

#include "physics/mechanics.h"
#include "physics/placement/draws.h"
#include "physics/placement/problem.h"
#include "util/random.h"

using namespace carom;

namespace {

Gas gas_with(std::vector<Species> species, Walls walls, int dimension = 2, std::uint64_t seed = 1) {
    return {.box = {dimension, {20.0, dimension == 2 ? 20.0 : 0.0}, walls},
            .species = std::move(species),
            .seed = seed};
}

constexpr Walls all_periodic{Wall::periodic, Wall::periodic};

// The largest component of the momentum, relative to the sum of all momenta.
double imbalance(const Particles& particles, const Sample& start, Eigen::Index axis) {
    const Eigen::ArrayXd mass = particles.inverse_mass.inverse();
    return std::abs((mass * start.velocity.col(axis)).sum()) / (mass * speeds(start)).sum();
}

}  // namespace

TEST_CASE("in a periodic box all particles keep their speed, and the momenta sum to zero") {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        CAPTURE(seed);
        for (const std::int64_t count : {2, 3, 4, 5, 7, 300}) {
            CAPTURE(count);
            const Gas gas = gas_with({{.name = "", .count = count, .velocity = Speed{1.0}}},
                                     all_periodic, 2, seed);
            const auto [particles, start] = draw_gas(gas);
            CHECK((speeds(start) - 1.0).abs().maxCoeff() < 4e-16);
            CHECK(imbalance(particles, start, 0) < 1e-15);
            CHECK(imbalance(particles, start, 1) < 1e-15);
        }
        // several species share one sum of zero
        const Gas mixed =
            gas_with({{.name = "", .count = 1, .mass = ValueRule{10.0}, .velocity = Speed{0.5}},
                      {.name = "", .count = 4, .velocity = Speed{UniformDistribution{2.0, 4.0}}},
                      {.name = "", .count = 5, .velocity = Temperature{1.0}}},
                     all_periodic, 2, seed);
        const auto [particles, start] = draw_gas(mixed);
        CHECK(imbalance(particles, start, 0) < 1e-15);
        CHECK(imbalance(particles, start, 1) < 1e-15);
        CHECK(speeds(start)[0] == doctest::Approx(0.5).epsilon(1e-15));
        CHECK(speeds(start).segment(1, 4).minCoeff() >= 2.0 - 1e-15);
        CHECK(speeds(start).segment(1, 4).maxCoeff() <= 4.0 + 1e-15);
    }
}

TEST_CASE("three equal momenta make angles of 120 degrees, whichever way they are turned") {
    std::array<int, 4> quarters{};
    int turns_left = 0;
    for (std::uint64_t seed = 1; seed <= 400; ++seed) {
        const Gas gas =
            gas_with({{.name = "", .count = 3, .velocity = Speed{2.0}}}, all_periodic, 2, seed);
        const auto [particles, start] = draw_gas(gas);
        const auto v = [&, &velocity = start.velocity](int i) { return velocity.row(i).eval(); };
        for (int i = 0; i < 3; ++i)
            CHECK((v(i) * v((i + 1) % 3)).sum() == doctest::Approx(-2.0).epsilon(1e-14));
        turns_left += v(0)[0] * v(1)[1] - v(0)[1] * v(1)[0] > 0.0;
        ++quarters.at(static_cast<std::size_t>(2 * (v(0)[0] > 0.0) + (v(0)[1] > 0.0)));
    }
    CHECK(std::abs(turns_left - 200) < 4.5 * 10.0);
    for (const int quarter : quarters) CHECK(std::abs(quarter - 100) < 4.5 * std::sqrt(75.0));
}

TEST_CASE("momenta at the limit of what is possible are parallel, and beyond it they are refused") {
    Random random(1, "limit");
    Eigen::ArrayXd momenta(4), angles = Eigen::ArrayXd::LinSpaced(4, 0.1, 5.0);
    momenta << 6.0, 1.0, 2.0, 3.0;
    REQUIRE(balance_angles(momenta, {true, true}, random, angles));
    CHECK(std::abs((momenta * angles.cos()).sum()) < 3e-14);
    CHECK(std::abs((momenta * angles.sin()).sum()) < 3e-14);
    const Eigen::ArrayXd before = angles;
    momenta[0] = 6.001;
    CHECK(!balance_angles(momenta, {true, true}, random, angles));
    CHECK((angles == before).all());
    CHECK(balance_angles(momenta, {true, false}, random, angles));
    CHECK(std::abs((momenta * angles.cos()).sum()) < 3e-14);
    try {
        draw_gas(
            gas_with({{.name = "", .count = 5, .velocity = Speed{1.0}},
                      {.name = "", .count = 1, .mass = ValueRule{7.0}, .velocity = Speed{1.0}}},
                     all_periodic));
        FAIL("not refused");
    } catch (const PlacementError& error) {
        CHECK(error.problem().kind == Problem::Kind::momentum);
        CHECK(error.problem().species == 1);
        CHECK(error.problem().value == doctest::Approx(7.0));
        CHECK(error.problem().bound == doctest::Approx(5.0));
    }
}

TEST_CASE("where momentum is not conserved, speeds have independent directions") {
    const std::vector<Species> alone{{.name = "", .count = 1, .velocity = Speed{1.0}}};
    CHECK_THROWS_AS(draw_gas(gas_with(alone, all_periodic)), PlacementError);
    Gas lorentz = gas_with(alone, all_periodic);
    lorentz.box.surfaces.obstacles.push_back(
        {.name = "", .shape = Obstacle::Ball{{5.0, 5.0}, 2.0}});
    CHECK(speeds(draw_gas(lorentz).second)[0] == doctest::Approx(1.0));
    Gas pinned = gas_with(alone, all_periodic);
    pinned.species.push_back({.name = "", .count = 1, .mass = Infinite{}});
    CHECK(speeds(draw_gas(pinned).second)[0] == doctest::Approx(1.0));
    // Periodic along x only: the particle moves along y.
    const Sample across = draw_gas(gas_with(alone, {Wall::periodic, Wall::solid})).second;
    CHECK(std::abs(across.velocity(0, 0)) < 1e-15);
    CHECK(std::abs(across.velocity(0, 1)) == 1.0);
    const auto [particles, start] = draw_gas(gas_with(
        {{.name = "", .count = 50, .velocity = Speed{3.0}}}, {Wall::periodic, Wall::solid}));
    CHECK(imbalance(particles, start, 0) < 1e-15);
    CHECK(imbalance(particles, start, 1) > 1e-3);
    CHECK((speeds(start) - 3.0).abs().maxCoeff() < 2e-15);
}

TEST_CASE("on a ring the directions of beads sum to zero, or none do") {
    const auto ring = [](std::vector<Species> species, std::uint64_t seed) {
        return gas_with(std::move(species), {Wall::periodic, Wall::solid}, 1, seed);
    };
    const auto bead = [](std::int64_t count, double mass, double speed) {
        return Species{.name = "",
                       .count = count,
                       .radius = 0.0,
                       .mass = ValueRule{mass},
                       .velocity = Speed{speed}};
    };
    std::set<std::vector<double>> seen;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        // 3 = 1 + 2, each in one direction or the other; four more beads share theirs
        const auto [particles, start] = draw_gas(ring(
            {bead(1, 3.0, 1.0), bead(2, 1.0, 0.5), bead(1, 1.0, 2.0), bead(4, 7.1, 1.3)}, seed));
        REQUIRE((particles.inverse_mass.inverse() * start.velocity.col(0)).sum() ==
                doctest::Approx(0.0));
        CHECK(std::abs(start.velocity(0, 0)) == 1.0);
        CHECK(start.velocity(1, 0) == start.velocity(2, 0));
        CHECK((start.velocity.col(0).tail(4) > 0.0).count() == 2);
        seen.insert({start.velocity.col(0).begin(), start.velocity.col(0).end()});
    }
    CHECK(seen.size() == 12);  // 2 directions, 6 pairs out of four
    CHECK_THROWS_AS(draw_gas(ring({bead(3, 1.0, 1.0)}, 1)), PlacementError);
    CHECK_THROWS_AS(draw_gas(ring({bead(1, 1.0, 1.0), bead(1, 1.0, 1.001)}, 1)), PlacementError);
    CHECK_THROWS_AS(draw_gas(ring({bead(1000, 2.0, 1.0), bead(1001, 3.0, 1.0)}, 1)),
                    PlacementError);
    // many different momenta without a solution: the search ends
    Gas wild = ring({bead(60, 1.0, 1.0)}, 1);
    wild.species[0].velocity = Speed{UniformDistribution{1.0, 2.0}};
    CHECK_THROWS_AS(draw_gas(wild), PlacementError);
}

TEST_CASE("a gas of many particles keeps its drawn directions but for small turns") {
    const std::int64_t count = 10'000;
    const Sample start =
        draw_gas(gas_with({{.name = "", .count = count, .velocity = Speed{1.0}}}, all_periodic))
            .second;
    const Sample free = draw_gas(gas_with({{.name = "", .count = count, .velocity = Speed{1.0}}},
                                          {Wall::solid, Wall::solid}))
                            .second;
    const Eigen::ArrayXd turned = (start.velocity * free.velocity).rowwise().sum().min(1.0).acos();
    // The drawn momenta sum to some sqrt(N) of the N, and each turn takes up a share of the sum:
    // turns are of order 1/sqrt(N), the largest here 0.47 of it.
    CHECK(turned.maxCoeff() < 2.0 / std::sqrt(double(count)));
    CHECK(turned.maxCoeff() > 0.0);
}
