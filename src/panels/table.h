// The content of a picture as numbers: a table that suffices to draw it again elsewhere. Each row
// is one drawn item; the first column gives its kind.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace carom {

/// Empty, a text, or a number; in single precision if the picture has no more.
using Cell = std::variant<std::monostate, std::string, double, float, std::int64_t>;

struct Table {
    std::vector<std::string> columns;  ///< names, with units in parentheses: speed (length/time)
    std::vector<std::vector<Cell>> rows = {};  ///< a cell for each column
};

/// The units of a table's columns, which are reduced units with Boltzmann's constant 1.
namespace reduced {
inline constexpr const char* length = "length";
inline constexpr const char* time = "time";
inline constexpr const char* speed = "length/time";
inline constexpr const char* energy = "mass length^2/time^2";
}  // namespace reduced

/// The name of a column: "speed (length/time)".
std::string column_name(const std::string& quantity, const std::string& unit);

/// The table as comma-separated values (RFC 4180): a header, then a line for each row. Numbers that
/// are not finite give empty fields, as nothing is drawn for them.
std::string csv(const Table& table);

}  // namespace carom
