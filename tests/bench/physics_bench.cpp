// Million collisions between particles per CPU second, after melting, for the table of speeds, and
// the memory of the event loop. Fails if that is more than 220 bytes a particle. A fixed loop of
// similar arithmetic is timed as a reference, since machines differ and are noisy: compare the
// ratios.
#include <fmt/format.h>
#include <malloc.h>

#include <cmath>
#include <cstdint>
#include <ctime>
#include <numbers>
#include <string>

#include "physics/events/event_loop.h"
#include "physics/placement/placement.h"
#include "physics/simulation.h"
#include "support/equal_disks.h"

using namespace carom;

namespace {

constexpr double most_bytes = 220.0;

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// The reference: million steps per CPU second of a chain of multiplications, divisions and roots.
double reference_speed() {
    constexpr int steps = 10'000'000;
    const double begin = cpu_seconds();
    double x = 1.5;
    for (int i = 0; i < steps; ++i) x = std::sqrt(x * 1.25 + 1.0 / x);
    const double taken = cpu_seconds() - begin;
    return x > 0.0 ? steps / taken / 1e6 : 0.0;
}

Gas gas_between(Wall wall, double packing, int count) {
    Gas gas = test::equal_disks(packing, count);
    gas.box.walls = {wall, wall};
    return gas;
}

Gas spheres_between(Wall wall, double packing, int count) {
    Gas gas = test::equal_spheres(packing, count);
    gas.box.walls = {wall, wall, wall};
    return gas;
}

// Above this packing fraction collisions are so frequent that a short time melts the lattice.
bool is_dense(const Gas& gas, double packing) {
    return packing > (gas.box.dimension == 3 ? 0.4 : 0.5);
}

// Giants have twenty times the radius of the grains and the same density; they cover somewhat more
// than half of the covered area.
constexpr int giants = 12, grains = 4'000;

Gas giants_among_grains(Wall wall, double packing) {
    constexpr double grain = 0.5, giant = 20.0 * grain;
    const double covered = std::numbers::pi * (giants * giant * giant + grains * grain * grain);
    const double side = std::sqrt(covered / packing);
    const auto species = [](const char* name, int count, double radius) {
        return Species{.name = name,
                       .count = count,
                       .radius = radius,
                       .mass = Density{1.0},
                       .velocity = Speed{1.0}};
    };
    return {.box = {.size = {side, side}, .walls = {wall, wall}},
            .species = {species("giants", giants, giant), species("grains", grains, grain)}};
}

double million_collisions_per_second(const Gas& gas, double packing, double seconds) {
    Run run;
    run.equilibrate = is_dense(gas, packing) ? 3.0 : 10.0;
    Simulation simulation(gas, run);
    const double step = is_dense(gas, packing) ? 0.2 : 1.0;
    double time = 0.0;
    std::int64_t collisions = 0;
    const double begin = cpu_seconds();
    double taken = 0.0;
    while (taken < seconds) {
        time += step;
        collisions = simulation.advance_to(time).counts.particle;
        taken = cpu_seconds() - begin;
    }
    return static_cast<double>(collisions) / taken / 1e6;
}

void print_row(const Gas& gas, double packing, double seconds) {
    std::int64_t count = 0;
    for (const Species& species : gas.species) count += species.count;
    const double before = reference_speed();
    const double speed = million_collisions_per_second(gas, packing, seconds);
    const double reference = 0.5 * (before + reference_speed());
    fmt::print("{:7.2f} {:10} {:>9} {:22.2f} {:29.4f}\n", packing, count,
               gas.box.is_periodic(0) ? "periodic" : "solid", speed, speed / reference);
}

// Memory of the event loop per particle while it runs. The constants and samples of the particles
// (some 50 bytes each) belong to the Simulation and are not counted.
template <int Dimension>
double bytes_per_particle(const Gas& gas) {
    const auto [particles, start] = place(gas);
    const auto in_use = [] {
        const auto info = mallinfo2();
        return static_cast<double>(info.uordblks + info.hblkhd);
    };
    const double before = in_use();
    EventLoop<Dimension> loop(gas.box, particles);
    loop.start(start);
    loop.advance(0.1, nullptr);
    return (in_use() - before) / static_cast<double>(particles.count());
}

}  // namespace

int main(int argc, char** argv) {
    const bool quick = argc > 1 && std::string(argv[1]) == "--quick";
    const double seconds = quick ? 0.4 : 1.0;  // of each row
    fmt::print(
        "packing  particles  walls     million collisions/s   per million reference steps\n");
    for (const double packing : {0.20, 0.65}) {
        for (const int count : {1'000, 10'000, 100'000, 1'000'000}) {
            if (quick && count > 100'000) continue;
            for (const Wall wall : {Wall::periodic, Wall::solid})
                print_row(gas_between(wall, packing, count), packing, seconds);
        }
    }
    fmt::print("{} giants among {} grains:\n", giants, grains);
    for (const Wall wall : {Wall::periodic, Wall::solid}) {
        constexpr double packing = 0.40;
        print_row(giants_among_grains(wall, packing), packing, seconds);
    }
    fmt::print("spheres:\n");
    for (const double packing : {0.20, 0.49}) {
        for (const int side : {6, 14, 29, 63}) {  // of the lattice, in cells of four spheres
            if (quick && side > 29) continue;
            for (const Wall wall : {Wall::periodic, Wall::solid})
                print_row(spheres_between(wall, packing, 4 * side * side * side), packing, seconds);
        }
    }
    fmt::print("memory of the event loop, bytes a particle:\n");
    constexpr int side = 63, count = 4 * side * side * side;
    bool is_small = true;
    const auto print_bytes = [&](const char* what, double packing, double bytes) {
        is_small = is_small && bytes <= most_bytes;
        fmt::print("{:7.2f} {:10} {:>9} {:22.0f} (at most {})\n", packing, count, what, bytes,
                   most_bytes);
    };
    for (const double packing : {0.20, 0.65})
        print_bytes("disks", packing,
                    bytes_per_particle<2>(gas_between(Wall::solid, packing, count)));
    for (const double packing : {0.20, 0.49})
        print_bytes("spheres", packing,
                    bytes_per_particle<3>(spheres_between(Wall::solid, packing, count)));
    return is_small ? 0 : 1;
}
