// What a scene says of its gas and its run, without the seed and without what only its pictures
// show, as one short text.
#pragma once

#include <string>

#include "scene/yaml/node.h"

namespace carom {

/// Scenes with the same fingerprint have the same gas and run but for the seed, and for defaults
/// that their films give; layout, comments, words and figures may differ.
std::string run_fingerprint(const Node& scene);

}  // namespace carom
