// Figure sets: files that list scenes whose figures belong together.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scene/figure_spec.h"
#include "scene/keys/binding.h"
#include "scene/panel_kind.h"
#include "scene/sets/set_defaults.h"
#include "scene/yaml/node.h"
#include "util/diagnostics.h"

namespace carom {

struct FigureSpec;
struct Scene;

/// A scene of a set. Each `Diagnostic` is a place in the file with an empty message, for errors
/// that are found later.
struct SetScene {
    std::filesystem::path path;  ///< from the working folder
    Diagnostic place;
    std::optional<std::string> title = {}, description = {};       ///< none: those of the scene
    std::vector<std::pair<std::string, Diagnostic>> figures = {};  ///< by name; empty: all
};

/// A scene whose run a comparison shows. Its label defaults to the scene's title.
struct SetRun : ComparedRun {
    std::filesystem::path path;  ///< from the working folder
};

/// A figure that compares several scenes. Its other keys are read later, once with each scene.
struct SetComparison {
    std::shared_ptr<const Source> source;  ///< the text that the node points into
    Node node;
    std::vector<SetRun> runs;
};

struct SetFile {
    std::string title;
    std::string description;  ///< may be empty
    std::vector<SetScene> scenes;
    std::vector<SetComparison> comparisons;
    std::shared_ptr<const SetDefaults> defaults;  ///< null: none
    std::string text;                             ///< the whole file, as read
    std::vector<std::string> templates;           ///< names, or paths from the working folder
    std::vector<std::string> formats;             ///< file formats of the figures; empty: all
};

/// A set with the nodes of its defaults.
struct SetReading : SetFile {
    const Node* style = nullptr;
    const Node* figures = nullptr;
};

/// Returns the value of `scenes`, the key that tells a figure set from a scene; null for a scene.
const Node* key_of_set(const Node& root);

/// Returns whether a file is a figure set; false if it cannot be read.
bool is_figure_set(const std::filesystem::path& path);

/// Loads and validates a figure set. Comparisons may use the given kinds of panel, and figures the
/// given file formats. Throws SceneError with all diagnostics of the file.
SetFile load_figure_set(const std::filesystem::path& path, PanelKinds kinds,
                        const std::vector<std::string>& formats);

/// Returns a comparison as a figure of one of its scenes. Throws SceneError if a key of the
/// comparison does not fit that scene.
FigureSpec figure_of(const SetComparison& comparison, const Scene& scene, PanelKinds kinds);

/// The table of keys of the figure set in the file `path`, to which the paths of its scenes are
/// relative.
FixedTable<SetReading> set_table(PanelKinds kinds, const std::vector<std::string>& formats,
                                 const std::filesystem::path& path = {});

}  // namespace carom
