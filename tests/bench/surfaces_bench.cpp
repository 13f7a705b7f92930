// The cost of surfaces and gravity: the time per collision of a gas with them, relative to the same
// gas without them, measured in turn. Fails if the ratio exceeds its bound.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "bench/measured.h"
#include "physics/gas.h"

using namespace carom;

namespace {

constexpr double packing = 0.20;

// Disks of mass 1 and diameter 1 at temperature 1 between walls.
Gas plain_gas(std::int64_t count) {
    const double side = std::sqrt(static_cast<double>(count) * std::numbers::pi * 0.25 / packing);
    return {.box = {.size = {side, side}},
            .species = {{.name = "", .count = count, .velocity = Temperature{1.0}}}};
}

void add_obstacles(Gas& gas) {
    constexpr int rows = 25, columns = 40;
    for (int k = 0; k < rows * columns; ++k) {
        const Vec place{gas.box.size[0] * (k % columns + 0.5) / columns,
                        gas.box.size[1] * (k / columns + 0.5) / rows};
        gas.box.surfaces.obstacles.push_back({std::to_string(k), Obstacle::Ball{place, 1.0}});
    }
}

// A piston as heavy as the gas, with a force that balances its pressure: the compressibility factor
// is that of Henderson, Mol. Phys. 30 (1975) 971.
void add_piston(Gas& gas) {
    const auto count = static_cast<double>(gas.species[0].count);
    const double factor = (1.0 + packing * packing / 8.0) / ((1.0 - packing) * (1.0 - packing));
    gas.box.surfaces.sides[3] = Piston{.mass = count, .force = -factor * count / gas.box.size[1]};
}

// The weight of the gas is a part of its pressure.
void add_gravity(Gas& gas) { gas.box.surfaces.gravity = {0.0, -1.0 / gas.box.size[1]}; }

struct Row {
    const char* what;
    std::int64_t count;
    std::function<void(Gas&)> add;
    double most;
};

bool is_cheap(const Row& row, int rounds) {
    Gas gas = plain_gas(row.count);
    test::Measured without(gas, 2.0);
    row.add(gas);
    test::Measured with(gas, 2.0);
    for (int k = 0; k < rounds; ++k) {
        without.measure();
        with.measure();
    }
    const double cost = with.nanoseconds() / without.nanoseconds();
    fmt::print("{:15} {:9} {:14.0f} {:14.0f} {:8.2f} (at most {})\n", row.what, row.count,
               without.nanoseconds(), with.nanoseconds(), cost, row.most);
    return cost <= row.most;
}

}  // namespace

int main(int argc, char** argv) {
    const bool quick = argc > 1 && std::string(argv[1]) == "--quick";
    const std::array rows{Row{"1000 obstacles", 100'000, add_obstacles, 2.0},
                          Row{"a piston", 10'000, add_piston, 1.3},
                          Row{"gravity", 10'000, add_gravity, 1.5},
                          Row{"gravity", 100'000, add_gravity, 1.5}};
    fmt::print("box with        particles   ns/collision without       with    ratio\n");
    bool good = true;
    for (const Row& row : rows) good = is_cheap(row, quick ? 6 : 16) && good;
    return good ? 0 : 1;
}
