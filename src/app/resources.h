// Where carom's own files are: beside the program in an install tree, above it in a build tree.
#pragma once

#include <filesystem>

#include "scene/load.h"

namespace carom {

/// The folder templates/ (holding films/). Throws SystemError when it is nowhere near the program.
std::filesystem::path templates_folder();

/// What the loader of scenes takes: these templates, and all kinds of panel. Throws as
/// templates_folder() does.
SceneResources scene_resources();

/// The scene that its source describes, read again with more laid over it. Throws SceneError.
Scene scene_from(const SceneSource& source, const Overrides& more = {});

/// The folder scenes/, the library that comes with carom and holds its JSON Schema. Throws as
/// templates_folder() does; it need not exist.
std::filesystem::path library_folder();

}  // namespace carom
