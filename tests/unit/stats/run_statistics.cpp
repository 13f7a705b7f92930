// The statistics of a run against sums that a reader can do in the head.
#include "stats/run_statistics.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "physics/exact_positions.h"
#include "physics/mechanics.h"
#include "physics/placement/overlap.h"
#include "physics/theory/equation_of_state.h"
#include "stats/paths/time_averages.h"
#include "stats/pressure.h"
#include "support/relative.h"
#include "util/random.h"

using namespace carom;
using test::relative;

namespace {

Box box_of(double width, double height, Wall across = Wall::solid, Wall up = Wall::solid) {
    Box box;
    box.size = {width, height};
    box.walls = {across, up};
    return box;
}

Box line_of(double length, Wall wall = Wall::solid) {
    Box box = box_of(length, 0.0, wall);
    box.dimension = 1;
    return box;
}

struct Body {
    double x, y, vx, vy, radius = 0.5, mass = 1.0;
    int species = 0;
};

Particles particles_of(const std::vector<Body>& bodies) {
    Particles particles;
    const auto count = static_cast<Eigen::Index>(bodies.size());
    particles.radius.resize(count);
    particles.inverse_mass.resize(count);
    particles.species.resize(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const Body& body = bodies[static_cast<std::size_t>(i)];
        particles.radius[i] = body.radius;
        particles.inverse_mass[i] = 1.0 / body.mass;
        particles.species[i] = body.species;
    }
    return particles;
}

Sample sample_of(const std::vector<Body>& bodies, int dimension = 2, double time = 0.0) {
    Sample sample;
    sample.time = time;
    const auto count = static_cast<Eigen::Index>(bodies.size());
    sample.position.resize(count, dimension);
    sample.velocity.resize(count, dimension);
    for (Eigen::Index i = 0; i < count; ++i) {
        const Body& body = bodies[static_cast<std::size_t>(i)];
        sample.position(i, 0) = body.x;
        sample.velocity(i, 0) = body.vx;
        if (dimension == 1) continue;
        sample.position(i, 1) = body.y;
        sample.velocity(i, 1) = body.vy;
    }
    return sample;
}

constexpr double infinite = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("masses come back as they were given") {
    std::vector<Body> bodies;
    std::vector<double> given{1.0, 3.0, 49.0, 0.1, 1836.15, 1e-12, 1e12, infinite, 103.0};
    for (int i = 1; i < 500; ++i) given.push_back(i / 10.0);
    for (const double mass : given) bodies.push_back({0, 0, 0, 0, 0.5, mass});
    const Eigen::ArrayXd found = masses(particles_of(bodies));
    for (std::size_t i = 0; i < given.size(); ++i)
        CHECK(found[static_cast<Eigen::Index>(i)] == given[i]);
}

TEST_CASE("momentum counts resting immovable particles as nothing, moving ones as infinite") {
    std::vector<Body> bodies{{1, 1, 2, -1, 0.5, 3.0}, {5, 5, -1, 0, 0.5, 2.0}};
    bodies.push_back({8, 8, 0, 0, 0.5, infinite});
    CHECK((momentum(particles_of(bodies), sample_of(bodies)) == Eigen::Array2d(4, -3)).all());
    CHECK(!infinite_mass_moves(particles_of(bodies), sample_of(bodies)));
    bodies[2].vy = -1.0;
    CHECK(momentum(particles_of(bodies), sample_of(bodies))[0] == 4.0);
    CHECK(momentum(particles_of(bodies), sample_of(bodies))[1] == -infinite);
    CHECK(infinite_mass_moves(particles_of(bodies), sample_of(bodies)));
}

TEST_CASE("a drift is no heat where nothing can stop it") {
    // Centre-of-mass velocity (2, 1); relative to it (1, 0) and (-3, 0): 3/2 + 9/2 = 6.
    std::vector<Body> bodies{{1, 1, 3, 1, 0.5, 3.0}, {5, 5, -1, 1, 0.5, 1.0}};
    const Particles particles = particles_of(bodies);
    const Sample sample = sample_of(bodies);
    const double drift_x = 0.5 * 4.0 * 4.0, drift_y = 0.5 * 4.0 * 1.0;
    const auto energy = [&](Wall across, Wall up) {
        return thermal_motion(box_of(9, 9, across, up), particles, sample).energy;
    };
    CHECK(energy(Wall::periodic, Wall::periodic) == relative(6.0, 1e-14));
    CHECK(energy(Wall::solid, Wall::periodic) == relative(6.0 + drift_x, 1e-14));
    CHECK(energy(Wall::periodic, Wall::solid) == relative(6.0 + drift_y, 1e-14));
    CHECK(energy(Wall::solid, Wall::solid) == relative(6.0 + drift_x + drift_y, 1e-14));
    bodies.push_back({8, 8, 0, 0, 0.5, infinite});  // it can
    CHECK(thermal_motion(box_of(9, 9, Wall::periodic, Wall::periodic), particles_of(bodies),
                         sample_of(bodies))
              .energy == relative(6.0 + drift_x + drift_y, 1e-14));
    CHECK(ThermalMotion{6.0, 4.0}.temperature() == 3.0);
    CHECK(ThermalMotion{6.0, 2.0}.temperature() == 6.0);
}

TEST_CASE("a conserved momentum takes up one degree of freedom along its axis") {
    std::vector<Body> bodies{
        {1, 1, 3, 1, 0.5, 3.0}, {5, 5, -1, 1, 0.5, 1.0}, {3, 3, 0, 0, 0.5, 4.0, 1}};
    const auto freedom = [&](const Box& box, const std::vector<Eigen::Index>& members) {
        return thermal_motion(box, particles_of(bodies), sample_of(bodies, box.dimension), members)
            .degrees_of_freedom;
    };
    const Box solid = box_of(9, 9), tube = box_of(9, 9, Wall::periodic),
              around = box_of(9, 9, Wall::periodic, Wall::periodic);
    CHECK(freedom(solid, {0, 1, 2}) == 6.0);
    CHECK(freedom(tube, {0, 1, 2}) == 5.0);
    CHECK(freedom(around, {0, 1, 2}) == 4.0);
    CHECK(freedom(line_of(9), {0, 1, 2}) == 3.0);
    CHECK(freedom(line_of(9, Wall::periodic), {0, 1, 2}) == 2.0);
    // A part of the gas has its share of the drift: 1 - m / M for each particle.
    CHECK(freedom(around, {0, 1}) == 2.0 * (2.0 - 4.0 / 8.0));
    CHECK(freedom(around, {2}) == 2.0 * (1.0 - 4.0 / 8.0));
    bodies.push_back({8, 8, 0, 0, 0.5, infinite, 2});  // it stops a drift
    CHECK(freedom(around, {0, 1, 2}) == 6.0);
    CHECK(freedom(around, {2, 3}) == 2.0);
    CHECK(std::isnan(
        thermal_motion(around, particles_of(bodies), sample_of(bodies), {3}).temperature()));
}

TEST_CASE("the temperature of a run is that of theory's collision rate and of each species") {
    // Momentum is conserved, so that N disks share their energy as N - 1 do.
    const std::vector<Body> bodies{{1, 1, 2, 1, 0.5, 1.0}, {5, 5, -2, -1, 0.5, 1.0}};
    const Box around = box_of(9, 9, Wall::periodic, Wall::periodic);
    const Particles particles = particles_of(bodies);
    RunStatistics statistics(around, particles, 1, 1);
    statistics.see(sample_of(bodies));
    CHECK(statistics.summary({}).temperature == 2.0 * 5.0 / 2.0);
    // In equilibrium a heavy species and a light one have the gas's temperature, each in its mean.
    const std::vector<double> mass{1.0, 1.0, 4.0, 10.0};
    std::vector<Body> mixture;
    for (const double m : mass) mixture.push_back({1, 1, 0, 0, 0.5, m, m > 2.0});
    Random random(5, "velocities");
    std::array<double, 3> sums{};
    constexpr int draws = 40'000;
    for (int k = 0; k < draws; ++k) {
        double px = 0.0, py = 0.0;
        for (Body& body : mixture) {
            body.vx = random.normal() / std::sqrt(body.mass);
            body.vy = random.normal() / std::sqrt(body.mass);
            px += body.mass * body.vx / 16.0;
            py += body.mass * body.vy / 16.0;
        }
        for (Body& body : mixture) {
            body.vx -= px;
            body.vy -= py;
        }
        const std::vector<std::vector<Eigen::Index>> parts{{0, 1, 2, 3}, {0, 1}, {2, 3}};
        for (std::size_t p = 0; p < parts.size(); ++p)
            sums[p] += thermal_motion(around, particles_of(mixture), sample_of(mixture), parts[p])
                           .temperature();
    }
    // T = 1; the mean of 40,000 draws of two degrees of freedom or more is known to 0.5 %.
    for (const double sum : sums) CHECK(sum / draws == relative(1.0, 0.02));
}

TEST_CASE("pressure on the walls is momentum for each time and length of those that are solid") {
    ImpulseTotals impulses;
    impulses.wall = {6.0, 10.0, 3.0, 5.0};
    CHECK(wall_pressure(box_of(4, 2), impulses, 2.0) == 24.0 / (2.0 * 12.0));
    CHECK(wall_pressure(box_of(4, 2, Wall::periodic), impulses, 2.0) == 8.0 / (2.0 * 8.0));
    CHECK(wall_pressure(box_of(4, 2, Wall::solid, Wall::periodic), impulses, 2.0) ==
          16.0 / (2.0 * 4.0));
    CHECK(!wall_pressure(box_of(4, 2, Wall::periodic, Wall::periodic), impulses, 2.0));
    CHECK(wall_pressure(line_of(4), impulses, 2.0) == 4.0);  // (6 + 10) / 2 walls / 2
    CHECK(!wall_pressure(line_of(4, Wall::periodic), impulses, 2.0));
    impulses.wall[1] = infinite;
    CHECK(!wall_pressure(box_of(4, 2), impulses, 2.0));
}

TEST_CASE("the pressure of points is that of an ideal gas in the whole box") {
    CHECK(pressure_of_points(box_of(6, 4), 5.0) == relative(5.0 / 24.0, 1e-14));
    CHECK(pressure_of_points(line_of(6), 5.0) == relative(10.0 / 6.0, 1e-14));
}

TEST_CASE("pressure by the virial is that of an ideal gas and what collisions add") {
    const std::vector<Body> bodies{{1, 1, 0, 0, 0.5}, {3, 3, 0, 0, 0.5}, {2, 2, 0, 0, 9, infinite}};
    const Particles particles = particles_of(bodies);
    ImpulseTotals impulses;
    impulses.virial = 12.0;
    const Box around = box_of(6, 4, Wall::periodic, Wall::periodic);
    // P A = N T + W / 2t = 5 + 2
    CHECK(*virial_pressure(around, particles, 5.0, impulses, 3.0) == relative(7.0 / 24.0, 1e-14));
    // Between walls A is (6 * 3 + 4 * 5) / 2 for disks of radius 1/2
    CHECK(*virial_pressure(box_of(6, 4), particles, 5.0, impulses, 3.0) ==
          relative(7.0 / 19.0, 1e-14));
    // P L = 2K + W / t = 10 + 4
    CHECK(*virial_pressure(line_of(6, Wall::periodic), particles, 5.0, impulses, 3.0) ==
          relative(14.0 / 6.0, 1e-14));
    CHECK(*virial_pressure(line_of(6), particles, 5.0, impulses, 3.0) ==
          relative(14.0 / 5.0, 1e-14));
    CHECK(
        !virial_pressure(around, particles_of({{1, 1, 0, 0, 0.5, infinite}}), 0.0, impulses, 3.0));
}

TEST_CASE("the deepest overlap is found, across periodic borders too") {
    const Box solid = box_of(10, 8);
    const Box around = box_of(10, 8, Wall::periodic, Wall::periodic);
    std::vector<Body> bodies{{1, 4, 0, 0, 1.0}, {3.5, 4, 0, 0, 1.0}, {9.5, 4, 0, 0, 0.5}};
    const auto depth = [&](const Box& box) {
        return largest_relative_overlap(box, particles_of(bodies),
                                        sample_of(bodies, box.dimension));
    };
    CHECK(depth(solid) == 0.0);
    CHECK(depth(around) == 0.0);  // 0 and 2 touch: 1.5 apart around the border
    bodies[2].x = 9.8;
    CHECK(depth(solid) == 0.0);
    CHECK(depth(around) == relative(0.3 / 1.5, 1e-14));
    bodies[1].x = 2.9;
    CHECK(depth(solid) == relative(0.1 / 2.0, 1e-14));
    CHECK(depth(around) == relative(0.3 / 1.5, 1e-14));
    // On a line the same; what counts are neighbours.
    CHECK(depth(line_of(10)) == relative(0.1 / 2.0, 1e-14));
    CHECK(depth(line_of(10, Wall::periodic)) == relative(0.3 / 1.5, 1e-14));
    for (Body& body : bodies) body.radius = 0.0;
    bodies[1].x = bodies[0].x;
    CHECK(depth(line_of(10)) == 0.0);
    CHECK(largest_relative_overlap(solid, particles_of({}), sample_of({})) == 0.0);
}

TEST_CASE("the deepest overlap is that which a look at all pairs finds") {
    Random random(5, "disks");
    for (int round = 0; round < 20; ++round) {
        std::vector<Body> bodies;
        for (int i = 0; i < 60; ++i)
            bodies.push_back({random.uniform(0, 10), random.uniform(0, 8), 0, 0,
                              i == 0 ? 2.0 : random.uniform(0.01, 0.8)});
        double deepest = 0.0;
        for (const Body& a : bodies)
            for (const Body& b : bodies) {
                if (&a == &b) continue;
                const double dx = std::remainder(a.x - b.x, 10.0);
                const double distance = std::hypot(dx, a.y - b.y);
                deepest = std::max(deepest, 1.0 - distance / (a.radius + b.radius));
            }
        CHECK(largest_relative_overlap(box_of(10, 8, Wall::periodic), particles_of(bodies),
                                       sample_of(bodies)) == relative(deepest, 1e-14));
    }
}

TEST_CASE("the distance from home is that of the nearest image") {
    const Sample start = sample_of({{1, 1, 0, 0}, {5, 5, 0, 0}});
    const Sample end = sample_of({{9, 1, 0, 0}, {5, 7, 0, 0}});
    const ReturnDistance solid = return_distance(box_of(10, 8), start, end);
    CHECK(solid.largest == 8.0);
    CHECK(solid.root_mean_square == relative(std::sqrt((64.0 + 4.0) / 2.0), 1e-14));
    const ReturnDistance around = return_distance(box_of(10, 8, Wall::periodic), start, end);
    CHECK(around.largest == 2.0);
    CHECK(around.root_mean_square == relative(2.0, 1e-14));
    CHECK(return_distance(box_of(10, 8), sample_of({}), sample_of({})).largest == 0.0);
}

TEST_CASE("means are over particles and samples, the energy's error is the largest on the way") {
    std::vector<Body> bodies{
        {1, 1, 3, 4, 0.5, 2.0, 0}, {5, 5, 0, 0, 0.5, 2.0, 0}, {8, 1, 1, 0, 0.5, 1.0, 1}};
    const Particles particles = particles_of(bodies);
    RunStatistics statistics(box_of(10, 8), particles, 2, 3);
    statistics.see(sample_of(bodies));  // energies 25, 0, 1/2
    bodies[2].vx = 2.0;                 // 2
    statistics.see(sample_of(bodies, 2, 1.0));
    bodies[2].vx = -1.0;
    statistics.see(sample_of(bodies, 2, 2.0));
    const RunSummary summary = statistics.summary({});
    CHECK(summary.energy_initial == 25.5);
    CHECK(summary.energy_final == 25.5);
    CHECK(*summary.largest_energy_error == relative(1.5 / 25.5, 1e-14));
    CHECK(summary.momentum_initial[0] == 7.0);
    CHECK(summary.momentum_final[0] == 5.0);
    CHECK(summary.momentum_final[1] == 8.0);
    REQUIRE(summary.species.size() == 2);
    CHECK(summary.species[0].count == 2);
    CHECK(summary.species[0].energy == 12.5);
    CHECK(summary.species[0].speed == 2.5);
    CHECK(*summary.species[1].energy == relative(1.0, 1e-14));
    CHECK(*summary.species[1].speed == relative(4.0 / 3.0, 1e-14));
    CHECK(*summary.temperature == relative((3 * 25.0 + 0.5 + 2.0 + 0.5) / 9.0, 1e-14));
    CHECK(summary.wall_pressure == 0.0);
    CHECK(summary.speeds.counts.size() + 1 == summary.speeds.edges.size());
}

TEST_CASE("a gas at rest has no energy, no error and no temperature above 0") {
    const std::vector<Body> bodies{{1, 1, 0, 0}, {5, 5, 0, 0, 0.5, infinite}};
    const Particles particles = particles_of(bodies);
    RunStatistics statistics(box_of(10, 8), particles, 1, 2);
    statistics.see(sample_of(bodies));
    statistics.see(sample_of(bodies, 2, 1.0));
    const RunSummary summary = statistics.summary({});
    CHECK(summary.energy_initial == 0.0);
    CHECK(summary.largest_energy_error == 0.0);
    CHECK(summary.temperature == 0.0);
    CHECK(summary.virial_pressure == 0.0);
    CHECK(summary.momentum_initial[0] == 0.0);
    CHECK(summary.species[0].energy == 0.0);
}

TEST_CASE("what a moving infinite mass makes meaningless is absent, the rest is not") {
    std::vector<Body> bodies{{1, 1, 2, 0}, {5, 5, 1, 0, 0.5, infinite, 1}};
    const Particles particles = particles_of(bodies);
    RunStatistics statistics(box_of(10, 8), particles, 2, 2);
    statistics.see(sample_of(bodies));
    statistics.see(sample_of(bodies, 2, 1.0));
    const RunSummary summary = statistics.summary({});
    CHECK(!summary.energy_initial);
    CHECK(!summary.energy_final);
    CHECK(!summary.largest_energy_error);
    CHECK(!summary.momentum_initial[0]);
    CHECK(summary.momentum_initial[1] == 0.0);
    CHECK(!summary.virial_pressure);
    CHECK(summary.temperature == 2.0);  // of the one that can be hot
    CHECK(summary.species[0].energy == 2.0);
    CHECK(!summary.species[1].energy);
    CHECK(summary.species[1].speed == 1.0);
    CHECK(summary.energies.counts.back() == 2);
}

TEST_CASE("no particles are a gas too") {
    const Particles particles = particles_of({});
    RunStatistics statistics(box_of(10, 8), particles, 0, 1);
    statistics.see(sample_of({}));
    const RunSummary summary = statistics.summary({});
    CHECK(summary.energy_initial == 0.0);
    CHECK(summary.largest_energy_error == 0.0);
    CHECK(!summary.temperature);
    CHECK(!summary.virial_pressure);
    CHECK(summary.largest_overlap == 0.0);
    CHECK(summary.speeds.counts == std::vector<std::int64_t>{0});
}

TEST_CASE("the overlap is the deepest at a collision or in a sample") {
    const std::vector<Body> bodies{{1, 1, 0, 0}, {1.9, 1, 0, 0}};
    const Particles particles = particles_of(bodies);
    RunStatistics statistics(box_of(10, 8), particles, 1, 1);
    statistics.see(sample_of(bodies));
    AdvanceResult advanced;
    CHECK(statistics.summary(advanced).largest_overlap == relative(0.1, 1e-14));
    advanced.impulses.largest_overlap = 0.25;
    CHECK(statistics.summary(advanced).largest_overlap == 0.25);
}

TEST_CASE("samples given by their changes have the very statistics of whole samples") {
    // With walls, in a periodic box, and in one whose gas drifts as a whole.
    for (const auto& gas :
         {std::pair{Wall::solid, 0.0}, {Wall::periodic, 0.1}, {Wall::periodic, 10.0}}) {
        const Wall wall = gas.first;
        const double drift = gas.second;
        CAPTURE(drift);
        Random random(4, "velocities");
        std::vector<Body> bodies;
        for (int k = 0; k < 60; ++k)
            bodies.push_back({1.0 + 2.0 * (k % 10), 1.0 + 2.0 * (k / 10), drift + random.normal(),
                              random.normal(), 0.5, k % 3 + 0.7, k % 2});
        const Box box = box_of(20, 20, wall, wall);
        const Particles particles = particles_of(bodies);
        RunStatistics whole(box, particles, 2, 40), changed(box, particles, 2, 40);
        int seen_by_changes = 0;
        for (int k = 0; k < 40; ++k) {
            std::vector<VelocityChange> changes;
            for (std::int32_t i = k % 7; k > 0 && i < 60; i += 13) {
                Body& body = bodies[static_cast<std::size_t>(i)];
                VelocityChange& change =
                    changes.emplace_back(VelocityChange{i, {body.vx, body.vy}, {0.0, 0.0}});
                const double growth = k < 20 ? 1.0 : 40.0;  // histograms must grow on the way
                body.vx = drift + growth * random.normal();
                body.vy = growth * random.normal();
                change.after = {body.vx, body.vy};
            }
            const Sample sample = sample_of(bodies, 2, k);
            whole.see(sample);
            changed.see_positions({sample.time, sample.position, {}}, {});
            if (k != 25 && changed.see_changes({.time = double(k)}, changes, {}))
                ++seen_by_changes;
            else
                changed.see_velocities({sample.time, {}, sample.velocity}, {}, k != 25);
        }
        CHECK((drift > 1.0 || seen_by_changes > 30));
        const RunSummary a = whole.summary({}), b = changed.summary({});
        CHECK(a.energy_final == b.energy_final);
        CHECK(a.largest_energy_error == b.largest_energy_error);
        CHECK(a.momentum_final == b.momentum_final);
        CHECK(a.temperature == b.temperature);
        CHECK(a.speeds.edges == b.speeds.edges);
        CHECK(a.speeds.counts == b.speeds.counts);
        CHECK(a.energies.edges == b.energies.edges);
        CHECK(a.energies.counts == b.energies.counts);
        for (std::size_t s = 0; s < 2; ++s) {
            CHECK(a.species[s].energy == b.species[s].energy);
            CHECK(a.species[s].speed == b.species[s].speed);
        }
        const double thermal = thermal_motion(box, particles, sample_of(bodies)).temperature();
        RunStatistics last(box, particles, 2, 1);
        last.see(sample_of(bodies));
        CHECK(*last.summary({}).temperature == relative(thermal, 1e-14));
    }
}

TEST_CASE("means by species are over the particles that belong to it in each sample") {
    const std::vector<Body> bodies{
        {1, 1, 3, 4, 0.5, 2.0, 0}, {5, 5, 0, 2, 0.5, 2.0, 0}, {8, 1, 1, 0, 0.5, 1.0, 1}};
    const Particles particles = particles_of(bodies);  // energies 25, 4, 1/2
    Membership its = *membership_at_start(particles);
    its.species[1] = 1;
    const auto moved = std::make_shared<const Membership>(its);
    its.is_present[0] = false;
    const auto gone = std::make_shared<const Membership>(its);
    RunStatistics statistics(box_of(10, 8), particles, 2, 3);
    for (int k = 0; k < 3; ++k) {
        Sample sample = sample_of(bodies, 2, k);
        if (k > 0) sample.membership = k == 1 ? moved : gone;
        statistics.see_positions(sample, {});
        CHECK(!statistics.see_changes(sample, {}, {}));  // the first, then two that differ
        statistics.see_velocities(sample, {}, true);
    }
    const RunSummary summary = statistics.summary({});
    CHECK(summary.species[0].count == 2);
    CHECK(*summary.species[0].energy == relative((25.0 + 4.0 + 25.0) / 3.0, 1e-14));
    CHECK(*summary.species[0].speed == relative((5.0 + 2.0 + 5.0) / 3.0, 1e-14));
    CHECK(*summary.species[1].energy == relative((0.5 + 4.5 + 4.5) / 5.0, 1e-14));
    CHECK(summary.energy_final == 4.5);
    CHECK(*summary.temperature == relative((29.5 + 29.5 + 4.5) / (6.0 + 6.0 + 4.0) * 2.0, 1e-14));
    CHECK(thermal_motion(box_of(9, 9, Wall::periodic), particles,
                         {0.0, {}, sample_of(bodies).velocity, gone})
              .degrees_of_freedom == 3.0);
}

TEST_CASE("averages over time count a particle for what it is at each time") {
    // One flies at speed 1, the other at 2 and is of the second species from time 1 to 3, then
    // absent until the end at 4.
    const std::vector<Body> bodies{{1, 1, 1, 0}, {1, 5, 2, 0}};
    const Particles particles = particles_of(bodies);
    Membership its = *membership_at_start(particles);
    its.species[1] = 1;
    const auto moved = std::make_shared<const Membership>(its);
    its.is_present[1] = false;
    const auto gone = std::make_shared<const Membership>(its);
    TimeAverages averages(box_of(20, 8), particles, 2, {});
    for (int k = 0; k < 5; ++k) {
        Sample sample = sample_of(bodies, 2, k);
        sample.position.col(0) += k * sample.velocity.col(0);
        if (k > 0) sample.membership = k < 3 ? moved : gone;
        averages.see(sample, {});
    }
    const TimeAverages::Values means = averages.averages();
    CHECK(means.speed[0] == relative((4.0 * 1.0 + 1.0 * 2.0) / 5.0, 1e-14));
    CHECK(means.energy[0] == relative((4.0 * 0.5 + 1.0 * 2.0) / 5.0, 1e-14));
    CHECK(means.speed[1] == relative(2.0, 1e-14));
    CHECK(means.temperature ==
          relative((4.0 * 0.5 + 3.0 * 2.0) * 2.0 / (4.0 * 2.0 + 3.0 * 2.0), 1e-14));
}
