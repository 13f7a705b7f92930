// The parts of a command: each command lists its options as data and has a function that does its
// work. Also what the commands share: the options that override values of a scene, and the rules
// for where output goes. Each command is one file, command_NAME.cpp; only command_line.cpp knows
// the library that parses the command line.
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

/// Destination of an option whose value is a list: one argument, with commas between the words.
struct CommaSeparated {
    std::vector<std::string>* words;
};

/// Called with the value each time that its option is given.
using TakeValue = std::function<void(const std::string& value)>;

/// Destination of the value of an option: a flag (bool), a whole number of at least 1 (int), a
/// number (double), a text, or a list of texts. A list takes all words if the option has no flag,
/// else one word for each time that the flag is given.
using OptionValue = std::variant<bool*, int*, double*, std::optional<double>*, std::string*,
                                 std::vector<std::string>*, CommaSeparated, TakeValue>;

/// One option of a command, or its positional arguments (words without a flag).
struct Option {
    /// "-o,--output FILM": the flags, then the name of the value (no name: the option is a plain
    /// flag, or has `choices`). A name without dashes: positional words, at least one of which is
    /// required; "[word]": one that may be missing.
    std::string name;
    std::string meaning;  ///< for the help
    OptionValue value;
    std::vector<std::string> choices = {};  ///< the only valid values; none: any value
    std::string key = {};                   ///< key of the scene that the option sets; empty: none
    int most = 1024;                        ///< upper limit of an int
    std::string absent = {};  ///< the value if only the flag is given, "--slides [FOLDER]"; empty:
                              ///< a value is needed
};

/// The argument of --set, KEY.PATH=VALUE, that is equivalent to giving an option for `key` this
/// value.
std::string change_of(const std::string& key, const std::string& value);

/// The flags of an option, "-o,--output"; for positional words their name.
std::string flags_of(const Option& option);

/// Makes a diagnostic quote an option as it was typed, "--fps 9999", and mark its whole value.
void show_at_option(Diagnostic& diagnostic, const std::string& flag, const std::string& value);

/// The name of an option's value in the help: FILM, mp4|webm, SCENE...; empty for a plain flag.
std::string word_of(const Option& option);

/// A command line of carom, as typed in a checkout of the sources, and what it does.
struct Example {
    std::string call, meaning;
};

/// The text of the help and the manual about a command, apart from its options.
struct CommandText {
    std::vector<std::string> synopsis;
    std::string description;  ///< sentences, in paragraphs with an empty line between them
    std::vector<Example> examples;
};

/// A command of the program. Copies share the destinations of option values and the state of `run`.
struct Command {
    std::string name, meaning;
    std::vector<Option> options;
    std::function<void()> run;
    CommandText text;
};

/// All commands, in the order in which the help lists them.
std::vector<Command> all_commands();

/// The values of the options that all commands that read scenes have in common.
struct SceneOptions {
    std::vector<std::string> sets;  ///< --set, as given
    Overrides shortcuts;            ///< from options that abbreviate a --set
    int threads = 0;                ///< 0: as many as there are cores
    bool quiet = false;
    bool timings = false;
    bool is_classroom = false;
    bool no_sound = false;
    bool is_strict = false;
    bool no_recipe = false;
};

/// An option that is a short way to write `--set key=value`.
Option shortcut(SceneOptions& options, const std::string& flag, const std::string& key,
                const std::string& meaning);

/// --seed, --set, --strict and --quiet.
std::vector<Option> scene_options(SceneOptions& options);

/// --threads.
Option threads_option(SceneOptions& options);

/// --threads and --timings.
std::vector<Option> work_options(SceneOptions& options);

/// The largest number of chunks of a plan: the largest number of frames of a film or of runs of a
/// sweep.
int most_chunks();

/// --chunk, --force and --allow-mixed: which part of a plan is done, and how. `force_too`: what
/// else --force does.
std::vector<Option> chunk_options(int& chunk, bool& force, bool& allow_mixed,
                                  const std::string& force_too = "");

/// --limits, which sets `is_classroom`.
Option limits_option(bool& is_classroom);

/// --language.
Option language_option(SceneOptions& options);

/// --style.
Option style_option(SceneOptions& options);

/// --template, --style, --theme, --language, --ground and --size.
std::vector<Option> picture_options(SceneOptions& options);

/// All overrides of the scene, from --set and its shortcuts. Throws UsageError if a --set is not
/// KEY.PATH=VALUE.
Overrides overrides_of(const SceneOptions& options);

/// The resources with which scenes are loaded. Throws what scene_resources() throws.
SceneResources resources_of(const SceneOptions& options);

/// A note on a scene (Scene::notes) in one line.
std::string note_text(const Diagnostic& note);

/// Prints the notes on a scene on standard error, unless --quiet is given.
void say_notes(const SceneOptions& options, const Scene& scene);

/// The number of threads to use, at least 1: --threads if given, else granted_cores()
/// (granted_cores.h).
int threads_of(const SceneOptions& options);

/// Throws UsageError if the folder that an option names is a file, or is named like one.
void refuse_file_for_folder(const std::string& output, const std::string& what,
                            const std::string& flag = "-o");

/// The path of the output of `scene`: out/SCENE with the first of the extensions if `output` (the
/// value of -o) is empty. Otherwise `output` is a file with any of the extensions, or a folder if
/// such a folder exists, if it ends in a slash, or if there are `several` scenes. Throws
/// UsageError.
std::filesystem::path output_path(const std::string& output, bool several, const std::string& scene,
                                  const std::vector<std::string>& extensions);

/// Whether an output is a folder: an existing folder, or a name that ends in a slash.
bool names_folder(const std::string& output);

/// Throws UsageError if the ending of -o is not that of --format. Checks nothing if `format` is
/// empty.
void refuse_other_format(const std::string& output, const std::string& format);

/// The name of a scene's output without extension: the name of the scene file, or `stdin`.
std::string scene_stem(const std::string& scene);

/// Throws UsageError when `-` is among the scenes more than once.
void refuse_second_standard_input(const std::vector<std::string>& scenes);

/// Whether both paths refer to the same file.
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
