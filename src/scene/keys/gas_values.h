// The values of gases that a scene names. They are filled in where the tree of the scene has been
// read, before it is checked, so that everything that reads it later finds them as if they were
// written.
#pragma once

#include <string>
#include <vector>

#include "scene/yaml/node.h"

namespace carom {

/// The names of all gases, in the order of their table.
std::vector<std::string> names_of_gases();

/// Adds to each item of `gas` that names a gas, `{gas: argon}`, those of the keys `name`, `radius`,
/// `mass` and `color` that it does not give, in nanometres and atomic mass units; no `mass` beside
/// `density`. Their place is that of the name of the gas. Unknown gases are left to the check.
void fill_in_gases(Node& root);

/// Returns whether a key of such an item has been filled in.
bool is_filled_in(const Node& item, std::string_view key);

}  // namespace carom
