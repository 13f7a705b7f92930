// Scenes of tests, given as text.
#pragma once

#include <string>

#include "scene/load.h"
#include "support/resources.h"

namespace carom::test {

/// The scene of a text, with the templates of carom; messages call it `test`.
inline Scene scene_from(const std::string& text, const Overrides& overrides = {},
                        Wanted wanted = Wanted::film) {
    return load_scene_text(text, "test", resources(), overrides, wanted);
}

}  // namespace carom::test
