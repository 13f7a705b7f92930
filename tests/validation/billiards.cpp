// Validation of billiards: points that move among fixed bodies.
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "physics/gas.h"
#include "physics/sampling/directions.h"
#include "physics/simulation.h"
#include "stats/displacements.h"
#include "support/bodies.h"
#include "support/space.h"
#include "util/random.h"
#include "validation/study.h"

namespace carom::validation {

namespace {

using std::numbers::pi;
constexpr const char* billiards_field = "Billiards and the Lorentz gas";

/// The mean free path of a point of speed 1 between hits, started in a random direction.
double mean_path(const Box& box, const Vec& place, const RunOf& run) {
    Random random(run.seed, "direction of a point");
    Vec direction;
    if (box.dimension == 3) {
        direction = random_direction(random);
    } else {
        const double angle = random.uniform(0.0, 2.0 * pi);
        direction = {std::cos(angle), std::sin(angle)};
    }
    Simulation simulation = test::simulation_of_bodies(box, {{place, direction, 0.0, 1.0}});
    const double time = 200'000.0 * run.effort;
    simulation.advance_to(time);
    double hits = 0.0;
    for (const SurfaceState& surface : simulation.surfaces())
        hits += static_cast<double>(surface.hits);
    return time / hits;
}

Study sinai(int dimension) {
    constexpr double length = 3.0, radius = 0.8;
    Study study;
    study.field = billiards_field;
    study.runs = 24;
    const double room = std::pow(length, dimension) - content_of_ball(radius, dimension);
    study.truths = {
        {dimension == 2
             ? "mean free path of Sinai’s billiard, *L* = 3, *R* = 0.8"
             : "mean free path among fixed spheres in a cubic lattice, *L* = 3, *R* = 0.8",
         room / content_of_ball(radius, dimension - 1), 0.0, 0.0,
         dimension == 2 ? "exact: (*L*² − π*R*²)/2*R*; N. Chernov, J. Stat. Phys. 88, 1 (1997)"
                        : "exact: (*L*³ − (4/3)π*R*³)/π*R*²; the same"}};
    study.measure = [=](const RunOf& run) {
        Box box = test::box_of(dimension, {length, length, length});
        box.walls = {Wall::periodic, Wall::periodic, Wall::periodic};
        box.surfaces.obstacles = {
            {"ball", Obstacle::Ball{{1.5, 1.5, dimension == 2 ? 0.0 : 1.5}, radius}}};
        return std::vector<double>{mean_path(box, {0.1, 0.2, dimension == 2 ? 0.0 : 0.3}, run)};
    };
    return study;
}

Study any_billiard() {
    Study study;
    study.field = billiards_field;
    study.runs = 24;
    const double area = 12.0 - 1.0 - pi * 0.09;
    const double perimeter = 14.0 + 2.0 + 2.0 * std::numbers::sqrt2 + pi * 0.6;
    study.truths = {{"mean free path in a box with a wedge and a round peg", pi * area / perimeter,
                     0.0, 0.0, "exact: π area/perimeter; N. Chernov, J. Stat. Phys. 88, 1 (1997)"}};
    study.measure = [=](const RunOf& run) {
        Box box{.dimension = 2, .size = {4.0, 3.0}};
        box.surfaces.obstacles = {
            {"wedge", Obstacle::Lines{{{1.0, 1.0}, {3.0, 1.0}, {2.0, 2.0}}, true}},
            {"peg", Obstacle::Ball{{0.8, 2.2}, 0.3}}};
        return std::vector<double>{mean_path(box, {0.5, 0.5}, run)};
    };
    return study;
}

Study any_billiard_in_space() {
    Study study;
    study.field = billiards_field;
    study.runs = 24;
    const double volume = 4.0 * 3.0 * 2.5 - 2.0 - content_of_ball(0.5, 3);
    const double surface = 2.0 * (12.0 + 10.0 + 7.5) + 2.0 * (2.0 + 2.0 + 1.0) + pi;
    study.truths = {{"mean free path in a box with a cuboid and a sphere", 4.0 * volume / surface,
                     0.0, 0.0, "exact: 4 volume/surface; the same"}};
    study.measure = [=](const RunOf& run) {
        Box box = test::space_of({4.0, 3.0, 2.5});
        box.surfaces.obstacles = {{"block", Obstacle::Cuboid{{1.0, 0.7, 0.6}, {3.0, 1.7, 1.6}}},
                                  {"ball", Obstacle::Ball{{0.8, 2.3, 1.8}, 0.5}}};
        return std::vector<double>{mean_path(box, {0.5, 0.5, 0.5}, run)};
    };
    return study;
}

/// The cosine law keeps a uniform and isotropic gas as it is.
Study between_diffuse_walls() {
    Study study;
    study.field = billiards_field;
    study.runs = 24;
    study.truths = {{"mean free path between the diffuse walls of a box of 5 × 4 × 3",
                     4.0 * 60.0 / (2.0 * (20.0 + 12.0 + 15.0)), 0.0, 0.0,
                     "exact: 4 volume/surface; the same"}};
    study.measure = [=](const RunOf& run) {
        Box box = test::space_of({5.0, 4.0, 3.0});
        box.surfaces.sides.fill(Diffuse{});
        return std::vector<double>{mean_path(box, {0.5, 0.5, 0.5}, run)};
    };
    return study;
}

/// Points among spheres of radius 1 at random places, which may overlap.
Study lorentz_in_space() {
    constexpr double density = 0.005;
    constexpr int scatterers = 1000, count = 400;
    Study study;
    study.field = billiards_field;
    study.runs = 24;
    study.truths = {{"mean free path of points among random spheres, over 1/(π*nR*²)", 1.0, 0.0,
                     0.0,
                     "exact: 4 volume/surface, where random spheres leave e^(−(4/3)π*nR*³) of both "
                     "the volume and their surfaces"}};
    study.measure = [=](const RunOf& run) {
        const double side = std::cbrt(scatterers / density);
        Gas gas;
        gas.seed = run.seed;
        gas.box = test::cube_of(side, Wall::periodic);
        Random random(run.seed, "scatterers");
        const auto place = [&] { return random.uniform(0.0, side); };
        for (int k = 0; k < scatterers; ++k)
            gas.box.surfaces.obstacles.push_back(
                {"sphere " + std::to_string(k), Obstacle::Ball{{place(), place(), place()}, 1.0}});
        gas.species = {{.name = "", .count = count, .radius = 0.0, .velocity = Speed{1.0}}};
        Simulation simulation(gas, {});
        const double time = 12'000.0 * run.effort;
        simulation.advance_to(time);
        double hits = 0.0;
        for (const SurfaceState& surface : simulation.surfaces())
            hits += static_cast<double>(surface.hits);
        return std::vector<double>{count * time / hits * pi * density};
    };
    return study;
}

/// Weijland and van Leeuwen's density expansion in x = n R^2, with the additional term of Bruin.
double lorentz_slowing(double x) {
    const double log = x * std::log(x);
    return 1.0 - 4.0 / 3.0 * log - 0.8775 * x + 4.519 * log * log;
}

Study lorentz() {
    constexpr double x = 0.005;
    constexpr int scatterers = 1000, count = 400;
    Study study;
    study.field = billiards_field;
    study.runs = 24;
    study.how =
        "The Lorentz gas: 400 points of speed 1 among 1000 disks of radius 1 at random places, "
        "which may overlap, in a periodic box, each run with others; *nR*² = 0.005. *D* is the "
        "slope of the mean squared displacement from 10 to 30 relaxation times. The next terms of "
        "the expansion, of the order of (*nR*²)² ln(*nR*²), stand as its error.";
    study.truths = {{"diffusion in the dilute Lorentz gas, over Boltzmann’s 3*v*/(16*nR*)",
                     1.0 / lorentz_slowing(x), 0.0005, 0.0,
                     "A. Weijland, J. M. J. van Leeuwen, Physica 38, 35 (1968); C. Bruin, Physica "
                     "72, 261 (1974): *D*_B/*D* = 1 − (4/3)*x* ln *x* − 0.8775*x* + 4.519(*x* ln "
                     "*x*)², *x* = *nR*²"},
                    {"mean free path of the points, over (1 − *nA*)/(2*nR*) of the free area *A*",
                     1.0, 0.0, 0.0, "exact: π area/perimeter, the mean over random places"}};
    study.measure = [=](const RunOf& run) {
        const double side = std::sqrt(scatterers / x);
        Gas gas;
        gas.seed = run.seed;
        gas.box.size = {side, side};
        gas.box.walls = {Wall::periodic, Wall::periodic};
        Random random(run.seed, "scatterers");
        for (int k = 0; k < scatterers; ++k)
            gas.box.surfaces.obstacles.push_back(
                {"disk " + std::to_string(k),
                 Obstacle::Ball{{random.uniform(0.0, side), random.uniform(0.0, side)}, 1.0}});
        gas.species = {{.name = "", .count = count, .radius = 0.0, .velocity = Speed{1.0}}};
        Simulation simulation(gas, {});
        simulation.record_collisions(true);
        const double boltzmann = 3.0 / (16.0 * x), relaxation = 2.0 * boltzmann;
        const int windows = std::max(1, static_cast<int>(20.0 * run.effort));
        double sum = 0.0, start = 0.0, hits = 0.0;
        for (int k = 0; k < windows; ++k) {
            Displacements displacements(simulation.box(), start);
            displacements(simulation.sample(), {});
            double squares[2] = {};
            for (int part = 0; part < 2; ++part) {
                const auto advanced =
                    simulation.advance_to(start + (part == 0 ? 10.0 : 30.0) * relaxation);
                hits += static_cast<double>(advanced.collisions.size());
                squares[part] =
                    displacements(simulation.sample(), advanced.collisions).square().sum() / count;
            }
            sum += (squares[1] - squares[0]) / (4.0 * 20.0 * relaxation * windows);
            start += 30.0 * relaxation;
        }
        // Random overlapping disks leave the fraction exp(-pi x) of the area free, and expose
        // 2 pi R exp(-pi x) of the edge of each.
        return std::vector<double>{sum / boltzmann, count * start / hits * 2.0 * x};
    };
    study.truths[1].what = "mean free path of the points, over 1/(2*nR*)";
    study.truths[1].source =
        "exact: π area/perimeter, where random disks leave e^(−π*x*) of both the area and their "
        "edges";
    return study;
}

}  // namespace

std::vector<Study> billiards() {
    return {sinai(2),          any_billiard(),          lorentz(),
            sinai(3),          any_billiard_in_space(), between_diffuse_walls(),
            lorentz_in_space()};
}

}  // namespace carom::validation
