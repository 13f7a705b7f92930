// A gas whose velocities are reversed while one disk is displaced by far less than could ever be
// measured: after how many collisions its return path leaves the original path.
#pragma once

#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "physics/simulation.h"
#include "support/csv.h"
#include "support/equal_disks.h"

namespace carom::test {

/// Bits by which the distance between two trajectories grows with each collision of a particle,
/// measured for 100 disks; the key is the packing fraction.
inline std::map<double, double> measured_growth() {
    std::map<double, double> bits_for_each;
    for (const auto& row : reference_rows("reversal_growth_rate.csv"))
        if (row[1] == "100") bits_for_each[std::stod(row[0])] = std::stod(row[2]);
    return bits_for_each;
}

/// Collisions per disk, counted from the reversal of the velocities, until one of 100 disks between
/// walls is a radius away from its place on the original path. `by` is the displacement of one
/// disk. Returns -1 if this does not happen within `most` collisions.
inline double collisions_until_astray(double packing, const std::string& by, double most,
                                      std::uint64_t seed = 1) {
    constexpr int count = 100;
    constexpr double step = 0.25;
    Gas gas = equal_disks(packing, count);
    gas.box.walls = {Wall::solid, Wall::solid};
    gas.seed = seed;
    Run plain{.until = 1e9, .equilibrate = 1.0, .events = {}};
    plain.bits = 1024;
    Simulation way_out(gas, plain);
    std::vector<ExactPositions> mirror;
    double out = 0.0;
    while (true) {
        const AdvanceResult advanced = way_out.advance_to(out);
        if (2.0 * static_cast<double>(advanced.counts.particle) / count >= most) break;
        mirror.push_back(way_out.exact_positions());
        out += step;
    }
    Run run = plain;
    run.events = {{out, ReverseVelocities{}}, {out, Perturbation{7, {by, "0"}}}};
    Simulation back(gas, run);
    const std::int64_t there = back.advance_to(out).counts.particle;
    for (double time = out + step; !mirror.empty(); time += step) {
        const std::int64_t now = back.advance_to(time).counts.particle;
        if (return_distance(mirror.back(), back.exact_positions()).largest > 0.5)
            return 2.0 * static_cast<double>(now - there) / count;
        mirror.pop_back();
    }
    return -1.0;
}

}  // namespace carom::test
