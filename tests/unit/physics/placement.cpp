#include "physics/placement/placement.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numeric>
#include <string>

#include "physics/gas.h"
#include "physics/mechanics.h"
#include "support/placement_error.h"
#include "support/relative.h"
#include "util/random.h"

using namespace carom;
using test::placement_error;
using test::relative;

namespace {

Gas gas_of(double width, double height, std::vector<Species> species) {
    Gas gas;
    gas.box.size = {width, height};
    gas.species = std::move(species);
    return gas;
}

// The least of distance / (sum of radii) over all pairs and images, and of room to the walls.
double least_clearance(const Gas& gas, const Particles& particles, const Sample& sample) {
    double least = 1e300;
    for (Eigen::Index i = 0; i < particles.count(); ++i) {
        for (Eigen::Index j = 0; j < i; ++j) {
            Vec r = vec_in(sample.position, i) - vec_in(sample.position, j);
            for (int a = 0; a < 2; ++a)
                if (gas.box.is_periodic(a)) r[a] = std::remainder(r[a], gas.box.size[a]);
            least = std::min(least,
                             std::hypot(r[0], r[1]) / (particles.radius[i] + particles.radius[j]));
        }
        for (int a = 0; a < 2; ++a) {
            if (gas.box.is_periodic(a)) continue;
            const double x = sample.position(i, a);
            least = std::min(least, std::min(x, gas.box.size[a] - x) / particles.radius[i]);
        }
    }
    return least;
}

}  // namespace

TEST_CASE("random places do not overlap, lie inside, and depend on the seed only") {
    for (const Wall wall : {Wall::solid, Wall::periodic}) {
        Gas gas = gas_of(40.0, 30.0,
                         {{.name = "small", .count = 300, .radius = UniformDistribution{0.2, 0.6}},
                          {.name = "large", .count = 5, .radius = 3.0}});
        gas.box.walls = {wall, wall};
        const auto [particles, start] = place(gas);
        CHECK(particles.count() == 305);
        CHECK(particles.species[304] == 1);
        CHECK(least_clearance(gas, particles, start) >= 1.0 - 1e-12);
        const auto again = place(gas);
        CHECK((again.second.position == start.position).all());
        gas.seed = 2;
        CHECK((place(gas).second.position != start.position).any());
    }
}

TEST_CASE("a hundred thousand disks at packing 0.5 find room") {
    const double side = std::sqrt(100'000 * 3.14159265 * 0.25 / 0.5);
    Gas gas = gas_of(side, side, {{.name = "", .count = 100'000}});
    gas.box.walls = {Wall::periodic, Wall::periodic};
    CHECK(place(gas).first.count() == 100'000);
}

TEST_CASE("lattices are fitted to the box, dense ones too") {
    for (const Wall wall_x : {Wall::solid, Wall::periodic}) {
        for (const Wall wall_y : {Wall::solid, Wall::periodic}) {
            for (const int count : {1, 2, 7, 100, 1000}) {
                Gas gas = gas_of(50.0, 43.0, {{.name = "", .count = count}});
                gas.species[0].radius = std::sqrt(0.75 * 50.0 * 43.0 / (3.14159265 * 1000.0));
                gas.species[0].position = LatticePlaces{};
                gas.box.walls = {wall_x, wall_y};
                const auto [particles, start] = place(gas);
                CHECK(least_clearance(gas, particles, start) >= 1.0 - 1e-11);
            }
        }
    }
    // 0.85 in a box of the lattice's own shape
    Gas gas = gas_of(40.0, 40 * std::sqrt(0.75), {{.name = "", .count = 1600}});
    gas.species[0].radius = std::sqrt(0.85 * gas.box.content() / (3.14159265 * 1600.0));
    gas.species[0].position = LatticePlaces{};
    gas.box.walls = {Wall::periodic, Wall::periodic};
    const auto [particles, start] = place(gas);
    CHECK(least_clearance(gas, particles, start) >= 1.0);
}

TEST_CASE("species share a lattice, and random disks go around listed ones and the lattice") {
    Gas gas = gas_of(20.0, 20.0,
                     {{.name = "a", .count = 30, .radius = 0.5, .position = LatticePlaces{}},
                      {.name = "b", .count = 30, .radius = 0.4, .position = LatticePlaces{}},
                      {.name = "listed", .count = 1, .radius = 2.0},
                      {.name = "within", .count = 10, .radius = 0.2}});
    gas.species[2].position = Places{{{10.0, 10.0}}};
    gas.species[3].position = WithinRegion{{{2.0, 2.0}, {8.0, 8.0}}};
    const auto [particles, start] = place(gas);
    CHECK(least_clearance(gas, particles, start) >= 1.0 - 1e-12);
    CHECK(start.position(60, 0) == 10.0);
    CHECK(start.position.bottomRows(10).minCoeff() >= 2.2);
    CHECK(start.position.bottomRows(10).maxCoeff() <= 7.8);
}

TEST_CASE("no room: one sentence with the numbers and a way out") {
    CHECK(placement_error(gas_of(10.0, 10.0, {{.name = "cold", .count = 100, .radius = 0.48}})) ==
          "only 66 of 100 disks of species \"cold\" could be placed at packing fraction 0.724; "
          "fewer or "
          "smaller disks, a larger box, or places on a lattice");
    CHECK(placement_error(gas_of(10.0, 10.0, {{.name = "", .count = 1'000'000, .radius = 0.5}})) ==
          "the disks cover 7.854e+05 of the box's area 100 (packing fraction 7854), more than the "
          "0.9069 of the densest packing; fewer or smaller disks, or a box of about 1.25e+03 by "
          "1.25e+03");
    CHECK(
        placement_error(gas_of(64.0, 48.0, {{.name = "giant", .count = 1, .radius = 25.0}})) ==
        "a disk of radius 25 does not fit into a box of 64 by 48; a smaller disk or a larger box");
    CHECK(placement_error(gas_of(10.0, 10.0, {{.name = "x", .count = 1'000'000'000'000}})) ==
          "1000000000000 disks of species \"x\" are more than the 50000000 particles that a gas "
          "may have; give fewer");
    Gas gas = gas_of(10.0, 10.0, {{.name = "w", .count = 9, .radius = 0.5}});
    gas.species[0].position = WithinRegion{{{1.0, 1.0}, {3.0, 3.0}}};
    CHECK(placement_error(gas) ==
          "9 disks in its region have packing fraction 1.767, more than the 0.9069 of the "
          "densest packing; fewer or smaller disks or more room");
    gas.species[0].count = 4;
    CHECK(placement_error(gas) ==
          "only 1 of 4 disks of species \"w\" could be placed at packing fraction 0.785 of their "
          "region; fewer or smaller disks, or a larger region");
    gas = gas_of(10.0, 10.0, {{.name = "l", .count = 100, .radius = 0.5}});
    gas.species[0].position = LatticePlaces{};
    CHECK(place(gas).first.count() == 100);
    gas.species[0].count = 110;
    CHECK(placement_error(gas) ==
          "no hexagonal lattice holds 110 disks of radius 0.5 in a box of 10 by 10; use fewer "
          "disks (105 fit, with room to move or without), smaller ones, or a larger box");
    gas.species = {{.name = "l", .count = 50, .radius = 0.5, .position = LatticePlaces{}},
                   {.name = "large", .count = 1, .radius = 4.0, .position = Places{{{5.0, 5.0}}}}};
    CHECK(placement_error(gas).starts_with("other disks leave "));
}

TEST_CASE("listed places are checked, across periodic borders too") {
    Gas gas = gas_of(10.0, 10.0, {{.name = "p", .count = 2}});
    gas.species[0].position = Places{{{0.6, 5.0}, {9.8, 5.0}}};
    CHECK(placement_error(gas) ==
          "particle 1 (p) of radius 0.5 is not inside the box of 10 by 10; its centre must have x "
          "from 0.5 to 9.5 and y from 0.5 to 9.5");
    gas.box.walls[0] = Wall::periodic;
    CHECK(placement_error(gas) ==
          "particle 1 (p) overlaps particle 0 (p): 0.8 apart, at least 1 needed; move one of them, "
          "or make them smaller");
    gas.species[0].position = Places{{{0.7, 5.0}, {1.7, 5.0}}};  // touching, but for round-off
    CHECK(placement_error(gas).empty());
    try {
        place(gas_of(5.0, 5.0,
                     {{.name = "fits", .count = 1}, {.name = "not", .count = 1, .radius = 3.0}}));
        CHECK(false);
    } catch (const PlacementError& error) {
        CHECK(error.species() == 1);
    }
}

// Sums of n squares are within n round-offs of what they are: at most 2000 here.
TEST_CASE("an exact temperature is that of the drawn velocities, to the last digit") {
    constexpr double round_off = 2.2e-16;
    for (const Wall wall : {Wall::solid, Wall::periodic})
        for (const bool two : {false, true}) {
            CAPTURE(two);
            std::vector<Species> species{
                {.name = "a", .count = 7, .velocity = Temperature{8.0, true}}};
            if (two)
                species.push_back({.name = "b",
                                   .count = 300,
                                   .radius = 0.2,
                                   .mass = ValueRule{5.0},
                                   .velocity = Temperature{8.0, true}});
            Gas gas = gas_of(100.0, 100.0, species);
            gas.box.walls = {wall, wall};
            const auto [particles, start] = place(gas);
            CHECK(thermal_motion(gas.box, particles, start).temperature() ==
                  relative(8.0, 2000 * round_off));
            std::vector<Eigen::Index> first(7);
            std::iota(first.begin(), first.end(), 0);
            CHECK(thermal_motion(gas.box, particles, start, first).temperature() ==
                  relative(8.0, 2000 * round_off));
            // Nothing but a common factor tells it from the sample.
            gas.species[0].velocity = Temperature{8.0};
            const Sample sampled = place(gas).second;
            const Eigen::ArrayXXd ratio = start.velocity.topRows(7) / sampled.velocity.topRows(7);
            CHECK(((ratio / ratio(0, 0) - 1.0).abs() < 4.0 * round_off).all());
            CHECK(std::abs(ratio(0, 0) - 1.0) > 1e-3);
        }
}

TEST_CASE("what does not move cannot be brought to a temperature exactly") {
    Gas gas =
        gas_of(9.0, 9.0,
               {{.name = "a", .count = 2, .mass = Infinite{}, .velocity = Temperature{8.0, true}}});
    const std::string why =
        "no velocities can be scaled to a temperature of exactly 8; particles of infinite mass, "
        "and "
        "a single one in a periodic box, have no temperature";
    CHECK(placement_error(gas) == why);
    gas.species[0] = {.name = "a", .count = 1, .velocity = Temperature{8.0, true}};
    CHECK(placement_error(gas).empty());
    gas.box.walls = {Wall::periodic, Wall::periodic};
    CHECK(placement_error(gas) == why);
    gas.species[0].velocity = Temperature{0.0, true};
    CHECK(placement_error(gas).empty());
}

TEST_CASE("masses and velocities follow their rules") {
    Gas gas =
        gas_of(100.0, 100.0,
               {{.name = "dense", .count = 1, .radius = 2.0, .mass = Density{3.0}},
                {.name = "fixed", .count = 2, .mass = Infinite{}, .velocity = Temperature{2.0}},
                {.name = "list", .count = 2, .mass = ValueRule{std::vector{4.0, 8.0}}},
                {.name = "speed", .count = 400, .velocity = Speed{3.0}},
                {.name = "warm",
                 .count = 2000,
                 .radius = 0.1,
                 .mass = ValueRule{4.0},
                 .velocity = Temperature{2.0}},
                {.name = "normal", .count = 500, .radius = NormalDistribution{0.1, 0.1}}});
    gas.species[2].velocity = Velocity{{{1.0, -2.0}}};
    const auto [particles, start] = place(gas);
    CHECK(particles.inverse_mass[0] == relative(1.0 / (12.0 * 3.14159265358979), 2e-15));
    CHECK(particles.inverse_mass[1] == 0.0);
    CHECK(start.velocity(1, 0) == 0.0);
    CHECK(particles.inverse_mass[4] == 0.125);
    CHECK(start.velocity(4, 1) == -2.0);
    CHECK((speeds(start).segment(5, 400) - 3.0).abs().maxCoeff() < 1e-14);
    // <m v^2 / 2> = T in 2-D, with a standard error of T / sqrt(2000): four of them
    CHECK(kinetic_energies(particles, start).segment(405, 2000).mean() ==
          relative(2.0, 4.0 / std::sqrt(2000.0)));
    CHECK((particles.radius > 0.0).all());

    gas.box.walls[0] = Wall::periodic;
    gas.species[1].mass = ValueRule{1.0};  // one of infinite mass would not let it be conserved
    const Sample drifting = place(gas).second;
    CHECK(std::abs(drifting.velocity.col(0).segment(5, 400).sum()) < 1e-12);
    CHECK((speeds(drifting).segment(5, 400) - 3.0).abs().maxCoeff() < 1e-14);
    CHECK(std::abs(drifting.velocity.col(0).segment(405, 2000).sum()) < 1e-12);
    CHECK(std::abs(drifting.velocity.col(1).segment(5, 400).sum()) > 1e-3);
}

TEST_CASE("sums are added up in the order of Eigen's with two numbers at a time") {
    Random random(3, "sums");
    for (Eigen::Index count = 0; count <= 40; ++count) {
        CAPTURE(count);
        Eigen::ArrayXd values(count);
        for (double& value : values) value = random.normal();
#if defined(__SSE2__) && !defined(__AVX__)
        CHECK(sum_in_order(values) == values.sum());
#endif
        // Each addition of a sum errs by at most half a unit in the last place of a partial sum.
        const double round_off = double(count) * 0x1p-52 * values.abs().sum();
        CHECK(std::abs(sum_in_order(values) - values.sum()) <= round_off);
    }
}
