// From the checked `panels` of a film to their options, and what these mean for the gas: whether
// there are the particles that they choose, and the components.
#pragma once

#include <vector>

#include "physics/gas.h"
#include "scene/fields.h"
#include "scene/scene.h"

namespace carom {

/// The numbers that a checked list of monitors names; none for no list.
std::vector<Monitor> read_monitors(const Node* list);

/// The panels that `film` lists, for a scene with this gas.
std::vector<PanelSpec> read_panels(const Fields& film, const Gas& gas, Errors& errors);

}  // namespace carom
