// The reference page of the scene language, made from the bindings of its keys.
#pragma once

#include <string>

#include "scene/panel_kind.h"

namespace carom {

/// docs/scene-reference.md, whole: Markdown, UTF-8.
std::string scene_reference(PanelKinds kinds);

/// The scene that the page shows.
std::string reference_example();

}  // namespace carom
