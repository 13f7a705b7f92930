// The precision that a scene asks for, found before its film or figures begin: all passes over one
// scene calculate with the same bits.
#pragma once

#include "physics/reversal/echo.h"
#include "scene/scene.h"

namespace carom {

/// The scene with `run.bits` found where it leaves them to be found, which takes several runs; and
/// its nudges tried out; `told` hears how far the trials have come. Throws SceneError, with the
/// place in the file.
Scene with_precision(const Scene& scene, const TrialCallback& on_progress = {});

}  // namespace carom
