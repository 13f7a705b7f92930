// The energy of gases among surfaces of many kinds: whether its account closes in random scenes,
// and its relative error in one that is run for a given number of events, with the deepest overlap
// of a disk with a surface.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>
#include <utility>

#include "physics/events/event_loop.h"
#include "physics/gas.h"
#include "physics/placement/placement.h"
#include "physics/simulation.h"
#include "support/surface_scenes.h"

namespace carom::test {

/// Checks the account of energy at the end of a run. Returns whether the run came so far: there may
/// be no room for the particles, a surface may have to close on one, or the gas be crushed.
inline bool check_account(const SurfaceScene& scene) {
    const auto largest_term = [](const EnergyAccount& its) {
        return std::max({its.kinetic, std::abs(its.potential), its.pistons, std::abs(its.work),
                         std::abs(its.heat)});
    };
    Run run;
    run.events = scene.events;
    try {
        Simulation simulation(scene.gas, run);
        // A piston that is made to move evenly may have had much more energy on the way.
        double largest = 0.0;
        for (int time = 1; time <= 20; ++time) {
            simulation.advance_to(time);
            largest = std::max(largest, largest_term(simulation.energy_account()));
        }
        const EnergyAccount end = simulation.energy_account();
        CHECK(end.relative_error.value() * largest_term(end) < 1e-12 * largest);
        return true;
    } catch (const std::exception&) {
        return false;
    }
}

struct LongRun {
    double deepest = 0.0;  ///< in units of the radius
    double error = 0.0;    ///< of the energy, relative
};

/// Disks of radius 0.3 under gravity and a lid, with a peg, a shelf and a window. The run starts at
/// the time `clock` and is examined at intervals of `step`.
inline LongRun long_run_of_surfaces(double clock, std::int64_t events, double step) {
    constexpr double radius = 0.3, mass = 30.0, force = -20.0;
    Gas gas;
    gas.box.size = {12.0, 12.0};
    gas.box.surfaces.gravity = {0.0, -0.5};
    gas.box.surfaces.sides[3] = Piston{.mass = mass, .force = force};
    gas.box.surfaces.partitions = {{.name = "window", .axis = 0, .at = 6.0, .gaps = {{3.0, 5.0}}}};
    gas.box.surfaces.obstacles = {{"peg", Obstacle::Ball{{3.0, 3.0}, 0.7}},
                                  {"shelf", Obstacle::Lines{{{8.0, 2.0}, {10.0, 2.5}}, false}}};
    gas.species = {{.name = "disks", .count = 40, .radius = radius, .velocity = Temperature{3.0}}};
    std::pair<Particles, Sample> placed = place(gas);
    const Particles& particles = placed.first;
    Sample& now = placed.second;
    now.time = clock;
    EventLoop<2, double, true> loop(gas.box, particles);
    loop.start(now);
    const auto energy = [&](double time) {
        const auto lid = *loop.surfaces(time)[3].motion;
        return kinetic_energies(particles, now).sum() + 0.5 * now.position.col(1).sum() +
               0.5 * mass * lid.velocity * lid.velocity - (force - 0.5 * mass) * lid.place;
    };
    const double before = energy(clock);
    LongRun found;
    for (int k = 1; loop.counts().particle + loop.counts().wall < events; ++k) {
        const double time = clock + k * step;
        loop.advance(time, nullptr);
        loop.sample(time, now);
        for (Eigen::Index i = 0; i < now.position.rows(); ++i) {
            const double x = now.position(i, 0), y = now.position(i, 1);
            double gap = std::min({x, 12.0 - x, y, std::hypot(x - 3.0, y - 3.0) - 0.7,
                                   std::hypot(x - 6.0, y - 3.0), std::hypot(x - 6.0, y - 5.0)});
            if (y < 3.0 || y > 5.0) gap = std::min(gap, std::abs(x - 6.0));
            found.deepest = std::max(found.deepest, 1.0 - gap / radius);
        }
        found.error = std::max(found.error, std::abs(energy(time) / before - 1.0));
    }
    return found;
}

}  // namespace carom::test
