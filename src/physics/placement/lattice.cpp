#include "physics/placement/lattice.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "physics/placement/placed_disks.h"

namespace carom {
namespace {

// Spacing between `count` rows (or sites in a row, `shift` more for the shifted rows).
double spacing_along(const Box& box, int axis, double count, double shift, double radius) {
    if (box.is_periodic(axis)) return box.size[axis] / count;
    const double gaps = count - 1.0 + shift;
    const double room = box.size[axis] - 2.0 * radius;
    return gaps > 0.0 ? room / gaps : box.size[axis];
}

HexagonalLattice make(const Box& box, int rows, int columns, bool equal_rows, double radius) {
    HexagonalLattice lattice{.rows = rows,
                             .columns = columns,
                             .shifted_columns = equal_rows ? columns : columns - 1,
                             .spacing = {0.0, 0.0}};
    const double shift = equal_rows && rows > 1 ? 0.5 : 0.0;
    lattice.spacing = {spacing_along(box, 0, columns, shift, radius),
                       spacing_along(box, 1, rows, 0.0, radius)};
    const double along =
        columns > 1 || box.is_periodic(0) ? lattice.spacing[0] : box.size[0] + box.size[1];
    const double diagonal = std::hypot(0.5 * lattice.spacing[0], lattice.spacing[1]);
    const double two_rows = rows > 2 ? 2.0 * lattice.spacing[1] : box.size[0] + box.size[1];
    lattice.nearest = std::min({along, rows > 1 ? diagonal : along, two_rows});
    if (rows == 1 && box.is_periodic(1)) lattice.nearest = std::min(along, box.size[1]);
    return lattice;
}

}  // namespace

std::vector<HexagonalLattice> fitting_lattices(const Box& box, int count, double radius) {
    std::vector<HexagonalLattice> lattices;
    const double least_between_rows = std::max(std::sqrt(3.0) * radius * 0.5, 1e-300);
    const int most_rows =
        static_cast<int>(std::min(box.size[1] / least_between_rows + 1.0, count + 1.0));
    for (int rows = 1; rows <= most_rows; ++rows) {
        if (box.is_periodic(1) && rows > 1 && rows % 2 == 1) continue;
        const int columns = (count + rows - 1) / rows;
        lattices.push_back(make(box, rows, columns, true, radius));
        if (!box.is_periodic(0) && rows > 1) {
            const int shorter = rows / 2;
            lattices.push_back(make(box, rows, (count + shorter + rows - 1) / rows, false, radius));
        }
    }
    const double apart = 2.0 * radius * (1.0 - touching_tolerance);
    std::erase_if(lattices, [&](const HexagonalLattice& l) {
        return l.nearest < apart || l.sites() < count || std::min(l.spacing[0], l.spacing[1]) < 0.0;
    });
    std::stable_sort(lattices.begin(), lattices.end(),
                     [](const auto& a, const auto& b) { return a.nearest > b.nearest; });
    return lattices;
}

std::vector<Vec> lattice_sites(const Box& box, const HexagonalLattice& lattice, double radius) {
    // Against a wall the outermost disks touch it; a single row or column stands in the middle.
    const auto start = [&](int axis, int count) {
        const double spacing = lattice.spacing[axis];
        if (box.is_periodic(axis)) return (axis == 0 ? 0.25 : 0.5) * spacing;
        return count > 1 ? radius : 0.5 * box.size[axis];
    };
    const bool one_column = lattice.columns == 1 && lattice.rows == 1;
    const Vec origin(start(0, one_column ? 1 : 2), start(1, lattice.rows));
    std::vector<Vec> sites;
    sites.reserve(static_cast<std::size_t>(lattice.sites()));
    for (int row = 0; row < lattice.rows; ++row) {
        const bool shifted = row % 2 == 1;
        const int columns = shifted ? lattice.shifted_columns : lattice.columns;
        for (int column = 0; column < columns; ++column)
            sites.push_back({origin[0] + lattice.spacing[0] * (column + (shifted ? 0.5 : 0.0)),
                             origin[1] + lattice.spacing[1] * row});
    }
    return sites;
}

}  // namespace carom
