// The scenes of the figures that show a sweep.
#pragma once

#include "scene/load.h"

namespace carom {

/// Lets each figure of `scene` that shows a sweep load the scene's run with changes
/// (SweepShown::scene_with), and loads it once at each point of those that run it. Throws
/// SceneError with what is wrong at all of them.
void load_sweep_figures(Scene& scene, const SceneResources& resources);

}  // namespace carom
