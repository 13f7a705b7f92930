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

}  // namespace carom::test
