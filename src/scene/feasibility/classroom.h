// Narrower limits than those of the language, for scenes that stand in documents of others: what a
// few minutes of one machine allow.
#pragma once

#include "scene/scene.h"
#include "scene/yaml/node.h"

namespace carom {

/// Adds an error for each limit of a classroom (limits.h) that a complete scene is over, where
/// `root`, its mapping, says so; of its film only if it `has_film`. Lowers its ceiling of
/// collisions to that of a classroom.
void hold_to_classroom(Scene& scene, const Node& root, bool has_film, Errors& errors);

/// What a run says that had as many collisions as a classroom allows: the limit; empty where the
/// scene is not held to it, or allows fewer by itself.
std::string classroom_hint(const Scene& scene);

}  // namespace carom
