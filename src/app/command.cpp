#include "app/command.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>
#include <string>
#include <system_error>

#include "app/granted_cores.h"
#include "media/formats.h"
#include "runs/own_files.h"
#include "scene/limits.h"
#include "scene/scene.h"
#include "util/diagnostics.h"
#include "util/progress.h"
#include "util/text.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

// For an error message: the 16:9 size with this width if pictures may have it, else a usual size.
std::string size_of_width(const std::string& digits) {
    constexpr std::size_t most_digits = 4;
    const int width = digits.size() > most_digits ? 0 : std::atoi(digits.c_str());
    const int height = (width * 9 + 16) / 32 * 2;
    const bool is_allowed = height >= smallest_side.value && width <= largest_side.value;
    return is_allowed ? fmt::format("{}x{}", width, height) : "1280x720";
}

// `--size 1280x720` is easier on a shell than `[1280, 720]`.
std::string as_yaml_size(const std::string& text) {
    for (const std::string unit : {"cm", "mm", "in", "pt"})
        if (text.ends_with(unit))
            throw UsageError(
                fmt::format("--size {}: pictures of films are measured in pixels "
                            "(WIDTHxHEIGHT); carom figure --width takes {}",
                            text, "centimetres"));
    const auto refuse = [&](const std::string& instance) {
        throw UsageError(fmt::format(
            "--size {}: expected WIDTHxHEIGHT, for instance {}, or 2160p, 1080p or 720p", text,
            instance));
    };
    if (text.find_first_not_of("0123456789") == std::string::npos) refuse(size_of_width(text));
    for (const std::string cross : {"x", "X", "×"}) {
        const std::size_t at = text.find(cross);
        if (at == std::string::npos) continue;
        const std::string width = text.substr(0, at), height = text.substr(at + cross.size());
        if (width.empty() || height.empty()) refuse(size_of_width(width.empty() ? height : width));
        return fmt::format("[{}, {}]", width, height);
    }
    const std::size_t end = text.find_first_not_of("0123456789");
    const std::size_t second = text.find_last_not_of("0123456789") + 1;
    if (end > 0 && second < text.size() && text[end] != '.')  // 1280,720 or 1280:720
        refuse(text.substr(0, end) + "x" + text.substr(second));
    return text;
}

}  // namespace

Option shortcut(SceneOptions& options, const std::string& flag, const std::string& key,
                const std::string& meaning) {
    return {flag,
            meaning,
            [&options, key](const std::string& value) {
                options.shortcuts.push_back(change_of(key, value));
            },
            {},
            key};
}

std::string change_of(const std::string& key, const std::string& value) {
    return key + "=" + (key == "film.size" ? as_yaml_size(value) : value);
}

void show_at_option(Diagnostic& diagnostic, const std::string& flag, const std::string& value) {
    SourceSpan& span = diagnostic.span;
    span.file = diagnostic.source_line = flag + " " + value;
    span.column = static_cast<int>(flag.size()) + 2;
    span.length = static_cast<int>(value.size());
}

std::string flags_of(const Option& option) {
    std::string flags = option.name.substr(0, option.name.find(' '));
    std::erase_if(flags, [](char c) { return c == '[' || c == ']'; });
    return flags;
}

std::string word_of(const Option& option) {
    if (const std::size_t space = option.name.find(' '); space != std::string::npos)
        return option.name.substr(space + 1);
    if (!option.choices.empty()) return fmt::format("{}", fmt::join(option.choices, "|"));
    if (option.name.starts_with('-')) return "";
    const std::string word = upper_case(option.name);
    const bool several = std::holds_alternative<std::vector<std::string>*>(option.value);
    return several ? word.substr(0, word.size() - 1) + "..." : word;
}

std::vector<Command> all_commands() {
    return {render_command(),     still_command(), figures_command(), figure_command(),
            gallery_command(),    run_command(),   plan_command(),    join_command(),
            check_command(),      new_command(),   schema_command(),  help_command(),
            completions_command()};
}

std::vector<Option> scene_options(SceneOptions& options) {
    return {shortcut(options, "--seed N", "seed", "use this seed for all random choices"),
            {"--set KEY.PATH=VALUE",
             "set a value of the scene; several may follow, and it may be repeated", &options.sets},
            {"--strict",
             "refuse a scene on which there is a note, for instance because --set ends its run "
             "before something of it",
             &options.is_strict},
            {"--quiet", "print no progress and no report", &options.quiet}};
}

Option threads_option(SceneOptions& options) {
    return {"--threads N", "cores to use; the result is the same for any number", &options.threads};
}

std::vector<Option> work_options(SceneOptions& options) {
    return {threads_option(options),
            {"--timings", "print the time of each stage", &options.timings}};
}

int most_chunks() { return static_cast<int>(std::max(most_frames.value, most_runs.value)); }

std::vector<Option> chunk_options(int& chunk, bool& force, bool& allow_mixed,
                                  const std::string& force_too) {
    return {{.name = "--chunk K",
             .meaning = "for a plan: the number of the chunk to make; default: all missing chunks",
             .value = &chunk,
             .most = most_chunks()},
            {"--force", "for a plan: make chunks again even if they are done" + force_too, &force},
            {"--allow-mixed",
             "for a plan: accept one made by another build of carom or with other libraries",
             &allow_mixed}};
}

Option limits_option(bool& is_classroom) {
    return {"--limits",
            "classroom, for scenes from others: refuse those that take more than a few minutes",
            [&is_classroom](const std::string&) { is_classroom = true; },
            {"classroom"}};
}

Option language_option(SceneOptions& options) {
    return shortcut(options, "--language LANGUAGE", "film.language",
                    "language of carom's own words: en, de, fr or es");
}

Option style_option(SceneOptions& options) {
    return shortcut(options, "--style STYLE", "style",
                    "colours, fonts and sizes: a style file, or the name of one of carom's");
}

std::vector<Option> picture_options(SceneOptions& options) {
    return {
        shortcut(options, "--template TEMPLATE", "film.template",
                 "layout: the name of a template, or a file"),
        style_option(options),
        shortcut(options, "--theme THEME", "film.theme", "colours: light, dark or print"),
        language_option(options),
        shortcut(options, "--ground GROUND", "film.ground",
                 "background: theme, or none for transparent"),
        shortcut(options, "--size SIZE", "film.size", "1080p, 720p, 2160p or WIDTHxHEIGHT"),
    };
}

// "run.until:10" and "run.until" as they are probably meant.
std::string with_equals_sign(const std::string& set) {
    const std::size_t end = set.find_first_of(": ");
    const std::size_t value = std::min(set.find_first_not_of(": ", end), set.size());
    return set.substr(0, end) + "=" + (value == set.size() ? "VALUE" : set.substr(value));
}

Overrides overrides_of(const SceneOptions& options) {
    Overrides overrides = options.shortcuts;
    if (options.no_sound) overrides.emplace_back("film.sound=none");
    if (options.no_recipe) overrides.emplace_back("film.recipe=false");
    for (const std::string& set : options.sets) {
        const std::size_t equals = set.find('=');
        if (equals == std::string::npos || equals == 0)
            throw UsageError(fmt::format("--set {}: expected KEY.PATH=VALUE, for instance {}", set,
                                         equals == 0 ? "run.until=10" : with_equals_sign(set)));
        overrides.push_back(set);
    }
    return overrides;
}

SceneResources resources_of(const SceneOptions& options) {
    SceneResources resources = scene_resources();
    resources.is_classroom = options.is_classroom;
    resources.is_strict = options.is_strict;
    return resources;
}

std::string note_text(const Diagnostic& note) {
    const SourceSpan& span = note.span;
    const std::string place =
        span.line > 0 ? fmt::format("{}:{}:{}", span.file, span.line, span.column) : span.file;
    return printable(fmt::format("{}: {}: {}", place, note.message, note.hint));
}

void say_notes(const SceneOptions& options, const Scene& scene) {
    if (options.quiet) return;
    static std::set<std::string> said;  // several scenes may have the same style
    for (const Diagnostic& note : scene.notes)
        if (const std::string text = note_text(note); said.insert(text).second)
            print_to_stderr("carom: " + text + "\n");
}

int threads_of(const SceneOptions& options) {
    if (options.threads > 0) return options.threads;
    return granted_cores();
}

std::string scene_stem(const std::string& scene) {
    return scene == standard_input ? "stdin" : fs::path(scene).stem().string();
}

void refuse_second_standard_input(const std::vector<std::string>& scenes) {
    if (std::ranges::count(scenes, standard_input) > 1)
        throw UsageError("only one scene can be - (standard input)");
}

bool is_same_file(const fs::path& a, const fs::path& b) {
    std::error_code error;
    return fs::equivalent(a, b, error);
}

bool names_folder(const std::string& output) {
    std::error_code error;  // ignored: a path that cannot be examined is refused when it is written
    return output.ends_with('/') || fs::is_directory(output, error);
}

void refuse_other_format(const std::string& output, const std::string& format) {
    const std::string extension = ending_of(output);
    if (!format.empty() && extension != "." + format)
        throw UsageError(fmt::format("-o {}: the name ends in {}, but --format is {}", output,
                                     extension, format));
}

void refuse_file_for_folder(const std::string& output, const std::string& what,
                            const std::string& flag) {
    std::error_code failed;
    const bool exists = fs::exists(output, failed);
    const bool is_file = exists && !fs::is_directory(output, failed);
    const std::string ending = ending_of(output);
    std::vector<std::string> endings{".jpg", ".jpeg", ".csv", ".json", ".html"};
    for (const OutputFormat& format : output_formats()) endings.push_back("." + format.name);
    const bool is_named_so = !exists && std::ranges::count(endings, ending) > 0;
    if (is_file || is_named_so)
        throw UsageError(
            fmt::format("{} {}: {} is a folder of several files; name a folder, for "
                        "instance {}",
                        flag, output, what, fs::path(output).replace_extension().string() + "/"));
}

fs::path output_path(const std::string& output, bool several, const std::string& scene,
                     const std::vector<std::string>& extensions) {
    const fs::path name = scene_stem(scene) + extensions.front();
    if (output.empty()) return "out" / name;
    if (several || names_folder(output)) return output / name;
    fs::path path = output;
    if (is_same_file(path, scene))
        throw UsageError(fmt::format("-o {}: this would overwrite the scene", output));
    if (std::ranges::find(extensions, ending_of(path)) == extensions.end())
        throw UsageError(
            fmt::format("-o {}: the name must end in {}", output, listed(extensions, "or")));
    return path;
}

}  // namespace carom
