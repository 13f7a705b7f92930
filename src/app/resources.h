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

/// The folder scenes/, the library that comes with carom and holds its JSON Schema. Throws as
/// templates_folder() does; it need not exist.
std::filesystem::path library_folder();

}  // namespace carom
