// Walls that reflect diffusely, against what is known of them. Chance fails one comparison of a
// distribution in a million, and one mean in two million.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "physics/gas.h"
#include "physics/simulation.h"
#include "support/blocks.h"
#include "support/goodness_of_fit.h"

using namespace carom;

namespace {

constexpr double width = 10.0, height = 6.0, radius = 0.5, speed = 1.3;
// Of the part of the box that the centre can reach.
constexpr double area = (width - 2.0 * radius) * (height - 2.0 * radius),
                 perimeter = 2.0 * (width + height - 4.0 * radius);
// Between hits, by Cauchy's mean chord.
constexpr double mean_time = std::numbers::pi * area / (perimeter * speed);

Gas alone_in_diffuse_box() {
    Gas gas;
    gas.box.size = {width, height};
    gas.box.surfaces.sides.fill(Diffuse{});
    gas.species = {
        {.name = "disk", .count = 1, .radius = radius, .mass = 2.0, .velocity = Speed{speed}}};
    return gas;
}

double uniform(double share) { return share; }

// The component along the wall of the velocity behind a hit, in units of the speed.
double sine_behind(const Collision& hit) {
    const Vec& v = hit.first_after;
    switch (hit.second.surface()) {
        case 0:
            return -v[1] / speed;
        case 1:
            return v[1] / speed;
        case 2:
            return v[0] / speed;
        default:
            return -v[0] / speed;
    }
}

}  // namespace

TEST_CASE("a disk leaves a diffuse wall at its own speed, at angles of cos / 2, at any hit anew") {
    Simulation simulation(alone_in_diffuse_box(), {});
    simulation.record_collisions(true);
    std::vector<double> sines, shares, times;
    double last = 0.0, least = speed, most = speed;
    constexpr std::size_t hits = 100'000, in_block = 1'000;
    for (double time = 100.0; sines.size() < hits; time += 100.0)
        for (const Collision& hit : simulation.advance_to(time).collisions) {
            const double now = length(hit.first_after);
            least = std::min(least, now);
            most = std::max(most, now);
            sines.push_back(sine_behind(hit));
            shares.push_back(0.5 * (1.0 + sines.back()));
            if (sines.size() % in_block != 0) continue;
            times.push_back((hit.time - last) / in_block);
            last = hit.time;
        }
    CHECK(most - least < 1e-12 * speed);
    CHECK(test::chance(shares, uniform) > 1e-6);
    std::vector<double> angles;
    for (const double sine : sines) angles.push_back(std::asin(sine));
    CHECK(test::chance(angles, [](double angle) { return 0.5 * (1.0 + std::sin(angle)); }) > 1e-6);
    CHECK(std::abs(test::correlation_with_next(sines)) <
          5.0 / std::sqrt(static_cast<double>(sines.size())));
    test::check_mean(times, mean_time, 0.005);
}

TEST_CASE("in many bits the speed is kept in all of them") {
    Run run;
    run.bits = 192;
    Simulation simulation(alone_in_diffuse_box(), run);
    const double before = simulation.energy_account().in_all();
    const auto hits = simulation.advance_to(4'000.0).counts.wall;
    CHECK(hits > 900);
    CHECK(std::abs(simulation.energy_account().in_all() / before - 1.0) < 4e-16);
    CHECK(simulation.energy_account().heat == 0.0);
}

TEST_CASE("a disk in a diffuse box is anywhere in it and moves in any direction") {
    Simulation simulation(alone_in_diffuse_box(), {});
    std::vector<double> across, up, turns;
    for (int k = 1; k <= 20'000; ++k) {
        simulation.advance_to(40.0 * k);  // some ten hits later
        const Sample& now = simulation.sample();
        across.push_back((now.position(0, 0) - radius) / (width - 2.0 * radius));
        up.push_back((now.position(0, 1) - radius) / (height - 2.0 * radius));
        const double angle = std::atan2(now.velocity(0, 1), now.velocity(0, 0));
        turns.push_back(0.5 + 0.5 * angle / std::numbers::pi);
    }
    CHECK(test::chance(across, uniform) > 1e-6);
    CHECK(test::chance(up, uniform) > 1e-6);
    CHECK(test::chance(turns, uniform) > 1e-6);
}

// Through the gap of a partition that is diffuse itself, whose ends are corners.
TEST_CASE("a point among diffuse surfaces is on each side of a partition by its area") {
    constexpr double at = 4.0;
    Gas gas = alone_in_diffuse_box();
    gas.species[0].radius = 0.1;
    gas.box.surfaces.partitions = {
        {.name = "line", .at = at, .gaps = {{2.0, 4.0}}, .behaviour = Diffuse{}}};
    Simulation simulation(gas, {});
    const double before = simulation.energy_account().in_all();
    std::vector<double> shares;
    double time = 0.0;
    for (int block = 0; block < 40; ++block) {
        double left = 0.0;
        constexpr int samples = 4'000;
        for (int k = 0; k < samples; ++k) {
            simulation.advance_to(time += 10.0);
            left += simulation.sample().position(0, 0) < at ? 1.0 / samples : 0.0;
        }
        shares.push_back(left);
    }
    // What the centre can reach beyond the partition and its rounded ends, on both sides alike, is
    // missing from both.
    const double r = 0.1, taken = r * (height - 2.0 * r - 2.0) + 0.5 * std::numbers::pi * r * r;
    const double left = (at - r) * (height - 2.0 * r) - taken,
                 right = (width - at - r) * (height - 2.0 * r) - taken;
    test::check_mean(shares, left / (left + right), 0.02);
    CHECK(std::abs(simulation.energy_account().in_all() / before - 1.0) < 1e-12);
}

// All share the energy, which is constant: each degree of freedom has the same part of it.
TEST_CASE("a gas of two species between diffuse walls comes to equipartition") {
    constexpr int light = 16, heavy = 4;
    Gas gas;
    gas.box.size = {8.0, 8.0};
    gas.box.surfaces.sides.fill(Diffuse{});
    gas.species = {{.name = "light", .count = light, .radius = 0.3, .velocity = Speed{2.0}},
                   {.name = "heavy", .count = heavy, .radius = 0.6, .mass = 9.0}};
    Run run;
    run.equilibrate = 100.0;
    Simulation simulation(gas, run);
    const double energy = 0.5 * light * 2.0 * 2.0;
    std::vector<double> means;
    double time = 0.0;
    for (int block = 0; block < 40; ++block) {
        double mean = 0.0;
        constexpr int samples = 400;
        for (int k = 0; k < samples; ++k) {
            simulation.advance_to(time += 2.0);
            const Sample& now = simulation.sample();
            for (Eigen::Index i = light; i < light + heavy; ++i)
                mean += 4.5 * now.velocity.row(i).square().sum() / (heavy * samples);
        }
        means.push_back(mean);
    }
    test::check_mean(means, energy / (light + heavy), 0.03);
    const EnergyAccount end = simulation.energy_account();
    CHECK(std::abs(end.in_all() / energy - 1.0) < 1e-12);
    CHECK(end.heat == 0.0);
    CHECK(end.work == 0.0);
}
