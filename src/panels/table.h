// The content of a picture as numbers: a table that suffices to draw it again elsewhere. Each row
// is one drawn item; the first column gives its kind.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "physics/units/quantity.h"

namespace carom {

/// Empty, a text, or a number; in single precision if the picture has no more.
using TableCell = std::variant<std::monostate, std::string, double, float, std::int64_t>;

/// What a column is called, in English, and what its numbers are; texts, and numbers whose unit
/// stands beside them, have no quantity.
struct Heading {
    std::string name;
    std::optional<Quantity> quantity = {};

    Heading() = default;
    Heading(const char* text) : name(text) {}
    Heading(std::string text) : name(std::move(text)) {}
    Heading(std::string what, const Quantity& of) : name(std::move(what)), quantity(of) {}
    Heading(const Quantity& of) : name(of.word.english), quantity(of) {}
    bool operator==(const Heading&) const = default;
};

/// The column of the standard errors of another column's numbers.
Heading standard_error_of(const Heading& column);

struct Table {
    std::vector<Heading> columns = {};
    std::vector<std::vector<TableCell>> rows = {};  ///< a cell for each column
    UnitSystem units = UnitSystem::reduced;         ///< of the numbers
};

/// The table with real units replaced: each column in the unit of its largest number, which its
/// name has. Others stay as they are.
Table in_shown_units(Table table);

/// The headings as they are written: "speed (length/time)".
std::vector<std::string> column_names(const Table& table);

/// The table as comma-separated values (RFC 4180): a header, then a line for each row. Numbers that
/// are not finite give empty fields, as nothing is drawn for them.
std::string csv(const Table& table);

}  // namespace carom
