#include "app/command.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <thread>

#include "util/diagnostics.h"
#include "util/text.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

// `--size 1280x720` is easier on a shell than `[1280, 720]`.
std::string as_yaml_size(const std::string& text) {
    for (const std::string cross : {"x", "X", "×"})
        if (const std::size_t at = text.find(cross); at != std::string::npos)
            return fmt::format("[{}, {}]", text.substr(0, at), text.substr(at + cross.size()));
    return text;
}

bool names_folder(const std::string& output, bool several) {
    std::error_code error;  // a name that cannot be looked at will be told when it is written
    return several || output.ends_with('/') || fs::is_directory(output, error);
}

}  // namespace

Option shortcut(SceneOptions& options, const std::string& flag, const std::string& key,
                const std::string& meaning) {
    return {flag, meaning, [&options, key](const std::string& value) {
                options.shortcuts.push_back(key + "=" +
                                            (key == "film.size" ? as_yaml_size(value) : value));
            }};
}

std::vector<Option> scene_options(SceneOptions& options) {
    return {shortcut(options, "--seed", "seed", "another seed for every random choice"),
            {"--set", "lay KEY.PATH=VALUE over the scene", &options.sets},
            {"--quiet", "no progress and no report", &options.quiet}};
}

std::vector<Option> work_options(SceneOptions& options) {
    return {{"--threads", "cores to use; the result is the same for any number", &options.threads},
            {"--timings", "seconds for each stage", &options.timings}};
}

std::vector<Option> picture_options(SceneOptions& options) {
    return {
        shortcut(options, "--template", "film.template", "another layout"),
        shortcut(options, "--theme", "film.theme", "light, dark or print"),
        shortcut(options, "--ground", "film.ground", "theme, or none: transparent"),
        shortcut(options, "--size", "film.size", "1080p, 720p, 2160p or WIDTHxHEIGHT"),
    };
}

Overrides overrides_of(const SceneOptions& options) {
    Overrides overrides = options.shortcuts;
    for (const std::string& set : options.sets) {
        const std::size_t equals = set.find('=');
        if (equals == std::string::npos || equals == 0)
            throw UsageError(fmt::format("--set {}: expected KEY.PATH=VALUE", set));
        overrides.push_back(set);
    }
    return overrides;
}

int threads_of(const SceneOptions& options) {
    if (options.threads > 0) return options.threads;
    return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

std::string scene_stem(const std::string& scene) {
    return scene == standard_input ? "stdin" : fs::path(scene).stem().string();
}

void refuse_second_standard_input(const std::vector<std::string>& scenes) {
    if (std::ranges::count(scenes, standard_input) > 1)
        throw UsageError("- stands for one scene only: standard input can be read but once");
}

bool is_same_file(const fs::path& a, const fs::path& b) {
    std::error_code error;
    return fs::equivalent(a, b, error);
}

fs::path output_path(const std::string& output, bool several, const std::string& scene,
                     const std::vector<std::string>& extensions) {
    const fs::path name = scene_stem(scene) + extensions.front();
    if (output.empty()) return "out" / name;
    if (names_folder(output, several)) return output / name;
    fs::path path = output;
    if (is_same_file(path, scene))
        throw UsageError(fmt::format("-o {}: this is the scene itself", output));
    if (std::ranges::find(extensions, path.extension().string()) == extensions.end())
        throw UsageError(
            fmt::format("-o {}: the name must end in {}", output, listed(extensions, "or")));
    return path;
}

}  // namespace carom
