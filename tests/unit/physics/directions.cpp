// Directions at given speeds whose momenta sum to zero.
#include "physics/sampling/directions.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <vector>

#include "physics/gas.h"
#include "physics/mechanics.h"
#include "physics/placement/draws.h"
#include "physics/placement/problem.h"
#include "support/goodness_of_fit.h"
#include "util/random.h"

using namespace carom;

namespace {

Gas gas_with(std::vector<Species> species, Walls walls, int dimension = 2, std::uint64_t seed = 1) {
    Gas gas{
        .box = {dimension, {20.0, dimension > 1 ? 20.0 : 0.0, dimension > 2 ? 20.0 : 0.0}, walls},
        .species = std::move(species),
        .seed = seed};
    if (dimension == 3) gas.box.surfaces.side_count = 6;
    return gas;
}

constexpr Walls all_periodic{Wall::periodic, Wall::periodic, Wall::periodic};

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

// Each component of a uniform direction is uniform in [-1, 1], and so is the azimuth in its range
// (Archimedes). 13 tests: a p-value below 1e-7 is a failure, as are 6 standard deviations.
TEST_CASE("in space speeds have directions that are uniform on the sphere") {
    const Eigen::Index count = 40'000;
    const Sample start =
        draw_gas(gas_with({{.name = "", .count = count, .velocity = Speed{1.0}}}, {}, 3)).second;
    CHECK((speeds(start) - 1.0).abs().maxCoeff() < 4e-16);
    const double error = 6.0 / std::sqrt(double(count));
    for (int axis = 0; axis < 3; ++axis) {
        const Eigen::ArrayXd u = start.velocity.col(axis);
        const Eigen::ArrayXd v = start.velocity.col((axis + 1) % 3);
        // the variances of u, u^2, u^4 and u v are 1/3, 1/5 - 1/9, 1/9 - 1/25 and 1/15
        CHECK(std::abs(u.mean()) < error * std::sqrt(1.0 / 3.0));
        CHECK(std::abs(u.square().mean() - 1.0 / 3.0) < error * std::sqrt(4.0 / 45.0));
        CHECK(std::abs(u.square().square().mean() - 1.0 / 5.0) < error * std::sqrt(16.0 / 225.0));
        CHECK(std::abs((u * v).mean()) < error * std::sqrt(1.0 / 15.0));
        CHECK(test::chance({u.begin(), u.end()}, [](double x) { return 0.5 * (x + 1.0); }) > 1e-7);
        std::vector<double> azimuths;
        for (Eigen::Index i = 0; i < count; ++i) azimuths.push_back(std::atan2(v[i], u[i]));
        CHECK(test::chance(azimuths, [](double x) { return 0.5 + 0.5 * x / std::numbers::pi; }) >
              1e-7);
    }
}

TEST_CASE("in space the momenta sum to zero along each axis that conserves them") {
    for (int periodic = 1; periodic < 8; ++periodic) {
        Walls walls{};
        for (std::size_t axis = 0; axis < 3; ++axis)
            walls[axis] = (periodic >> axis & 1) != 0 ? Wall::periodic : Wall::solid;
        CAPTURE(periodic);
        for (std::uint64_t seed = 1; seed <= 20; ++seed)
            for (const std::int64_t count : {1, 2, 3, 4, 5, 7, 300}) {
                if (count == 1 && periodic == 7) continue;
                CAPTURE(count);
                const auto [particles, start] = draw_gas(gas_with(
                    {{.name = "", .count = count, .velocity = Speed{1.0}}}, walls, 3, seed));
                CHECK((speeds(start) - 1.0).abs().maxCoeff() < 4e-16);
                for (int axis = 0; axis < 3; ++axis)
                    if (walls[static_cast<std::size_t>(axis)] == Wall::periodic)
                        CHECK(imbalance(particles, start, axis) < 1e-15);
                    else if (count == 300)
                        CHECK(imbalance(particles, start, axis) > 1e-5);
            }
        // several species share one sum of zero
        const auto [particles, start] = draw_gas(
            gas_with({{.name = "", .count = 1, .mass = ValueRule{10.0}, .velocity = Speed{0.5}},
                      {.name = "", .count = 4, .velocity = Speed{UniformDistribution{2.0, 4.0}}},
                      {.name = "", .count = 5, .velocity = Temperature{1.0}}},
                     walls, 3));
        for (int axis = 0; axis < 3; ++axis)
            if (walls[static_cast<std::size_t>(axis)] == Wall::periodic)
                CHECK(imbalance(particles, start, axis) < 1e-15);
        CHECK(speeds(start)[0] == doctest::Approx(0.5).epsilon(1e-15));
    }
}

// The normal of their plane is uniform on the sphere. 3 tests: a p-value below 1e-6 is a failure.
TEST_CASE("three equal momenta in space make angles of 120 degrees in a plane that is turned") {
    std::array<std::vector<double>, 3> normals;
    for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
        const Sample start = draw_gas(gas_with({{.name = "", .count = 3, .velocity = Speed{2.0}}},
                                               all_periodic, 3, seed))
                                 .second;
        const auto v = [&](int i) { return vec_in(start.velocity, i); };
        for (int i = 0; i < 3; ++i)
            CHECK(dot(v(i), v((i + 1) % 3)) == doctest::Approx(-2.0).epsilon(1e-14));
        const Vec normal = cross(v(0), v(1)) / (2.0 * std::sqrt(3.0));
        for (std::size_t axis = 0; axis < 3; ++axis) normals[axis].push_back(normal[axis]);
    }
    for (const std::vector<double>& along : normals)
        CHECK(test::chance(along, [](double x) { return 0.5 * (x + 1.0); }) > 1e-6);
}

TEST_CASE("in space too, momenta at the limit are parallel, and beyond it they are refused") {
    Random random(1, "limit");
    Eigen::ArrayXd momenta(4);
    momenta << 6.0, 1.0, 2.0, 3.0;
    std::vector<Vec> directions{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.6, 0.0, 0.8}, {0.0, 0.0, 1.0}};
    const auto sum = [&] {
        Vec total;
        for (std::size_t i = 0; i < 4; ++i)
            total += momenta[static_cast<Eigen::Index>(i)] * directions[i];
        return abs(total);
    };
    REQUIRE(balance_directions(momenta, {true, true, true}, random, directions));
    CHECK(length(sum()) < 3e-14);
    for (std::size_t i = 1; i < 4; ++i)
        CHECK(dot(directions[0], directions[i]) == doctest::Approx(-1.0).epsilon(1e-7));
    const std::vector<Vec> before = directions;
    momenta[0] = 6.001;
    CHECK(!balance_directions(momenta, {true, true, true}, random, directions));
    CHECK(directions == before);
    CHECK(balance_directions(momenta, {true, false, true}, random, directions));
    CHECK(sum()[0] < 3e-14);
    CHECK(sum()[2] < 3e-14);
    for (const Vec& unit : directions) CHECK(length(unit) == doctest::Approx(1.0).epsilon(1e-15));
    CHECK_THROWS_AS(
        draw_gas(gas_with({{.name = "", .count = 1, .velocity = Speed{1.0}}}, all_periodic, 3)),
        PlacementError);
}

TEST_CASE("a gas of many spheres keeps its drawn directions but for small turns") {
    const std::int64_t count = 10'000;
    const auto drawn_with = [&](const Walls& walls) {
        return draw_gas(gas_with({{.name = "", .count = count, .velocity = Speed{1.0}}}, walls, 3))
            .second;
    };
    const Eigen::ArrayXd turned = (drawn_with(all_periodic).velocity - drawn_with({}).velocity)
                                      .square()
                                      .rowwise()
                                      .sum()
                                      .sqrt();
    // as in the plane, of order 1/sqrt(N): a sum of sqrt(N) is shared by 2/3 N
    CHECK(turned.maxCoeff() < 4.0 / std::sqrt(double(count)));
    CHECK(turned.maxCoeff() > 0.0);
}
