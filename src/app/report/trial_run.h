// What `carom check` sees of a run: its beginning, in which most of what would end it later shows.
#pragma once

#include <optional>

#include "scene/scene.h"

namespace carom {

/// Runs a scene of not too many particles up to a number of collisions that takes a fraction of a
/// second. Throws SceneError for what ends the run in them, and, where they are the whole run, for
/// panels and figures (`has_film`: there are any) of a collision that does not happen; Interrupted.
/// Gives the collisions from time 0 on, those with walls and of the run beside included: of a whole
/// run their number, of its beginning how many there are at this rate. None where it was not tried.
std::optional<double> try_run(const Scene& scene, bool has_film);

}  // namespace carom
