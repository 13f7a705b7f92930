// What the commands are made of: each lists its options as data, and does its work. And what they
// share: the options that lay values over a scene, and where their output goes.
// Each command is one file, command_NAME.cpp; only command_line.cpp knows the library that reads
// the command line.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "scene/load.h"
#include "util/joined.h"

namespace carom {

/// Where a list of words goes that is given as one, with commas between them.
struct CommaSeparated {
    std::vector<std::string>* words;
};

/// Takes a value each time that its option is given.
using TakeValue = std::function<void(const std::string& value)>;

/// Where the value of an option goes: a flag, a number from 1 on, a number, text, or a list of
/// texts: all of them for words without a flag, else one for each time that the flag is given.
using OptionValue = std::variant<bool*, int*, double*, std::optional<double>*, std::string*,
                                 std::vector<std::string>*, CommaSeparated, TakeValue>;

/// One option of a command, or the words that stand in it without a flag.
struct Option {
    /// "-o,--output FILM": flags, and what the value is called (without: a flag, or `choices`).
    /// Without dashes: words, of which one is required; "[word]": one that may be missing.
    std::string name;
    std::string meaning;  ///< for the help
    OptionValue value;
    std::vector<std::string> choices = {};  ///< the only values; none: any
    std::string key = {};                   ///< of the scene, which it sets; empty: none
    int most = 1024;                        ///< of a number from 1 on
};

/// What --set takes for an option that sets `key`, KEY.PATH=VALUE, where it is given this value.
std::string change_of(const std::string& key, const std::string& value);

/// The flags of an option: "-o,--output"; the name of words without flags.
std::string flags_of(const Option& option);

/// Shows a mistake at an option as it was typed, "--fps 9999", below the whole of its value.
void show_at_option(Diagnostic& diagnostic, const std::string& flag, const std::string& value);

/// What the help calls the value of an option: FILM, mp4|webm, SCENE...; empty for a flag.
std::string word_of(const Option& option);

/// A call of carom, as it would be typed in a checkout, and what it does.
struct Example {
    std::string call, meaning;
};

/// What the help and the manual say of a command beside its options.
struct CommandText {
    std::vector<std::string> synopsis;
    std::string description;  ///< sentences, in paragraphs with an empty line between them
    std::vector<Example> examples;
};

/// A command of the program. What `run` does and where values go is shared by its copies.
struct Command {
    std::string name, meaning;
    std::vector<Option> options;
    std::function<void()> run;
    CommandText text;
};

/// All commands, in the order in which the help lists them.
std::vector<Command> all_commands();

/// What may be said to every command that reads scenes.
struct SceneOptions {
    std::vector<std::string> sets;  ///< --set, as given
    Overrides shortcuts;            ///< of --set
    int threads = 0;                ///< 0: as many as there are cores
    bool quiet = false;
    bool timings = false;
    bool is_classroom = false;
    bool no_sound = false;
};

/// An option that is a short way to write `--set key=value`.
Option shortcut(SceneOptions& options, const std::string& flag, const std::string& key,
                const std::string& meaning);

/// --seed, --set and --quiet.
std::vector<Option> scene_options(SceneOptions& options);

/// --threads.
Option threads_option(SceneOptions& options);

/// --threads and --timings.
std::vector<Option> work_options(SceneOptions& options);

/// The chunks of a plan: as many as the frames of a film, or the runs of a sweep.
int most_chunks();

/// --chunk, --force and --allow-mixed: what is done of a plan.
std::vector<Option> chunk_options(int& chunk, bool& force, bool& allow_mixed);

/// --limits.
Option limits_option(SceneOptions& options);

/// --language.
Option language_option(SceneOptions& options);

/// --template, --theme, --language, --ground and --size.
std::vector<Option> picture_options(SceneOptions& options);

/// All that lies over the scene. Throws UsageError when a --set is not KEY.PATH=VALUE.
Overrides overrides_of(const SceneOptions& options);

/// What scenes are loaded with. Throws as scene_resources().
SceneResources resources_of(const SceneOptions& options);

/// The number of threads to use, at least 1: as many as are granted (granted_cores.h) unless told.
int threads_of(const SceneOptions& options);

/// Where the output of `scene` goes: out/SCENE with the first of the extensions, or as `output`
/// (-o, may be empty) says: a file with any of them; or a folder if it is one, ends in a slash, or
/// is for `several` scenes. Throws UsageError.
std::filesystem::path output_path(const std::string& output, bool several, const std::string& scene,
                                  const std::vector<std::string>& extensions);

/// Whether an output is a folder: one that is there, or a name that ends in a slash.
bool names_folder(const std::string& output);

/// Throws UsageError when -o ends in another format than --format says; none is said if empty.
void refuse_other_format(const std::string& output, const std::string& format);

/// What the output of a scene is called without its extension: its file's name, or `stdin`.
std::string scene_stem(const std::string& scene);

/// Throws UsageError when `-` is among the scenes more than once.
void refuse_second_standard_input(const std::vector<std::string>& scenes);

/// Whether both names lead to one file.
bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b);

Command render_command();
Command still_command();
Command figures_command();
Command figure_command();
Command run_command();
Command gallery_command();
Command plan_command();
Command join_command();
Command check_command();
Command new_command();
Command schema_command();
Command help_command();
Command completions_command();

}  // namespace carom
