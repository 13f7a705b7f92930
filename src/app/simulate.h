// The simulation of a scene, ready at time 0.
#pragma once

#include "app/progress.h"
#include "panels/precision.h"
#include "physics/simulation.h"
#include "scene/scene.h"

namespace carom {

/// Shows the trials of the precision of `scene`, which may take long.
TrialCallback shown_trials(const Scene& scene, Progress& progress);

/// with_precision(), whose trials are shown.
Scene with_precision(const Scene& asked, Progress& progress);

/// start_scene(), whose trials and equilibration are shown.
StartedScene start_scene(const Scene& asked, Progress& progress);

/// Places the gas and runs `run.equilibrate`, of which `told` hears; of a scene with_precision().
/// Throws SceneError, with the place in the file, when the gas cannot be placed; Interrupted.
Simulation simulate(const Scene& scene, const TimeCallback& on_progress);

/// The same, which shows how far it has equilibrated.
Simulation simulate(const Scene& scene, Progress& progress);

}  // namespace carom
