// The reference page of the scene language, made from the bindings of its keys.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "scene/manual/panel_gallery.h"
#include "scene/panel_kind.h"

namespace carom {

/// docs/scene-reference.md, whole: Markdown, UTF-8. Figures have these formats; there is an example
/// of each kind of panel.
std::string scene_reference(PanelKinds kinds, const std::vector<std::string>& formats,
                            const std::map<std::string, PanelExample>& panels);

/// The scene that the page shows.
std::string reference_example();

}  // namespace carom
