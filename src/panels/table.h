// What a picture shows, as numbers: a table that is enough to draw it again elsewhere. Every row
// is one thing drawn, and its first column says of what kind.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace carom {

/// Nothing, words, or a number; single precision where the picture has no more.
using Cell = std::variant<std::monostate, std::string, double, float, std::int64_t>;

struct Table {
    std::vector<std::string> columns;  ///< names, with units in parentheses: speed (length/time)
    std::vector<std::vector<Cell>> rows = {};  ///< a cell for each column
};

/// Units of a table's columns; reduced ones, with Boltzmann's constant 1.
namespace reduced {
inline constexpr const char* length = "length";
inline constexpr const char* time = "time";
inline constexpr const char* speed = "length/time";
inline constexpr const char* energy = "mass length^2/time^2";
}  // namespace reduced

/// The name of a column: "speed (length/time)".
std::string column_name(const std::string& quantity, const std::string& unit);

/// The table as comma-separated values (RFC 4180): a header, then a line for each row. Numbers that
/// are not finite are empty, as nothing is drawn of them.
std::string csv(const Table& table);

}  // namespace carom
