// From the checked `panels` of a film to their options, and what these mean for the gas: whether
// there are the particles that they choose, and the components.
#pragma once

#include <vector>

#include "physics/gas.h"
#include "scene/keys/fields.h"
#include "scene/scene.h"

namespace carom {

/// What panels show: a gas, and what happens to it.
struct Shown {
    const Gas& gas;
    const Run& run;
};

/// The particles that `of` names, one or a list.
std::vector<Chosen> read_of(const Node& of, const Gas& gas, Errors& errors);

/// The numbers that a checked list of monitors names; none for no list.
std::vector<Monitor> read_monitors(const Node* list, const Shown& shown, Errors& errors);

/// The options that panels and figures share; `over` is left to the caller.
PanelSpec read_panel(const Fields& fields, const Shown& shown, Errors& errors);

/// The panels that `film` lists.
std::vector<PanelSpec> read_panels(const Fields& film, const Shown& shown, Errors& errors);

}  // namespace carom
