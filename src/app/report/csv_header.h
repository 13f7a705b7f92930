// The first line of a table of a run.
#pragma once

#include <string>
#include <vector>

#include "panels/table.h"

namespace carom {

/// The names of the columns, without units: those of reduced units would say nothing here.
inline std::string csv_header(const std::vector<Heading>& columns) {
    std::string line;
    for (const Heading& column : columns) line += (line.empty() ? "" : ",") + column.name;
    return line + "\n";
}

/// The columns of a vector in a box of this dimension: "vx" and "vy".
inline void add_components(std::vector<Heading>& columns, const std::string& before,
                           const Quantity& quantity, int dimension, const std::string& after = "") {
    for (int axis = 0; axis < dimension; ++axis)
        columns.emplace_back(before + "xyz"[axis] + after, quantity);
}

}  // namespace carom
