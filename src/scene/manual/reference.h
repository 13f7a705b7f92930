// The reference page of the scene language, made from the bindings of its keys.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "scene/manual/panel_gallery.h"
#include "scene/panel_kind.h"

namespace carom {

/// Returns the content of docs/scene-reference.md in Markdown, UTF-8. `formats` are the file
/// formats of figures; `panels` must have an example for each kind of panel.
std::string scene_reference(PanelKinds kinds, const std::vector<std::string>& formats,
                            const std::map<std::string, PanelExample>& panels);

/// Returns the example scene on the page.
std::string reference_example();

}  // namespace carom
