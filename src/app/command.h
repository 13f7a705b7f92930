// What the commands share: the options that lay values over a scene, and where their output goes.
// Each command is one file, command_NAME.cpp: it declares its options and does its work.
// The door to CLI11.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "scene/load.h"

namespace carom {

/// What may be said to every command that reads scenes.
struct SceneOptions {
    std::vector<std::string> sets;                               ///< --set, as given
    std::vector<std::pair<std::string, std::string>> shortcuts;  ///< of --set: key path and value
    int threads = 0;                                             ///< 0: as many as there are cores
    bool quiet = false;
    bool timings = false;
};

/// Declares an option that is a short way to write `--set key=value`.
void add_shortcut(CLI::App& command, SceneOptions& options, const std::string& flag,
                  const std::string& key, const std::string& words);

/// Declares --seed, --set and --quiet.
void add_scene_options(CLI::App& command, SceneOptions& options);

/// Declares --threads and --timings.
void add_work_options(CLI::App& command, SceneOptions& options);

/// Declares --template, --theme, --ground and --size.
void add_picture_options(CLI::App& command, SceneOptions& options);

/// All that lies over the scene. Throws UsageError when a --set is not KEY.PATH=VALUE.
Overrides overrides_of(const SceneOptions& options);

/// The number of threads to use, at least 1.
int threads_of(const SceneOptions& options);

/// Where the output of `scene` goes: out/SCENE with the first of the extensions, or as `output`
/// (-o, may be empty) says: a file with any of them; or a folder if it is one, ends in a slash, or
/// is for `several` scenes. Throws UsageError.
std::filesystem::path output_path(const std::string& output, bool several, const std::string& scene,
                                  const std::vector<std::string>& extensions);

/// What the output of a scene is called without its extension: its file's name, or `stdin`.
std::string scene_stem(const std::string& scene);

/// Throws UsageError when `-` is among the scenes more than once.
void refuse_second_standard_input(const std::vector<std::string>& scenes);

/// Whether both names lead to one file.
bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b);

/// The commands: each declares itself and does its work when it is called.
void add_render(CLI::App& app);
void add_still(CLI::App& app);
void add_figures(CLI::App& app);
void add_run(CLI::App& app);
void add_check(CLI::App& app);
void add_new(CLI::App& app);
void add_schema(CLI::App& app);

}  // namespace carom
