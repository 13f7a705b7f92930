// Gases of equal disks or spheres in a periodic box, as used in theory and in published reference
// simulations.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "physics/gas.h"
#include "support/space.h"

namespace carom::test {

/// Disks of mass 1 and diameter 1 at temperature 1, on a lattice that fits the periodic box without
/// defects.
inline Gas equal_disks(double packing, std::int64_t count) {
    const double area = static_cast<double>(count) * std::numbers::pi * 0.25 / packing;
    const double shape = std::sqrt(std::sqrt(0.75));  // of hexagonal rows, for a square count
    Gas gas;
    gas.box.size = {std::sqrt(area) / shape, std::sqrt(area) * shape};
    gas.box.walls = {Wall::periodic, Wall::periodic};
    gas.species = {
        {.name = "", .count = count, .velocity = Temperature{1.0}, .position = LatticePlaces{}}};
    return gas;
}

/// Spheres of mass 1 and diameter 1 at temperature 1 in a cube, on a face-centred cubic lattice
/// that fits it without defects if their number is 4 k^3.
inline Gas equal_spheres(double packing, std::int64_t count) {
    const double side = std::cbrt(static_cast<double>(count) * std::numbers::pi / 6.0 / packing);
    Gas gas;
    gas.box = cube_of(side, Wall::periodic);
    gas.species = {
        {.name = "", .count = count, .velocity = Temperature{1.0}, .position = LatticePlaces{}}};
    return gas;
}

/// Disks or spheres that become a fluid: at exactly this temperature, spheres on a simple cubic
/// lattice, which falls to pieces at any packing, up to 0.52. Their number is that of a cube.
inline Gas equal_particles(int dimension, double packing, std::int64_t count, std::uint64_t seed) {
    Gas gas = dimension == 2 ? equal_disks(packing, count) : equal_spheres(packing, count);
    gas.seed = seed;
    gas.species[0].velocity = Temperature{1.0, true};
    if (dimension == 2) return gas;
    Places places;
    const double along = std::round(std::cbrt(static_cast<double>(count)));
    const double spacing = gas.box.size[0] / along;
    for (double x = 0.5; x < along; ++x)
        for (double y = 0.5; y < along; ++y)
            for (double z = 0.5; z < along; ++z)
                places.values.push_back({x * spacing, y * spacing, z * spacing});
    gas.species[0].position = places;
    return gas;
}

}  // namespace carom::test
