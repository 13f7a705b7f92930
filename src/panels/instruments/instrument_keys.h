// The scene keys that instrument panels accept, dials included.
#pragma once

#include <vector>

#include "scene/keys/binding.h"
#include "scene/scene.h"

namespace carom {

std::vector<Binding<PanelSpec>> surfaces_key();
std::vector<Binding<PanelSpec>> pressure_volume_keys();
std::vector<Binding<PanelSpec>> pressure_keys();
std::vector<Binding<PanelSpec>> flux_keys();
std::vector<Binding<PanelSpec>> counter_keys();
std::vector<Binding<PanelSpec>> stopwatch_key();
std::vector<Binding<PanelSpec>> regions_key();
std::vector<Binding<PanelSpec>> sides_keys();
std::vector<Binding<PanelSpec>> histogram_keys();

}  // namespace carom
