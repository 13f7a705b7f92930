// Scenes of tests, written as text in the test.
#pragma once

#include <string>

#include "scene/load.h"
#include "scene/scene.h"
#include "support/resources.h"

namespace carom::test {

/// Loads a scene from text, with the templates of carom; messages call its file `test`.
inline Scene scene_from(const std::string& text, const Overrides& overrides = {},
                        Wanted wanted = Wanted::film) {
    return load_scene_text(text, "test", resources(), overrides, wanted);
}

/// A panel of a film, as a scene of a gas in a plane writes it.
inline PanelSpec panel_from(const std::string& written) {
    return scene_from(
               "title: T\nbox: {size: [64, 48]}\ngas: [{count: 20, speed: 1}]\n"
               "run: {until: 10}\nfilm: {panels: [" +
               written + "]}\n")
        .film.panels.at(0);
}

}  // namespace carom::test
