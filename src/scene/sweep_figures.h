// Loading of the scenes for figures that show a sweep.
#pragma once

#include "scene/load.h"

namespace carom {

/// Gives each figure of `scene` that shows a sweep the function that loads the scene's run with
/// changes (SweepShown::scene_with). For figures that run the sweep themselves, also loads the
/// scene at the points of the sweep (a sample of them if there are many) to find errors. Throws
/// SceneError with the first error of each figure.
void load_sweep_figures(Scene& scene, const SceneResources& resources);

}  // namespace carom
