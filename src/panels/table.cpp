#include "panels/table.h"

#include <cmath>

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

std::string column_name(const std::string& quantity, const std::string& unit) {
    return quantity + " (" + unit + ")";
}

std::string csv(const Table& table) {
    std::string text;
    const auto end_field = [&](bool is_last) { text += is_last ? '\n' : ','; };
    for (std::size_t k = 0; k < table.columns.size(); ++k) {
        text += csv_field(table.columns[k]);
        end_field(k + 1 == table.columns.size());
    }
    for (const std::vector<Cell>& row : table.rows)
        for (std::size_t k = 0; k < row.size(); ++k) {
            text += std::visit(AsField{}, row[k]);
            end_field(k + 1 == row.size());
        }
    return text;
}

}  // namespace carom
