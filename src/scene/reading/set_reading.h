// Figure sets: files that list scenes whose figures belong together.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scene/keys/binding.h"
#include "scene/panel_kind.h"
#include "scene/scene.h"
#include "scene/yaml/node.h"
#include "util/diagnostics.h"

namespace carom {

/// A scene of a set. Places are diagnostics with empty messages, for errors that are found later.
struct SetScene {
    std::filesystem::path path;  ///< from the working folder
    Diagnostic place;
    std::optional<std::string> title = {}, description = {};       ///< none: the scene's
    std::vector<std::pair<std::string, Diagnostic>> figures = {};  ///< names; none: all
};

/// A scene whose run a comparison shows. Without a label it has the scene's title.
struct SetRun : ComparedRun {
    std::filesystem::path path;  ///< from the working folder
};

/// A figure of several scenes; what else it says is read with each of them.
struct SetComparison {
    std::shared_ptr<const Source> source;  ///< that the node points to
    Node node;
    std::vector<SetRun> runs;
};

struct SetFile {
    std::string title;
    std::string description;  ///< may be empty
    std::vector<SetScene> scenes;
    std::vector<SetComparison> comparisons;
    std::string text;                    ///< the whole file, as read
    std::vector<std::string> templates;  ///< names, or paths from the working folder
    std::vector<std::string> formats;    ///< none: all
};

/// The key `scenes` of a figure set, which no scene has; null in a scene.
const Node* key_of_set(const Node& root);

/// Whether a file is a figure set. False when it cannot be read.
bool is_figure_set(const std::filesystem::path& path);

/// Loads and validates a set, with comparisons of these kinds of panel and figures in these
/// formats. Throws SceneError with every diagnostic of the file.
SetFile load_figure_set(const std::filesystem::path& path, PanelKinds kinds,
                        const std::vector<std::string>& formats);

/// A comparison as a figure of one of its scenes. Throws SceneError.
FigureSpec figure_of(const SetComparison& comparison, const Scene& scene, PanelKinds kinds);

/// The keys of the set that lies at `path`.
FixedTable<SetFile> set_table(PanelKinds kinds, const std::vector<std::string>& formats,
                              const std::filesystem::path& path = {});

}  // namespace carom
