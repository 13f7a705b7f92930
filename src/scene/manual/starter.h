// A commented scene to start from, made from the bindings of the keys.
#pragma once

#include <string>

#include "scene/panel_kind.h"

namespace carom {

/// A valid scene that makes a film, with what every key means; the keys that need not be there
/// stand behind a `#` with their defaults. `schema` is where its first line tells editors to find
/// the JSON Schema, `name` how the comments call the file.
std::string starter_scene(PanelKinds kinds, const std::string& schema, const std::string& name);

/// The text of another scene behind a first line that names the schema, in place of one that it may
/// have.
std::string starter_from(const std::string& scene, const std::string& schema);

}  // namespace carom
