// The figures of a scene or of a figure set, with their scenes loaded.
#pragma once

#include <string>
#include <vector>

#include "app/figures/figure_set.h"
#include "scene/load.h"

namespace carom {

/// Loads the figures of the scene or set in the file at `path`; their folder is left empty. There
/// is a part for each scene and one for each comparison, whose scene is the first of those
/// compared, with the words of the set. `formats` and `pages` are those asked for; if empty, those
/// of the file. `wanted` is Wanted::film if the films of the scenes are wanted, too. Throws
/// SceneError with the mistakes of all scenes, SystemError, UsageError (also if a scene lists no
/// figures).
FigureSet load_set(const std::string& path, const SceneResources& resources,
                   const Overrides& overrides, const std::vector<std::string>& formats = {},
                   const std::vector<std::string>& pages = {}, Wanted wanted = Wanted::figures);

}  // namespace carom
