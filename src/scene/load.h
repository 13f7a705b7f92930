// From a YAML file to a Scene, or to all its errors at once.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/panel_kind.h"
#include "scene/scene.h"

namespace carom {

/// What the command line lays over a scene, after the file and before validation: KEY.PATH=VALUE,
/// with a key path (counted lists: gas.0.count) and a YAML value each; the last wins.
using Overrides = std::vector<std::string>;

/// What messages call such a change, and show as its text: "--set KEY.PATH=VALUE".
std::string text_of_change(const std::string& change);

/// What the scene is for. A scene that says nothing of a film is one of 1 second for each unit of
/// time where a film is wanted, and has none where only the physics is.
enum class Wanted { film, physics };

/// What carom brings along for scenes.
struct SceneResources {
    std::filesystem::path templates;  ///< the folder that holds films/
    PanelKinds panels;                ///< all kinds of panel (panels/registry.h); lives on
    FileTexts files = {};             ///< read in place of what these paths lead to
    bool is_classroom = false;        ///< whether scenes are held to its limits (classroom.h)
};

/// The path that stands for standard input.
inline constexpr std::string_view standard_input = "-";

/// Loads and validates; of standard_input all that is there, as `<stdin>` in the working folder.
/// Throws SceneError with every diagnostic of the file.
Scene load_scene(const std::filesystem::path& path, const SceneResources& resources,
                 const Overrides& overrides = {}, Wanted wanted = Wanted::film);

/// The same without what it lists under `figures`, for figures of others that show its run.
Scene load_run(const std::filesystem::path& path, const SceneResources& resources,
               const Overrides& overrides);

/// load_run() from text for its physics alone; its template is looked for beside the path `name`.
Scene load_run_text(const std::string& text, const std::string& name,
                    const SceneResources& resources, const Overrides& overrides);

/// load_scene() from text; `name` stands in for the path in messages.
Scene load_scene_text(const std::string& text, const std::string& name,
                      const SceneResources& resources, const Overrides& overrides = {},
                      Wanted wanted = Wanted::film);

}  // namespace carom
