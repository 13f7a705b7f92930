// Hexagonal lattices of sites fitted to a box. Independent of particles.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "physics/box.h"

namespace carom {

/// A hexagonal arrangement: rows parallel to x, every other one shifted by half a spacing.
struct HexagonalLattice {
    int rows = 0;
    int columns = 0;          ///< of the unshifted rows
    int shifted_columns = 0;  ///< of the others
    Vec spacing;              ///< along a row, between rows; length
    double nearest = 0.0;     ///< least distance of two sites, length

    int sites() const { return (rows + 1) / 2 * columns + rows / 2 * shifted_columns; }
};

/// All lattices with at least `count` sites on which disks of `radius` lie inside `box` and do not
/// overlap, in order of decreasing spacing.
std::vector<HexagonalLattice> fitting_lattices(const Box& box, int count, double radius);

/// The sites of a lattice, row by row from the bottom.
std::vector<Vec> lattice_sites(const Box& box, const HexagonalLattice& lattice, double radius);

}  // namespace carom
