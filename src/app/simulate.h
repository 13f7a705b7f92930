// The simulation of a scene, ready at time 0.
#pragma once

#include "app/progress.h"
#include "panels/precision.h"
#include "physics/simulation.h"
#include "runs/run.h"
#include "scene/scene.h"

namespace carom {

/// Shows the trials of the precision of `scene`, which may take long.
TrialCallback shown_trials(const Scene& scene, Progress& progress);

/// Shows what comes before time 0 of a scene: trials of its precision, equilibration.
TrialCallback shown_start(const Scene& asked, Progress& progress);

/// Shows a whole run of the physics.
RunCallbacks shown_run(const Scene& asked, Progress& progress);

/// start_scene(), whose trials and equilibration are shown.
StartedScene start_scene(const Scene& asked, Progress& progress);

}  // namespace carom
