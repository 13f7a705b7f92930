// A scene's run as physics starts it: with the precision that the scene asks for, found once before
// its film or figures begin, and its errors at their places in the scene file.
#pragma once

#include <functional>

#include "physics/reversal/precision.h"
#include "scene/scene.h"

namespace carom {

/// Calls `run`; a gas that cannot be placed, a precision that cannot be reached, a perturbation
/// that has no room, collisions without end and a surface that leaves the gas none become a
/// SceneError with the place in the file.
void with_places_of_errors(const Scene& scene, const std::function<void()>& run);

/// A scene with `run.bits` set, and its simulation at time 0, equilibrated.
struct StartedScene {
    Scene scene;
    Simulation simulation;
};

/// Finds the bits where the scene leaves them to be found, which takes several runs, of which
/// `on_progress` is told. Throws SceneError, with the place in the file; Interrupted.
StartedScene start_scene(const Scene& scene, const TrialCallback& on_progress = {});

}  // namespace carom
