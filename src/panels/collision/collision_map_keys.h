// The keys that collision maps alone take: which pair, if it is none of the scene's, and how it is
// shown.
#pragma once

#include <vector>

#include "scene/keys/binding.h"
#include "scene/scene.h"

namespace carom {

std::vector<Binding<PanelSpec>> collision_map_keys();

/// Reports a map of disks, which have two components of velocity each, and pairs that are given by
/// halves, twice, or that never collide.
void check_collision_map(PanelSpec& panel, const Node& node, Reading& reading);

}  // namespace carom
