// Finds carom's own files: next to the program in an install tree, in a folder above it in a build
// tree.
#pragma once

#include <filesystem>

#include "scene/load.h"

namespace carom {

struct SceneSource;

/// The folder templates/, which contains films/. Throws SystemError if it is not found near the
/// program.
std::filesystem::path templates_folder();

/// The resources that load_scene() needs: these templates, and all kinds of panel. Throws what
/// templates_folder() throws.
SceneResources scene_resources();

/// The scene that a source describes, loaded again with additional overrides. Throws SceneError.
Scene scene_from(const SceneSource& source, const Overrides& more = {});

/// The folder scenes/, the library that comes with carom and holds its JSON Schema. Throws as
/// templates_folder() does; it need not exist.
std::filesystem::path library_folder();

/// The folder with README.md and docs/, the manual. Throws as templates_folder() does; it need not
/// exist.
std::filesystem::path manual_folder();

}  // namespace carom
