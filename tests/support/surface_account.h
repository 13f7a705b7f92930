// A small gas among surfaces of many kinds, run for a given number of events: the deepest overlap
// of a disk with a surface, and the relative error of the energy.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "physics/events/event_loop.h"
#include "physics/gas.h"
#include "physics/placement/placement.h"

namespace carom::test {

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
