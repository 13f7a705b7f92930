// Validation of pistons and driven walls.
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "physics/gas.h"
#include "physics/mechanics.h"
#include "physics/simulation.h"
#include "support/bodies.h"
#include "support/space.h"
#include "util/random.h"
#include "validation/hard_fluids.h"
#include "validation/study.h"

namespace carom::validation {

namespace {

constexpr const char* pistons_field = "Pistons and driven walls";

/// The mean of h from 0 to `end`, weighted by `weight`.
double mean_of(const auto& weight, double end) {
    constexpr int steps = 20'000;
    double sum = 0.0, moment = 0.0;
    for (int k = 0; k < steps; ++k) {
        const double h = (k + 0.5) / steps * end;
        sum += weight(h);
        moment += h * weight(h);
    }
    return moment / sum;
}

double mean_height(Simulation& simulation, std::int32_t piston, double step, double effort) {
    const int samples = std::max(10, static_cast<int>(30'000 * effort));
    double sum = 0.0;
    for (int k = 1; k <= samples; ++k) {
        simulation.advance_to(step * k);
        sum += simulation.surfaces()[static_cast<std::size_t>(piston)].motion->place / samples;
    }
    return sum;
}

/// The height of the piston has the density p(h) ~ h^N (E - F h)^((d N - 1) / 2), where h^N is
/// corrected for the size of the disks or spheres.
Study piston_on_a_gas(int dimension) {
    constexpr int count = 5;
    constexpr double width = 1.0, force = 2.0, start = 4.0, mass = 3.0;
    constexpr double energy = 0.5 * count * 1.0 + force * start;
    const double radius = dimension == 2 ? 0.02 : 0.05;
    Study study;
    study.field = pistons_field;
    study.runs = 24;
    const double reach = energy / force;
    const auto room = [=](double h) {
        const double a = std::max(0.0, h - 2.0 * radius);
        if (a < 2.0 * radius) return 0.0;
        const double pairs = 0.5 * count * (count - 1.0);
        return std::pow(a, count) *
               (1.0 - pairs * excluded_share(dimension, {a, width, width}, 2.0 * radius));
    };
    const auto density = [=](double h) {
        return room(h) * std::pow(energy - force * h, 0.5 * (dimension * count - 1.0));
    };
    const double of_points = reach * (count + 1.0) / ((0.5 * dimension + 1.0) * count + 1.5);
    study.truths = {
        {std::string("mean height of a piston under a force on 5 ") +
             (dimension == 2 ? "disks, over (*E*/*F*)(*N* + 1)/(2*N* + 3/2)"
                             : "spheres, over (*E*/*F*)(*N* + 1)/(5*N*/2 + 3/2)"),
         mean_of(density, reach) / of_points, 0.0, 0.0,
         dimension == 2 ? "exact: *p*(*h*) ∝ *h*ᴺ(*E* − *Fh*)^(*N* − ½), with the room of disks of "
                          "radius 0.02 (second virial)"
                        : "exact: *p*(*h*) ∝ *h*ᴺ(*E* − *Fh*)^((3*N* − 1)/2), with the room of "
                          "spheres of radius 0.05 (second virial)"}};
    study.measure = [=](const RunOf& run) {
        Gas gas;
        gas.seed = run.seed;
        gas.box = test::box_of(dimension, {width + 2.0 * radius, start, width + 2.0 * radius});
        gas.box.surfaces.sides[3] = Piston{mass, -force, 0.0};
        gas.species = {{.name = "", .count = count, .radius = radius, .velocity = Speed{1.0}}};
        Run how;
        how.equilibrate = 500.0;
        Simulation simulation(gas, how);
        return std::vector<double>{mean_height(simulation, 3, 5.3, run.effort) / of_points};
    };
    return study;
}

/// On a wire p(h) ~ h^N (E - F h)^((N - 1) / 2), with the mean (E / F) (N + 1) / ((3 N + 3) / 2).
Study piston_on_a_wire() {
    constexpr int count = 5;
    constexpr double force = 2.0, start = 3.0;
    Study study;
    study.field = pistons_field;
    study.runs = 24;
    study.truths = {
        {"mean length under a piston on 5 point beads of masses 0.7 to 4.1, over "
         "(*E*/*F*)·⅔",
         1.0, 0.0, 0.0, "exact: *p*(*h*) ∝ *h*ᴺ(*E* − *Fh*)^((*N* − 1)/2)"}};
    study.measure = [=](const RunOf& run) {
        Random random(run.seed, "beads under a piston");
        Box box{.dimension = 1, .size = {start, 0.0}};
        box.surfaces.sides[1] = Piston{2.3, -force, 0.0};
        std::vector<test::Disk> beads;
        const double masses[] = {0.7, 1.9, 3.3, 1.3, 4.1};
        for (int k = 0; k < count; ++k)
            beads.push_back({0.5 * (k + 1), 0.0, random.normal(), 0.0, 0.0, 1.0 / masses[k]});
        Simulation simulation = test::simulation_of(box, beads);
        const double energy =
            kinetic_energies(simulation.particles(), simulation.sample()).sum() + force * start;
        return std::vector<double>{mean_height(simulation, 1, 3.7, run.effort) * force / energy *
                                   1.5};
    };
    return study;
}

/// T V^(2/d) in d dimensions, after a wall has halved the room V at this speed, relative to its
/// value before.
double kept(int dimension, double speed, std::uint64_t seed) {
    const double size = dimension == 3 ? 5.0 : 10.0;
    const double radius = dimension == 1 ? 0.0 : dimension == 2 ? 0.03 : 0.1;
    const int count = dimension == 1 ? 20 : 50;
    Gas gas;
    gas.seed = seed;
    gas.box = test::box_of(dimension, {size, dimension == 1 ? 0.0 : size, size});
    gas.box.surfaces.sides[1] = Driven{-speed, 0.5 * size / speed};
    gas.species = {{.name = "", .count = count, .radius = radius, .velocity = Temperature{1.0}}};
    Simulation simulation(gas, {});
    const double before = simulation.energy_account().kinetic;
    simulation.advance_to(0.5 * size / speed);
    const double ratio = simulation.energy_account().kinetic / before;
    // The adiabatic invariant is E^(d N / 2) Q, where Q is the configuration integral of all.
    const auto logarithm = [&](double length) {
        const double b = size - 2.0 * radius;
        const Vec sides{length - 2.0 * radius, b, b};
        const double share = dimension == 1 ? 0.0 : excluded_share(dimension, sides, 2.0 * radius);
        return std::log(sides[0]) + 0.5 * (count - 1.0) * std::log1p(-share);
    };
    return ratio * std::exp(2.0 / dimension * (logarithm(0.5 * size) - logarithm(size)));
}

/// At two speeds, extrapolated to that of 0.
double kept_slowly(int dimension, const RunOf& run) {
    return 2.0 * kept(dimension, 0.01, run.seed) - kept(dimension, 0.02, run.seed + 1000);
}

Study slow_stroke_in_space() {
    Study study;
    study.field = pistons_field;
    study.runs = 200;
    study.truths = {{"*TV*^(2/3) after a slow stroke to half the room over that before, 50 spheres",
                     1.0, 0.0, 0.0, "exact: adiabatic, heat capacity ratio 5/3"}};
    study.measure = [](const RunOf& run) { return std::vector<double>{kept_slowly(3, run)}; };
    return study;
}

Study slow_strokes() {
    Study study;
    study.field = pistons_field;
    study.runs = 400;
    study.how =
        "Slow strokes halve the room at wall speeds 0.02 and 0.01, where the gas has √*T* = 1, "
        "extrapolated to speed 0; *V* is the room that 50 disks of radius 0.03, or 50 spheres of "
        "radius 0.1 in a cube of side 5, leave one another (second virial).";
    study.truths = {
        {"*TV* after a slow stroke to half the room over that before, 50 disks", 1.0, 0.0, 0.0,
         "exact: adiabatic, heat capacity ratio 2"},
        {"*TL*² after a slow stroke to half the length over that before, 20 points on a "
         "wire",
         1.0, 0.0, 0.0, "exact: adiabatic, heat capacity ratio 3"}};
    study.measure = [=](const RunOf& run) {
        return std::vector<double>{kept_slowly(2, run), kept_slowly(1, run)};
    };
    return study;
}

Study one_hit() {
    Study study;
    study.field = pistons_field;
    study.truths = {{"velocity of a disk of velocity 3 after a hit by a wall of velocity −1", -5.0,
                     0.0, 1e-15, "exact: 2*u* − *v*"},
                    {"work of the wall on its mass of 2", 16.0, 0.0, 1e-15, "exact"},
                    {"velocity of a bead of velocity 0.25 after a hit by a wall of velocity −1.5",
                     -3.25, 0.0, 1e-15, "exact: 2*u* − *v*"}};
    study.measure = [=](const RunOf&) {
        Box plane{.dimension = 2, .size = {10.0, 4.0}};
        plane.surfaces.sides[1] = Driven{-1.0};
        Simulation disk = test::simulation_of(plane, {{5.0, 2.0, 3.0, 0.5, 0.5, 0.5}});
        disk.advance_to(2.0);
        Box wire{.dimension = 1, .size = {10.0, 0.0}};
        wire.surfaces.sides[1] = Driven{-1.5};
        Simulation bead = test::simulation_of(wire, {{5.0, 0.0, 0.25, 0.0, 0.0, 1.0}});
        bead.advance_to(3.0);
        return std::vector<double>{disk.sample().velocity(0, 0), disk.surfaces()[1].work,
                                   bead.sample().velocity(0, 0)};
    };
    return study;
}

/// The mean of exp(-W / T) for gases of one point and of three, in a box whose wall moves at this
/// velocity. Points do not collide with each other, so each of them is an independent sample.
std::array<double, 2> jarzynski(double velocity, double from, double to, std::uint64_t seed) {
    const double time = (to - from) / velocity;
    Gas gas;
    gas.seed = seed;
    gas.box.size = {from, 1.0};
    gas.box.surfaces.sides[1] = Driven{velocity, time};
    gas.species = {{.name = "", .count = 201, .radius = 0.0, .velocity = Temperature{1.0}}};
    Simulation simulation(gas, {});
    const Eigen::ArrayXd before = kinetic_energies(simulation.particles(), simulation.sample());
    simulation.advance_to(time);
    const Eigen::ArrayXd after = kinetic_energies(simulation.particles(), simulation.sample());
    const Eigen::ArrayXd weights = (before - after).exp();
    return {weights.mean(), weights.reshaped(3, 67).colwise().prod().mean()};
}

Study works() {
    Study study;
    study.field = pistons_field;
    study.runs = 40;
    const char* source =
        "exact: C. Jarzynski, Phys. Rev. Lett. 78, 2690 (1997); R. C. Lua, A. Y. Grosberg, J. "
        "Phys. "
        "Chem. B 109, 6805 (2005): (*V*₁/*V*₀)ᴺ";
    study.truths = {
        {"⟨exp(−*W*/*T*)⟩ of a stroke to half the room at wall speed 1, one point", 0.5, 0.0, 0.0,
         source},
        {"the same, three points", 0.125, 0.0, 0.0, source},
        {"the same at wall speed 0.2, one point", 0.5, 0.0, 0.0, source},
        {"⟨exp(−*W*/*T*)⟩ of an expansion to 1.5 times the room at wall speed 1, one point", 1.5,
         0.0, 0.0, source}};
    study.measure = [=](const RunOf& run) {
        const int groups = std::max(2, static_cast<int>(100 * run.effort));
        std::vector<double> values(4, 0.0);
        for (int k = 0; k < groups; ++k) {
            const std::uint64_t seed = 3000 * run.seed + 3 * static_cast<std::uint64_t>(k);
            const auto [one, three] = jarzynski(-1.0, 4.0, 2.0, seed);
            values[0] += one / groups;
            values[1] += three / groups;
            values[2] += jarzynski(-0.2, 4.0, 2.0, seed + 1)[0] / groups;
            values[3] += jarzynski(1.0, 2.0, 3.0, seed + 2)[0] / groups;
        }
        return values;
    };
    return study;
}

}  // namespace

std::vector<Study> pistons() {
    return {piston_on_a_gas(2), piston_on_a_wire(),    slow_strokes(), one_hit(), works(),
            piston_on_a_gas(3), slow_stroke_in_space()};
}

}  // namespace carom::validation
