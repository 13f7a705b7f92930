// The keys of a figure that shows a sweep, and what they mean together.
#pragma once

#include <vector>

#include "scene/keys/binding.h"
#include "scene/scene.h"

namespace carom {

/// What may stand on the axis across beside the varied keys: the part of the box that particles
/// cover, and their number in a unit of area or length.
inline constexpr const char* across_packing = "packing";
inline constexpr const char* across_density = "density";

std::vector<Binding<PanelSpec>> sweep_keys();

void check_sweep_figure(PanelSpec& panel, const Node& node, Reading& reading);

}  // namespace carom
