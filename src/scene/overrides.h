// Values set on the command line, applied to a scene's tree as if they were written in the file.
#pragma once

#include "scene/load.h"
#include "scene/yaml/node.h"

namespace carom {

/// Sets each key path of `overrides` in `scene`, in order. Their texts are appended to `sources`,
/// so that errors point into what the user typed.
void apply_overrides(const Overrides& overrides, Node& scene, Sources& sources, Errors& errors);

}  // namespace carom
