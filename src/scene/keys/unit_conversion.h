// Numbers with units, in scenes that say `units: real`. They are converted where the tree of the
// scene has been read and before it is checked, so that everything that reads it later finds plain
// numbers of nanometres, atomic mass units and picoseconds, as in a scene in reduced units.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "physics/units/quantity.h"
#include "physics/units/unit_table.h"
#include "scene/keys/keys.h"
#include "scene/yaml/node.h"

namespace carom {

/// A number before a unit: "1.5e3" and "m/s". The unit need not exist.
struct NumberWithUnit {
    std::string_view number, unit;
};

/// Returns the parts of a text that is a number before what may be a unit; nothing for others.
std::optional<NumberWithUnit> number_with_unit(std::string_view text);

/// Returns the units that a scene asks for, before it is checked; real ones where `units` has a
/// mistake.
UnitSystem units_of(const Node& root);

/// Replaces each number with a unit in a mapping of this section, where its form has a quantity, by
/// the number without it. Reports units that do not exist or do not fit, numbers without the unit
/// that they need, and numbers with a unit that have none, and marks these values as invalid.
void convert_units(Node& mapping, const Section& section, Errors& errors);

/// Returns a number in the unit in which the value of a node was written, with it; without one if
/// it was written without. For hints.
std::string in_unit_of(const Node& node, double value);

}  // namespace carom
