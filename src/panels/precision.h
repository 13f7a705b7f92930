// Starts the run of a scene with the precision that the scene asks for, which is determined once
// before its film or figures begin, and reports errors at their places in the scene file.
#pragma once

#include <functional>

#include "physics/reversal/precision.h"
#include "scene/scene.h"

namespace carom {

/// Calls `run` and rethrows its errors as SceneError with the place in the scene file: a gas that
/// cannot be placed, a precision that cannot be reached, a perturbation for which there is no room,
/// unending collisions, and a surface that leaves the gas no room.
void with_places_of_errors(const Scene& scene, const std::function<void()>& run);

/// A scene with `run.bits` set, and its simulation at time 0, equilibrated.
struct StartedScene {
    Scene scene;
    Simulation simulation;
};

/// Determines the number of bits if the scene leaves it open; this takes several trial runs, which
/// are reported to `on_progress`. Throws SceneError, with the place in the scene file, and
/// Interrupted.
StartedScene start_scene(const Scene& scene, const TrialCallback& on_progress = {});

}  // namespace carom
