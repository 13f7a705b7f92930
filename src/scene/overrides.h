// Values of the command line laid over a scene's tree, as if they stood in the file.
#pragma once

#include "scene/load.h"
#include "scene/yaml/node.h"

namespace carom {

/// Sets each key path of `overrides` in `scene`, in order. Their texts join `sources`, so that
/// errors point into what was typed.
void apply_overrides(const Overrides& overrides, Node& scene, Sources& sources, Errors& errors);

}  // namespace carom
