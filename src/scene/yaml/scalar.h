// Values of scalars: numbers and flags in the spellings of the scene language, which are fewer than
// those of YAML.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "scene/yaml/node.h"

namespace carom {

/// Parses a finite decimal number: digits, at most one point, an optional exponent; no leading
/// zeros and no other base. Returns nothing for any other text, or if the number overflows or
/// underflows a double.
std::optional<double> parse_number(std::string_view text);

/// Returns the number that a scalar gives; nothing if the scalar is quoted or not a number.
std::optional<double> number_in(const Node& node);

/// Returns the value of `true` or `false`; nothing for anything else, including quoted text and
/// other spellings.
std::optional<bool> flag_in(const Node& node);

/// Returns a hint on how to correct a scalar that should be a number; may be empty.
std::string number_hint(const Node& node);

/// Returns a hint on how to correct a scalar that should be `true` or `false`; may be empty.
std::string flag_hint(const Node& node);

}  // namespace carom
