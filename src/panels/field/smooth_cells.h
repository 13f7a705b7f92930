// Smooth functions with given means in cells.
#pragma once

#include <Eigen/Core>
#include <array>

namespace carom {

/// Divides each cell of a grid of `columns` cells in a row into parts[0] x parts[1] equal ones and
/// gives their values: those of a function that is quadratic in each cell, continuous from cell to
/// cell, and whose mean in each cell is the value of the cell, to rounding. Cells without a value
/// (NaN) and, unless it is `periodic`, what is beyond the sides do not count: there the function
/// goes up to the edge. Rows follow each other, as in Cells.
Eigen::ArrayXd smooth_cells(const Eigen::ArrayXd& cells, Eigen::Index columns,
                            std::array<int, 2> parts, std::array<bool, 2> periodic);

}  // namespace carom
