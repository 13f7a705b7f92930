// Figure sets: files that list scenes whose figures belong together.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "util/diagnostics.h"

namespace carom {

/// A scene of a set. Places are diagnostics with empty messages, for errors that are found later.
struct SetScene {
    std::filesystem::path path;  ///< from the working folder
    Diagnostic place;
    std::optional<std::string> title, description;            ///< none: the scene's
    std::vector<std::pair<std::string, Diagnostic>> figures;  ///< names; none: all
};

struct SetFile {
    std::string title;
    std::string description;  ///< may be empty
    std::vector<SetScene> scenes;
    std::vector<std::string> templates;  ///< names, or paths from the working folder
    std::vector<std::string> formats;    ///< none: all
};

/// Whether a file lists `scenes`, as no scene does. False when it cannot be read.
bool is_figure_set(const std::filesystem::path& path);

/// Loads and validates. Throws SceneError with every diagnostic of the file.
SetFile load_figure_set(const std::filesystem::path& path);

}  // namespace carom
