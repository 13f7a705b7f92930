// The scene language as pages of the manual: panels, sections and keys, as the reference page has
// them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/manual/page.h"

namespace carom {

/// The page of all kinds of panel, each with what it shows.
ManualPage page_of_panels();

/// The page of a kind of panel: what it shows, its keys, and the scene that the reference shows
/// where the manual is installed. Throws UsageError, with a suggestion, if there is no such kind.
ManualPage page_of_panel(const std::string& kind);

/// The page of the top level of a scene.
ManualPage page_of_scene();

/// The page of what a name means in scenes: a section (`gas`), a key wherever it stands (`speed`),
/// or a path to one (`film.slow.factor`). Throws UsageError, with a suggestion, if it means
/// nothing.
ManualPage page_of_scene(const std::string& name);

/// A name that page_of_scene() knows, and what it means.
struct SceneName {
    std::string name, meaning;
};

/// The names of all sections, of files that are not scenes too, and of all keys, each once.
std::vector<SceneName> scene_names();

}  // namespace carom
