// Narrower limits than those of the language, for scenes embedded in documents of other authors:
// what one machine can compute in a few minutes.
#pragma once

#include "scene/yaml/node.h"

namespace carom {

struct Scene;

/// Adds an error for each classroom limit (limits.h) that a complete scene exceeds, placed at the
/// key in `root`, the scene's mapping. Checks the film only if `has_film`. Also lowers the scene's
/// limit on collisions to that of a classroom.
void hold_to_classroom(Scene& scene, const Node& root, bool has_film, Errors& errors);

/// Returns the hint for a run that stops at the classroom limit on collisions: the limit; empty if
/// the scene is not held to classroom limits, or its own limit is lower.
std::string classroom_hint(const Scene& scene);

}  // namespace carom
