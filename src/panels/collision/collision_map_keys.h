// The scene keys that only collision maps accept: the pair, if it is not one of the scene, and how
// it is shown.
#pragma once

#include <vector>

#include "scene/keys/binding.h"
#include "scene/scene.h"

namespace carom {

std::vector<Binding<PanelSpec>> collision_map_keys();

/// Reports a map for disks, which have two velocity components each; a pair that is given
/// incompletely or twice; and a pair that never collides.
void check_collision_map(PanelSpec& panel, const Node& node, Reading& reading);

}  // namespace carom
