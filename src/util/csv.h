// Fields of comma-separated values (RFC 4180), as every table of ours is written.
#pragma once

#include <string>

namespace carom {

/// Text as a field: one with a comma, a quote or a line break stands in quotes, its quotes doubled.
std::string csv_field(const std::string& text);

/// A number with the fewest digits that give back every bit, at most 17 (of single precision 9),
/// and a decimal point wherever the machine is.
std::string csv_number(double value);
std::string csv_number(float value);

}  // namespace carom
