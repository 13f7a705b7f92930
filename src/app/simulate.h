// The simulation of a scene, ready at time 0.
#pragma once

#include "app/progress.h"
#include "physics/simulation.h"
#include "scene/scene.h"

namespace carom {

/// with_precision(), whose trials may take long and are shown.
Scene with_precision(const Scene& asked, Progress& progress);

/// Places the gas and runs `run.equilibrate`; of a scene with_precision(). Throws SceneError, with
/// the place in the file, when the gas cannot be placed.
Simulation simulate(const Scene& scene);

}  // namespace carom
