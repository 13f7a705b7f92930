#include "panels/field/smooth_cells.h"

#include <cmath>

namespace carom {
namespace {

// A row of cells with a stride.
struct CellRow {
    const double* first;
    Eigen::Index count, stride;
    bool is_periodic;

    double at(Eigen::Index i) const { return first[i * stride]; }

    // The value at the edge between a cell and its neighbour.
    double edge(Eigen::Index cell, Eigen::Index neighbour) const {
        if (is_periodic) neighbour = (neighbour + count) % count;
        const double own = at(cell);
        if (neighbour < 0 || neighbour >= count || std::isnan(at(neighbour))) return own;
        return 0.5 * (own + at(neighbour));
    }
};

// Means in equal parts of each cell, of the parabola through the edges with the mean of the cell.
void divide(const CellRow& row, Eigen::Index parts, double* first, Eigen::Index stride) {
    const auto count = static_cast<double>(parts);
    for (Eigen::Index cell = 0; cell < row.count; ++cell) {
        const double mean = row.at(cell), low = row.edge(cell, cell - 1),
                     high = row.edge(cell, cell + 1);
        const double slope = high - low, bend = 3.0 * (low + high - 2.0 * mean);
        for (Eigen::Index part = 0; part < parts; ++part) {
            const double middle = (static_cast<double>(part) + 0.5) / count - 0.5;
            const double square = middle * middle + 1.0 / (12.0 * count * count);  // mean of x^2
            first[(cell * parts + part) * stride] =
                mean + slope * middle + bend * (square - 1.0 / 12.0);
        }
    }
}

}  // namespace

Eigen::ArrayXd smooth_cells(const Eigen::ArrayXd& cells, Eigen::Index columns,
                            std::array<int, 2> parts, std::array<bool, 2> periodic) {
    const Eigen::Index rows = cells.size() / columns, wide = columns * parts[0];
    Eigen::ArrayXd across(rows * wide);
    for (Eigen::Index row = 0; row < rows; ++row)
        divide({cells.data() + row * columns, columns, 1, periodic[0]}, parts[0],
               across.data() + row * wide, 1);
    if (parts[1] == 1) return across;
    Eigen::ArrayXd all(across.size() * parts[1]);
    for (Eigen::Index column = 0; column < wide; ++column)
        divide({across.data() + column, rows, wide, periodic[1]}, parts[1], all.data() + column,
               wide);
    return all;
}

}  // namespace carom
