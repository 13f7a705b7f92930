// Lattices of sites fitted to a box: hexagonal in the plane, face-centred cubic in space.
// Independent of particles.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "physics/box.h"

namespace carom {

/// Points on lines, or planes, across each axis, at every second crossing: where the sum of their
/// numbers is even. In the plane these are rows along x, every other one shifted by half a spacing:
/// a hexagonal lattice if the rows are sqrt(3) times as far apart as the lines across x. In space
/// the lattice is face-centred cubic if the planes are equally far apart along all axes. In a box
/// of another shape it is stretched along the axes.
struct Lattice {
    int dimension = 2;
    std::array<std::int64_t, 3> lines{1, 1, 1};  ///< across each axis
    Vec step = {};         ///< between two of them, that is, half of the period along the axis
    double nearest = 0.0;  ///< least distance of two sites, length; infinite if there is only one

    std::int64_t sites() const { return (lines[0] * lines[1] * lines[2] + 1) / 2; }
};

/// The lattice with at least `count` sites on which particles of `radius` lie inside `box` and do
/// not overlap, with its sites as far apart as possible; none if there is no such lattice.
std::optional<Lattice> fitting_lattice(const Box& box, std::int64_t count, double radius);

/// The sites of a lattice: row by row along x, from the bottom, and from the back.
std::vector<Vec> lattice_sites(const Box& box, const Lattice& lattice, double radius);

}  // namespace carom
