// The scenes of a figure set, loaded: what its pages have sections of.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/figures/figure_set.h"
#include "scene/load.h"
#include "scene/reading/set_reading.h"

namespace carom {

/// The scene at `path` with all its figures. Throws SceneError, SystemError; UsageError where it
/// lists none.
SetPart part_of_scene(const std::string& path, const Overrides& overrides);

/// The set in the file at `path`, but for its folder: a part for each scene and one for each
/// comparison, whose scene is the first that it compares, with the set's words. `formats` and
/// `pages` are those asked for; none: the file's. Throws SceneError with the mistakes of all
/// scenes, SystemError, UsageError.
FigureSet set_of_file(const std::string& path, const Overrides& overrides,
                      const std::vector<std::string>& formats = {},
                      const std::vector<std::string>& pages = {});

/// Those of figure_formats that are asked for, in their order; none: all.
std::vector<std::string> in_order(const std::vector<std::string>& formats);

/// The templates of these names or paths. Throws UsageError, SystemError.
std::vector<PageTemplate> pages_of(const std::vector<std::string>& asked);

}  // namespace carom
