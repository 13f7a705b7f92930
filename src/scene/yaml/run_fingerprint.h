// A short text that identifies the gas and the run of a scene, regardless of the seed and of keys
// that affect only its pictures.
#pragma once

#include <string>

#include "scene/yaml/node.h"

namespace carom {

/// Returns the fingerprint of a scene. Scenes with equal fingerprints have the same gas and run
/// except for the seed and for defaults that depend on their films; layout, comments, words and
/// figures may differ.
std::string run_fingerprint(const Node& scene);

}  // namespace carom
