// What the text of a scalar says: numbers as the scene language reads them, more narrowly than
// YAML does.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "scene/yaml/node.h"

namespace carom {

/// A decimal number: digits, at most one point, an exponent; finite, no leading zeros, no other
/// base. Nothing if `text` is not that, or too large or too small for a double.
std::optional<double> parse_number(std::string_view text);

/// The number that a scalar gives; nothing if it is quoted or no number.
std::optional<double> number_in(const Node& node);

/// `true` or `false`; nothing for anything else, quoted or in another spelling.
std::optional<bool> flag_in(const Node& node);

/// How to mend a scalar that should have been a number; may be empty.
std::string number_hint(const Node& node);

/// How to mend a scalar that should have been `true` or `false`; may be empty.
std::string flag_hint(const Node& node);

}  // namespace carom
