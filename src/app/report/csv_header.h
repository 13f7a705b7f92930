// The first line of a table of a run.
#pragma once

#include <string>
#include <vector>

#include "panels/table.h"
#include "physics/units/unit_table.h"

namespace carom {

/// The names of the columns. Reduced units would say nothing here; real ones are those in which the
/// run is calculated, so that its numbers have all their digits: "x (nm)".
inline std::string csv_header(const std::vector<Heading>& columns, UnitSystem units) {
    std::string line;
    for (const Heading& column : columns) {
        line += (line.empty() ? "" : ",") + column.name;
        if (units == UnitSystem::real && column.quantity && !column.quantity->dimension.is_none())
            line += " (" + unit_of_calculation(*column.quantity) + ")";
    }
    return line + "\n";
}

/// The columns of a vector in a box of this dimension: "vx" and "vy".
inline void add_components(std::vector<Heading>& columns, const std::string& before,
                           const Quantity& quantity, int dimension, const std::string& after = "") {
    for (int axis = 0; axis < dimension; ++axis)
        columns.emplace_back(before + "xyz"[axis] + after, quantity);
}

}  // namespace carom
