// From the checked `figures` of a scene, and the comparisons of a set, to what they are.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "scene/keys/fields.h"
#include "scene/reading/panel_reading.h"
#include "scene/scene.h"

namespace carom {

/// The figures that `scene` lists. Names are files of their own, times lie
/// in the run.
std::vector<FigureSpec> read_figures(const Fields& scene, const Shown& shown, Errors& errors);

/// The values of `set` in a compared run, as KEY.PATH=VALUE.
std::vector<std::string> read_changes(const Fields& run, Errors& errors);

/// A comparison of a set as a figure of one of its scenes.
FigureSpec read_comparison(const Node& comparison, const Shown& shown, Errors& errors);

/// KEY.PATH=VALUE as a key path and a value.
std::pair<std::string, std::string> parted_change(const std::string& change);

}  // namespace carom
