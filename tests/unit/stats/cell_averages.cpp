// Averages over cells by exact times of residence: by hand, and against sums over many samples.
#include "stats/cell_averages.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>

#include "physics/collision_error.h"
#include "physics/gas.h"

using namespace carom;

namespace {

Particles particles_of(const std::vector<double>& masses) {
    const auto n = static_cast<Eigen::Index>(masses.size());
    Particles particles{Eigen::ArrayXd::Zero(n), Eigen::ArrayXd(n), Eigen::ArrayXi::Zero(n)};
    for (Eigen::Index i = 0; i < n; ++i)
        particles.inverse_mass[i] = 1.0 / masses[static_cast<std::size_t>(i)];
    return particles;
}

Sample sample_of(double time, const std::vector<std::array<double, 4>>& rows) {
    const auto n = static_cast<Eigen::Index>(rows.size());
    Sample sample{time, Eigen::ArrayXXd(n, 2), Eigen::ArrayXXd(n, 2)};
    for (Eigen::Index i = 0; i < n; ++i) {
        const auto& row = rows[static_cast<std::size_t>(i)];
        sample.position.row(i) << row[0], row[1];
        sample.velocity.row(i) << row[2], row[3];
    }
    return sample;
}

Box box_of(double width, double height) {
    Box box;
    box.size = {width, height};
    return box;
}

Gas gas_of(std::int64_t count, double gravity) {
    Gas gas;
    gas.box = box_of(20.0, 10.0);
    gas.box.surfaces.gravity = {0.0, gravity};
    gas.species = {{.name = "a", .count = count, .radius = 0.3, .velocity = Temperature{2.0}},
                   {.name = "b",
                    .count = count,
                    .radius = 0.3,
                    .mass = ValueRule{3.0},
                    .velocity = Temperature{2.0}}};
    return gas;
}

}  // namespace

TEST_CASE("a particle that crosses cells is in each as long as it takes") {
    const Box box = box_of(4.0, 2.0);
    CellAverages averages(box, particles_of({1.0}), square_cells(box, 4), {}, {});
    averages.see(sample_of(0.0, {{0.5, 0.5, 2.0, 0.5}}), {});
    // From x 0.5 to 3.5, through x 1, 2, 3 at 0.25, 0.75, 1.25, and through y 1 at 1.
    averages.see(sample_of(1.5, {{3.5, 1.25, 2.0, 0.5}}), {});
    const CellSums sums = averages.sums();
    CHECK(sums.time == doctest::Approx(1.5));
    const double expected[] = {0.25, 0.5, 0.25, 0.0, 0.0, 0.0, 0.25, 0.25};
    for (Eigen::Index cell = 0; cell < 8; ++cell) {
        CAPTURE(cell);
        CHECK(sums.particles[cell] == doctest::Approx(expected[cell]).epsilon(1e-12));
        CHECK(sums.velocity(cell, 0) == doctest::Approx(2.0 * expected[cell]).epsilon(1e-12));
        CHECK(sums.speed[cell] ==
              doctest::Approx(std::hypot(2.0, 0.5) * expected[cell]).epsilon(1e-12));
    }
}

TEST_CASE("a point on a side of the box is in the cell at this side") {
    const Box box = box_of(4.0, 2.0);
    CellAverages averages(box, particles_of({1.0, 1.0, 1.0}), square_cells(box, 4), {}, {});
    const double below = 1.0 - 1e-15;  // on an edge between cells but for a rounding error
    averages.see(sample_of(0.0, {{4.0, 2.0, 0, 0}, {0.0, 0.0, 0, 0}, {below, below, 0, 0}}), {});
    for (int k = 0; k < 2; ++k) {
        const Eigen::ArrayXd particles = averages.sums().particles;
        CHECK(particles.sum() == 3.0);
        CHECK(particles[7] == 1.0);
        CHECK(particles[0] == 1.0);
        CHECK(particles[5] == 1.0);
        averages.see(sample_of(1.0, {{4.0, 2.0, 0, 0}, {0.0, 0.0, 0, 0}, {below, below, 0, 0}}),
                     {});
    }
}

TEST_CASE("a collision on the way, a reversal and a periodic side are on the path") {
    Box box = box_of(4.0, 1.0);
    box.walls[0] = Wall::periodic;
    const Cells cells = slabs(box, 0, 4);
    SUBCASE("a collision") {
        CellAverages averages(box, particles_of({1.0}), cells, {}, {});
        averages.see(sample_of(0.0, {{0.5, 0.5, 1.0, 0.0}}), {});
        const Collision turn{1.0,        0,          Partner(Side::right), {1.5, 0.5}, {1.5, 0.5},
                             {1.0, 0.0}, {0.0, 0.0}, {-1.0, 0.0},          {0.0, 0.0}};
        averages.see(sample_of(2.0, {{0.5, 0.5, -1.0, 0.0}}), std::span(&turn, 1));
        CHECK(averages.sums().particles[0] == doctest::Approx(1.0));
        CHECK(averages.sums().particles[1] == doctest::Approx(1.0));
        CHECK(std::abs(averages.sums().velocity(1, 0)) < 1e-12);
    }
    SUBCASE("a reversal") {
        CellAverages averages(box, particles_of({1.0}), cells, {}, {0.75});
        averages.see(sample_of(0.0, {{0.5, 0.5, 1.0, 0.0}}), {});
        averages.see(sample_of(1.5, {{0.5, 0.5, -1.0, 0.0}}), {});
        CHECK(averages.sums().particles[0] == doctest::Approx(1.0));
        CHECK(averages.sums().particles[1] == doctest::Approx(0.5));
    }
    SUBCASE("through a side, round and round") {
        CellAverages averages(box, particles_of({1.0}), cells, {}, {});
        averages.see(sample_of(0.0, {{3.5, 0.5, 10.0, 0.0}}), {});
        averages.see(sample_of(1.0, {{1.5, 0.5, 10.0, 0.0}}), {});
        const double expected[] = {0.3, 0.25, 0.2, 0.25};  // of the way of 10
        for (Eigen::Index cell = 0; cell < 4; ++cell)
            CHECK(averages.sums().particles[cell] == doctest::Approx(expected[cell]));
    }
}

TEST_CASE("a particle that goes round a periodic box a million times is refused") {
    Box box = box_of(4.0, 2.0);
    box.walls[0] = Wall::periodic;
    CellAverages averages(box, particles_of({1.0}), square_cells(box, 4), {}, {});
    averages.see(sample_of(0.0, {{0.5, 0.5, 0.0, 0.0}}), {});
    averages.see(sample_of(1.0, {{0.5, 0.5, 1.1e6, 0.0}}), {});
    CHECK_THROWS_AS(averages.see(sample_of(2.0, {{0.5, 0.5, 1.1e6, 0.0}}), {}), CollisionError);
}

TEST_CASE("in gravity a flight that turns is in a cell going up and coming down") {
    Box box = box_of(1.0, 4.0);
    box.surfaces.gravity = {0.0, -2.0};
    CellAverages averages(box, particles_of({1.0}), slabs(box, 1, 4), {}, {});
    averages.see(sample_of(0.0, {{0.5, 0.5, 0.0, 2.0}}), {});
    averages.see(sample_of(2.0, {{0.5, 0.5, 0.0, -2.0}}), {});
    const double below = 2.0 * (1.0 - std::sqrt(0.5));  // y = 1/2 + 2 t - t²
    CHECK(averages.sums().particles[0] == doctest::Approx(below).epsilon(1e-12));
    CHECK(averages.sums().particles[1] == doctest::Approx(2.0 - below).epsilon(1e-12));
    CHECK(averages.sums().particles[2] == 0.0);
}

TEST_CASE("the temperature is that of the motion about the mean of those who are there") {
    const Box box = box_of(4.0, 1.0);
    CellAverages::Wanted wanted{.temperature = true};
    CellAverages averages(box, particles_of({1.0, 3.0, 1.0}), slabs(box, 0, 2), wanted, {});
    // Two in the first cell until one leaves it at 0.5; a third alone in the second until then.
    const double y = 0.5;
    averages.see(sample_of(0.0, {{0.5, y, 1.0, 0.0}, {1.0, y, 2.0, 0.0}, {3.0, y, 0.0, 0.4}}), {});
    const auto moment = averages.sums().temperature();
    CHECK(moment[0] == doctest::Approx(0.375));  // 3/4 of 1², over two dimensions
    CHECK(std::isnan(moment[1]));
    averages.see(sample_of(1.0, {{1.5, y, 1.0, 0.0}, {3.0, y, 2.0, 0.0}, {3.0, 0.9, 0.0, 0.4}}),
                 {});
    const CellSums sums = averages.sums();
    CHECK(sums.temperature()[0] == doctest::Approx(0.375));
    CHECK(sums.thermal_freedom[0] == doctest::Approx(0.5));
    CHECK(sums.temperature()[1] == doctest::Approx(0.75 * 4.16 / 2.0));  // (2, -0.4)
}

TEST_CASE("a window forgets what was before it, to a thirty-second") {
    const Box box = box_of(100.0, 1.0);
    CellAverages averages(box, particles_of({1.0}), slabs(box, 0, 100), {.window = 3.2}, {});
    averages.see(sample_of(0.0, {{0.0, 0.5, 1.0, 0.0}}), {});
    for (const double time : {0.05, 7.0, 7.03, 50.02})
        averages.see(sample_of(time, {{time, 0.5, 1.0, 0.0}}), {});
    const CellSums sums = averages.sums();
    CHECK(sums.time == doctest::Approx(3.2).epsilon(0.5 / 32.0 + 1e-9));
    CHECK(sums.particles.sum() == doctest::Approx(sums.time));
    CHECK(sums.particles.head(46).sum() == 0.0);
    CHECK(sums.particles[48] == doctest::Approx(1.0));
    CHECK(sums.particles[50] == doctest::Approx(0.02));
}

// A twin that knows nothing of residence: sums over samples of a fine grid of times.
TEST_CASE("averages over a gas are those over many samples") {
    for (const double gravity : {0.0, -1.5}) {
        CAPTURE(gravity);
        const Gas gas = gas_of(12, gravity);
        Run run;
        run.until = 2.0;
        Simulation simulation(gas, run);
        simulation.record_collisions(true);
        Simulation twin = simulation;
        const Cells cells = square_cells(gas.box, 4);
        std::vector<bool> members(24, true);
        members[5] = false;
        CellAverages averages(gas.box, simulation.particles(), cells,
                              {.members = members, .temperature = true}, {});
        CellAverages moments(gas.box, simulation.particles(), cells,
                             {.members = members, .window = 0.0, .temperature = true}, {});
        for (const double time : {0.0, 0.3, 1.1, 2.0}) {
            const AdvanceResult advanced = simulation.advance_to(time);
            averages.see(simulation.sample(), advanced.collisions);
        }
        constexpr int steps = 8000;
        CellSums slow = moments.sums();
        for (int k = 0; k < steps; ++k) {
            twin.advance_to(2.0 * (k + 0.5) / steps);
            moments.see(twin.sample(), {});
            const CellSums now = moments.sums();
            if (k == 0) {
                slow = now;
                continue;
            }
            slow.particles += now.particles;
            slow.speed += now.speed;
            slow.velocity += now.velocity;
            slow.thermal_energy += now.thermal_energy;
            slow.thermal_freedom += now.thermal_freedom;
        }
        const CellSums sums = averages.sums();
        CHECK(sums.time == doctest::Approx(2.0).epsilon(1e-12));
        CHECK(sums.particles.sum() == doctest::Approx(2.0 * 23));
        const double part = 2.0 / steps;
        CHECK((sums.particles - slow.particles * part).abs().maxCoeff() < 0.003);
        CHECK((sums.speed - slow.speed * part).abs().maxCoeff() < 0.01);
        CHECK((sums.velocity - slow.velocity * part).abs().maxCoeff() < 0.01);
        CHECK((sums.thermal_freedom - slow.thermal_freedom * part).abs().maxCoeff() < 0.005);
        CHECK((sums.thermal_energy - slow.thermal_energy * part).abs().maxCoeff() < 0.05);
    }
}
