// The trial run of `carom check`: the beginning of a run, which shows most errors that would end it
// later.
#pragma once

#include <optional>

#include "scene/scene.h"

namespace carom {

/// Runs a scene up to a number of collisions that takes a fraction of a second. Returns the number
/// of collisions from time 0 to the end of the run, including those with walls and those of a
/// second run shown next to it: counted if the trial reaches the end, else extrapolated from the
/// rate so far. Returns nothing if the run is not tried (too many particles, fixed time steps), or
/// if the trial is given up. Throws SceneError for errors that end the trial and, if it reaches the
/// end, for panels and figures of a collision that does not happen (only with `has_film`: there are
/// any); Interrupted.
std::optional<double> try_run(const Scene& scene, bool has_film);

}  // namespace carom
