// The scene keys of a figure that shows a sweep, and the check of their combination.
#pragma once

#include <vector>

#include "scene/keys/binding.h"
#include "scene/panel_spec.h"
#include "scene/sweep.h"

namespace carom {

/// Quantities that the horizontal axis may show instead of a varied key: the fraction of the box
/// that particles cover, and their number per unit of area or length.
inline constexpr const char* across_packing = "packing";
inline constexpr const char* across_density = "density";

std::vector<Binding<SweepShown>> sweep_keys();

void check_sweep_figure(PanelSpec& panel, const Node& node, Reading& reading);

}  // namespace carom
