// A commented scene to start from, made from the bindings of the keys.
#pragma once

#include <string>

#include "scene/panel_kind.h"

namespace carom {

/// Returns a valid scene that makes a film, with comments that explain every key. Optional keys are
/// commented out (`#`) and show their defaults. `schema` is the address of the JSON Schema in the
/// first line, for editors; `name` is what the comments call the file.
std::string starter_scene(PanelKinds kinds, const std::string& schema, const std::string& name);

/// Returns the text of another scene with a first line that names the schema; it replaces such a
/// line of the scene.
std::string starter_from(const std::string& scene, const std::string& schema);

}  // namespace carom
