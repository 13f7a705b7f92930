// From the checked `figures` of a scene to what they are.
#pragma once

#include <vector>

#include "scene/fields.h"
#include "scene/panel_reading.h"
#include "scene/scene.h"

namespace carom {

/// The figures that `scene` lists. Names are files of their own, times lie
/// in the run.
std::vector<FigureSpec> read_figures(const Fields& scene, const Shown& shown, Errors& errors);

}  // namespace carom
