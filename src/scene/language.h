// The scene language as data, for the JSON Schema, the reference page and the scene to start from.
#pragma once

#include "scene/keys/keys.h"
#include "scene/panel_kind.h"

namespace carom {

/// A whole scene with a box of one dimension or of two.
Section scene_section(PanelKinds kinds, int dimension = 2);

/// A template: the keys of `film` but `template`, and `layout`.
Section template_section(PanelKinds kinds);

/// A figure set: a file that lists scenes.
Section set_section(PanelKinds kinds);

}  // namespace carom
