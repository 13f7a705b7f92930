// What `carom check` sees of a run: its beginning, in which most of what would end it later shows.
#pragma once

#include "scene/scene.h"

namespace carom {

/// Runs a scene of not too many particles up to a number of collisions that takes a fraction of a
/// second. Throws SceneError for what ends the run in them, and, where they are the whole run, for
/// panels and figures (`has_film`: there are any) of a collision that does not happen; Interrupted.
void try_run(const Scene& scene, bool has_film);

}  // namespace carom
