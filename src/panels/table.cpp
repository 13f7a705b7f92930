#include "panels/table.h"

#include <algorithm>
#include <cmath>

#include "physics/units/unit_table.h"
#include "util/csv.h"

namespace carom {
namespace {

struct AsField {
    std::string operator()(std::monostate) const { return ""; }
    std::string operator()(const std::string& text) const { return csv_field(text); }
    std::string operator()(double value) const {
        return std::isfinite(value) ? csv_number(value) : "";
    }
    std::string operator()(float value) const {
        return std::isfinite(value) ? csv_number(value) : "";
    }
    std::string operator()(std::int64_t value) const { return std::to_string(value); }
};

}  // namespace

Heading standard_error_of(const Heading& column) {
    Heading error = column;
    error.name = "standard error of " + column.name;
    return error;
}

Table in_shown_units(Table table) {
    if (table.units != UnitSystem::real) return table;
    for (std::size_t k = 0; k < table.columns.size(); ++k) {
        Heading& column = table.columns[k];
        if (!column.quantity) continue;
        double largest = 0.0;
        for (const std::vector<TableCell>& row : table.rows)
            if (const double* value = std::get_if<double>(&row[k]); value && std::isfinite(*value))
                largest = std::max(largest, std::abs(*value));
            else if (const float* single = std::get_if<float>(&row[k]);
                     single && std::isfinite(*single))
                largest = std::max(largest, std::abs(static_cast<double>(*single)));
        const ShownUnit unit = shown_unit(*column.quantity, table.units, largest);
        for (std::vector<TableCell>& row : table.rows)
            if (double* value = std::get_if<double>(&row[k]))
                *value *= unit.factor;
            else if (const float* single = std::get_if<float>(&row[k]))
                row[k] = unit.factor * static_cast<double>(*single);
        if (!unit.name.empty()) column.name += " (" + unit.name + ")";
        column.quantity.reset();
    }
    table.units = UnitSystem::reduced;
    return table;
}

std::vector<std::string> column_names(const Table& table) {
    std::vector<std::string> names;
    for (const Heading& column : table.columns) {
        const std::string unit = column.quantity ? unit_text(*column.quantity, table.units) : "";
        names.push_back(unit.empty() ? column.name : column.name + " (" + unit + ")");
    }
    return names;
}

std::string csv(const Table& as_it_is) {
    const Table table = in_shown_units(as_it_is);
    std::string text;
    const auto end_field = [&](bool is_last) { text += is_last ? '\n' : ','; };
    const std::vector<std::string> names = column_names(table);
    for (std::size_t k = 0; k < names.size(); ++k) {
        text += csv_field(names[k]);
        end_field(k + 1 == names.size());
    }
    for (const std::vector<TableCell>& row : table.rows)
        for (std::size_t k = 0; k < row.size(); ++k) {
            text += std::visit(AsField{}, row[k]);
            end_field(k + 1 == row.size());
        }
    return text;
}

}  // namespace carom
