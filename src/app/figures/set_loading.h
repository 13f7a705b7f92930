// The figures of a scene or of a figure set, with their scenes loaded.
#pragma once

#include <string>
#include <vector>

#include "app/figures/figure_set.h"
#include "scene/load.h"

namespace carom {

/// The figures of the scene or of the set in the file at `path`, but for their folder: a part for
/// each scene and one for each comparison, whose scene is the first that it compares, with the
/// set's words. `formats` and `pages` are those asked for; none: the file's. Throws SceneError with
/// the mistakes of all scenes, SystemError, UsageError (also where a scene lists no figures).
FigureSet load_set(const std::string& path, const SceneResources& resources,
                   const Overrides& overrides, const std::vector<std::string>& formats = {},
                   const std::vector<std::string>& pages = {});

}  // namespace carom
