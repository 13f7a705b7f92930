// The key that return distances alone take, and what they ask of a scene.
#pragma once

#include <vector>

#include "scene/keys/binding.h"
#include "scene/scene.h"

namespace carom {

std::vector<Binding<PanelSpec>> return_distance_keys();

/// Reports a run without a reversal, and a growth law that is asked for where none is known.
void check_return_distance(PanelSpec& panel, const Node& node, Reading& reading);

}  // namespace carom
