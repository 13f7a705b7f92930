// Scenes of tests, written as text in the test.
#pragma once

#include <string>

#include "scene/load.h"
#include "support/resources.h"

namespace carom::test {

/// Loads a scene from text, with the templates of carom; messages call its file `test`.
inline Scene scene_from(const std::string& text, const Overrides& overrides = {},
                        Wanted wanted = Wanted::film) {
    return load_scene_text(text, "test", resources(), overrides, wanted);
}

}  // namespace carom::test
