// Events per second, including collisions with walls, at several numbers of bits, and how many
// times longer an event takes than with doubles: 400 disks at packing 0.3 between walls. Runs of
// all precisions take turns, and the fastest of each counts, since other work on the machine can
// only slow it down. Fails if 256 bits cost more than the bound.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <string>

#include "physics/placement/placement.h"
#include "physics/simulation.h"
#include "support/equal_disks.h"

using namespace carom;

namespace {

constexpr double most_cost = 30.0;  // of 256 bits; some 18 on the machine of the first measurement
constexpr std::array bits_measured{53, 64, 128, 256, 512, 1024, 4096};

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double events_per_second(const Gas& gas, int bits, double time) {
    Run run;
    run.equilibrate = 1.0;
    run.bits = bits;
    Simulation simulation(gas, run);
    const double begin = cpu_seconds();
    const CollisionCounts counts = simulation.advance_to(time).counts;
    const double taken = cpu_seconds() - begin;
    return static_cast<double>(counts.particle + counts.wall) / taken;
}

}  // namespace

int main(int argc, char** argv) {
    const bool quick = argc > 1 && std::string(argv[1]) == "--quick";
    Gas gas = test::equal_disks(0.3, 400);
    gas.box.walls = {Wall::solid, Wall::solid};
    std::array<double, bits_measured.size()> best{};
    for (int round = 0; round < (quick ? 3 : 7); ++round)
        for (std::size_t k = 0; k < best.size(); ++k) {
            const double time = bits_measured[k] == 53 ? 60.0 : bits_measured[k] > 512 ? 3.0 : 12.0;
            best[k] = std::max(best[k], events_per_second(gas, bits_measured[k], time));
        }
    fmt::print("  bits      events/s   times a double\n");
    double cost = 0.0;
    for (std::size_t k = 0; k < best.size(); ++k) {
        fmt::print("{:6} {:13.0f} {:16.1f}\n", bits_measured[k], best[k], best[0] / best[k]);
        if (bits_measured[k] == 256) cost = best[0] / best[k];
    }
    const bool good = cost <= most_cost;
    fmt::print("256 bits cost {:.1f} times as much as doubles, allowed are {}: {}\n", cost,
               most_cost, good ? "good" : "TOO MUCH");
    return good ? 0 : 1;
}
