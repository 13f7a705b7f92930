// Loads a Scene from a YAML file, or reports all errors of the file at once.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/file_texts.h"
#include "scene/panel_kind.h"
#include "scene/sets/set_defaults.h"
#include "scene/style/style.h"

namespace carom {

struct LoadedScene;
struct Scene;

/// Values set on the command line, applied to the scene after the file is read and before it is
/// validated: KEY.PATH=VALUE, with a key path (list items by number: gas.0.count) and a YAML value.
/// Of several for one key the last wins.
using Overrides = std::vector<std::string>;

/// Returns such a change as messages name and quote it: "--set KEY.PATH=VALUE".
std::string text_of_change(const std::string& change);

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

/// The path that stands for standard input.
inline constexpr std::string_view standard_input = "-";

/// Loads and validates a scene. The path `standard_input` reads standard input to its end, as a
/// file `<stdin>` in the working folder. Throws SceneError with all diagnostics of the file.
Scene load_scene(const std::filesystem::path& path, const SceneResources& resources,
                 const Overrides& overrides = {}, Wanted wanted = Wanted::film);

/// Loads a scene for a film or, if that is refused, for its run and its figures alone. Throws
/// SceneError, with the reasons why it is refused for a film, if it is refused for these, too.
LoadedScene load_for_all(const std::filesystem::path& path, const SceneResources& resources,
                         const Overrides& overrides = {});

/// Loads a scene without its `figures`, for figures of other scenes that show its run
/// (Wanted::figures).
Scene load_run(const std::filesystem::path& path, const SceneResources& resources,
               const Overrides& overrides);

/// Like load_run(), from text and for the physics alone; templates are looked for in the folder of
/// the path `name`.
Scene load_run_text(const std::string& text, const std::string& name,
                    const SceneResources& resources, const Overrides& overrides);

/// Like load_scene(), from text; `name` replaces the path in messages.
Scene load_scene_text(const std::string& text, const std::string& name,
                      const SceneResources& resources, const Overrides& overrides = {},
                      Wanted wanted = Wanted::film);

}  // namespace carom
