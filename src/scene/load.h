// Loads a Scene from a YAML file, or reports all errors of the file at once.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "scene/tree/resources.h"

namespace carom {

struct LoadedScene;
struct Scene;

/// Values set on the command line, applied to the scene after the file is read and before it is
/// validated: KEY.PATH=VALUE, with a key path (list items by number: gas.0.count) and a YAML value.
/// Of several for one key the last wins.
using Overrides = std::vector<std::string>;

/// Returns such a change as messages name and quote it: "--set KEY.PATH=VALUE".
std::string text_of_change(const std::string& change);

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
