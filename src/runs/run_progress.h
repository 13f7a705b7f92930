// The progress of a run, from the search for its precision to its end, shown to the user.
#pragma once

#include "panels/precision.h"
#include "physics/simulation.h"
#include "runs/run.h"
#include "util/progress.h"

namespace carom {

struct Scene;

/// Shows the progress of the trial runs that find the precision of `scene`, which may take long.
TrialCallback shown_trials(const Scene& scene, Progress& progress);

/// Shows the progress of what comes before time 0: the trials of the precision, the equilibration.
TrialCallback shown_start(const Scene& asked, Progress& progress);

/// Shows the progress of a whole run of the physics.
RunCallbacks shown_run(const Scene& asked, Progress& progress);

/// start_scene(), with the progress of its trials and its equilibration shown.
StartedScene start_scene(const Scene& asked, Progress& progress);

}  // namespace carom
