// What loading a scene needs besides its file, and what it is loaded for.
#pragma once

#include <filesystem>
#include <memory>

#include "scene/file_texts.h"
#include "scene/panel_kind.h"
#include "scene/sets/set_defaults.h"
#include "scene/style/style.h"

namespace carom {

/// What the scene is loaded for. If a film is wanted, a scene that gives no length for it gets one
/// with 1 second per unit of simulated time. Figures take from `film` what it says about pictures;
/// a length that the scene does not give is not checked for them: a long run has figures even if
/// no film can show it. If only the physics is wanted, a scene without `film` has none. If the run
/// alone is wanted, `film` and `figures` are not read, and events after its end do not happen.
enum class Wanted { film, figures, physics, run };

/// What loading a scene needs besides its file.
struct SceneResources {
    std::filesystem::path templates;  ///< the folder that holds films/
    PanelKinds panels;     ///< all kinds of panel (panels/registry.h); must stay valid from then on
    FileTexts files = {};  ///< texts to use instead of the files at these paths
    StyleCheck styles = {};                       ///< for styles
    std::shared_ptr<const SetDefaults> set = {};  ///< null: the scene is in none
    bool is_classroom = false;  ///< whether the narrower limits of classroom.h apply
    bool is_strict = false;     ///< whether a scene with notes (Scene::notes) is refused
};

}  // namespace carom
