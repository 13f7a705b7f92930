// Fields of comma-separated values (RFC 4180), for all tables that the program writes.
#pragma once

#include <string>

namespace carom {

/// Returns text as a field: with a comma, a quote or a line break it is quoted, and its quotes are
/// doubled.
std::string csv_field(const std::string& text);

/// Returns a number with the fewest digits that reproduce every bit, at most 17 (9 in single
/// precision), and a decimal point regardless of the locale.
std::string csv_number(double value);
std::string csv_number(float value);

}  // namespace carom
