#include "app/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <new>
#include <set>
#include <thread>

#include "app/pipeline.h"
#include "app/resources.h"
#include "draw/text.h"
#include "scene/load.h"
#include "util/interrupt.h"
#include "util/text.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

struct Arguments {
    std::vector<std::string> scenes;
    std::string output;
    double at = 0.0;
    std::vector<std::string> sets;
    std::vector<std::pair<std::string, std::string>> shortcuts;  // of --set
    int threads = 0;
    std::string quality = "standard";
    bool quiet = false;
    bool timings = false;
};

// `--size 1280x720` is easier on a shell than `[1280, 720]`.
std::string as_yaml_size(const std::string& text) {
    const std::size_t cross = text.find('x');
    if (cross == std::string::npos) return text;
    return fmt::format("[{}, {}]", text.substr(0, cross), text.substr(cross + 1));
}

void add_shortcut(CLI::App& command, Arguments& arguments, const std::string& flag,
                  const std::string& key, const std::string& words) {
    command.add_option_function<std::string>(
        flag,
        [&arguments, key](const std::string& value) {
            arguments.shortcuts.emplace_back(key, key == "film.size" ? as_yaml_size(value) : value);
        },
        words);
}

void add_common_options(CLI::App& command, Arguments& arguments) {
    add_shortcut(command, arguments, "--seed", "seed", "another seed for every random choice");
    add_shortcut(command, arguments, "--template", "film.template", "another layout");
    add_shortcut(command, arguments, "--theme", "film.theme", "light, dark or print");
    add_shortcut(command, arguments, "--size", "film.size", "1080p, 720p, 2160p or WIDTHxHEIGHT");
    command.add_option("--set", arguments.sets, "lay KEY.PATH=VALUE over the scene")
        ->allow_extra_args(false);
    command.add_flag("--quiet", arguments.quiet, "no progress and no report");
}

Overrides overrides_of(const Arguments& arguments) {
    Overrides overrides{arguments.shortcuts};
    for (const std::string& set : arguments.sets) {
        const std::size_t equals = set.find('=');
        if (equals == std::string::npos || equals == 0)
            throw UsageError(fmt::format("--set {}: expected KEY.PATH=VALUE", set));
        overrides.values.emplace_back(set.substr(0, equals), set.substr(equals + 1));
    }
    return overrides;
}

Quality quality_of(const std::string& name) {
    if (name == "draft") return Quality::draft;
    return name == "final" ? Quality::final_ : Quality::standard;
}

int threads_of(const Arguments& arguments) {
    if (arguments.threads > 0) return arguments.threads;
    return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

bool names_folder(const std::string& output, bool several) {
    std::error_code error;  // a name that cannot be looked at will be told when it is written
    return several || output.ends_with('/') || fs::is_directory(output, error);
}

bool is_same_file(const fs::path& a, const fs::path& b) {
    std::error_code error;
    return fs::equivalent(a, b, error);
}

fs::path output_path(const Arguments& arguments, const std::string& scene,
                     const std::string& extension) {
    const fs::path name = fs::path(scene).stem().string() + extension;
    if (arguments.output.empty()) return "out" / name;
    if (names_folder(arguments.output, arguments.scenes.size() > 1)) return arguments.output / name;
    fs::path path = arguments.output;
    if (is_same_file(path, scene))
        throw UsageError(fmt::format("-o {}: this is the scene itself", arguments.output));
    if (path.extension() != extension)
        throw UsageError(
            fmt::format("-o {}: this version writes {} only; give a name that ends in {}",
                        arguments.output, extension, extension));
    return path;
}

void refuse_same_outputs(const Arguments& arguments) {
    const bool several = arguments.scenes.size() > 1;
    if (several && fs::path(arguments.output).extension() == ".mp4")
        throw UsageError(fmt::format("-o {}: several scenes are written into a folder; name one",
                                     arguments.output));
    std::set<fs::path> outputs;
    for (const std::string& scene : arguments.scenes)
        if (!outputs.insert(output_path(arguments, scene, ".mp4")).second)
            throw UsageError(
                fmt::format("two scenes would be written to {}; render them one by one with -o",
                            output_path(arguments, scene, ".mp4").string()));
}

void report_timings(const RenderReport& report) {
    const auto row = [](const char* stage, double seconds, const std::string& rate) {
        fmt::print("  {:<10} {:>8.2f} s CPU   {}\n", stage, seconds, rate);
    };
    const double events = static_cast<double>(report.collisions.particle + report.collisions.wall);
    const double frames = report.frames;
    row("simulate", report.simulate_seconds,
        fmt::format("{:.3g} events/s, both passes", 2.0 * events / report.simulate_seconds));
    row("draw", report.draw_seconds,
        fmt::format("{:.2f} ms a frame", 1e3 * report.draw_seconds / frames));
    row("encode", report.encode_seconds,
        fmt::format("{:.2f} ms a frame, conversion included",
                    1e3 * report.encode_seconds / frames));
    fmt::print("  {:<10} {:>8.2f} s       {:.1f} frames/s\n", "wall", report.wall_seconds,
               frames / report.wall_seconds);
}

// All scenes before any work: a mistake in the last one must not cost the hours of the first.
std::vector<Scene> load_all(const Arguments& arguments) {
    const fs::path templates = templates_folder();
    const Overrides overrides = overrides_of(arguments);
    std::vector<Scene> scenes;
    std::vector<Diagnostic> diagnostics;
    for (const std::string& name : arguments.scenes) {
        try {
            scenes.push_back(load_scene(name, templates, overrides));
        } catch (const SceneError& error) {
            diagnostics.insert(diagnostics.end(), error.diagnostics().begin(),
                               error.diagnostics().end());
        }
    }
    if (!diagnostics.empty()) throw SceneError(std::move(diagnostics));
    return scenes;
}

void report(const Arguments& arguments, const Scene& scene, const RenderReport& report) {
    if (arguments.quiet && !arguments.timings) return;
    fmt::print("{}: {} frames, {}, {:.1f} MB, {} collisions between particles, made in {:.1f} s\n",
               report.path.string(), report.frames, clock_text(scene.film.seconds),
               1e-6 * static_cast<double>(report.bytes), report.collisions.particle,
               report.wall_seconds);
    if (arguments.timings) report_timings(report);
}

void render_scenes(const Arguments& arguments) {
    refuse_same_outputs(arguments);
    require_font();
    for (const Scene& scene : load_all(arguments)) {
        Progress progress(Progress::fitting_form(arguments.quiet),
                          fs::path(scene.source.path).stem().string());
        const RenderOptions options{.output = output_path(arguments, scene.source.path, ".mp4"),
                                    .quality = quality_of(arguments.quality),
                                    .threads = threads_of(arguments)};
        report(arguments, scene, render(scene, options, progress));
    }
}

void draw_still(const Arguments& arguments) {
    require_font();
    const Scene scene =
        load_scene(arguments.scenes.front(), templates_folder(), overrides_of(arguments));
    if (!(arguments.at >= 0.0 && arguments.at <= scene.run.until))
        throw UsageError(
            fmt::format("--at {}: the scene runs from 0 to {}", arguments.at, scene.run.until));
    const fs::path output = output_path(arguments, arguments.scenes.front(), ".png");
    render_still(scene, arguments.at, output);
    if (!arguments.quiet) fmt::print("{}\n", output.string());
}

void add_render(CLI::App& app, Arguments& arguments) {
    CLI::App& command = *app.add_subcommand("render", "render the films of scenes");
    command.add_option("scenes", arguments.scenes, "scene files")->required();
    command.add_option("-o,--output", arguments.output,
                       "the film (.mp4), or a folder; out/SCENE.mp4 if not given");
    add_common_options(command, arguments);
    add_shortcut(command, arguments, "--fps", "film.fps", "frames a second");
    add_shortcut(command, arguments, "--seconds", "film.seconds", "length of the film");
    command.add_option("--quality", arguments.quality, "draft, standard or final")
        ->check(CLI::IsMember({"draft", "standard", "final"}));
    command
        .add_option("--threads", arguments.threads,
                    "cores to use; the film is the same for any number")
        ->check(CLI::Range(1, 1024));
    command.add_flag("--timings", arguments.timings, "seconds for each stage");
}

void add_still(CLI::App& app, Arguments& arguments) {
    CLI::App& command = *app.add_subcommand("still", "draw one frame of a film as a PNG");
    command
        .add_option_function<std::string>(
            "scene", [&arguments](const std::string& name) { arguments.scenes = {name}; },
            "a scene file")
        ->required();
    command.add_option("--at", arguments.at, "simulated time; the nearest frame is drawn");
    command.add_option("-o,--output", arguments.output,
                       "the picture (.png), or a folder; out/SCENE.png if not given");
    add_common_options(command, arguments);
}

void refuse_unknown_command(const CLI::App& app, int argc, const char* const* argv) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
    if (argc < 2) throw UsageError("a command is needed\n\n" + app.help());
    const std::string word = argv[1];
    if (word.starts_with('-') || std::ranges::find(names, word) != names.end()) return;
    const std::optional<std::string> meant = nearest_spelling(word, names);
    throw UsageError(fmt::format("there is no command `{}`; {}", word,
                                 meant
                                     ? fmt::format("did you mean `{}`?", *meant)
                                     : fmt::format("the commands are {}", fmt::join(names, ", "))));
}

int parse_and_run(int argc, const char* const* argv) {
    Arguments arguments;
    CLI::App app{"carom: lecture films of gases from scene files, without a screen", "carom"};
    app.set_version_flag("--version", "carom " CAROM_VERSION);
    app.require_subcommand(1);
    add_render(app, arguments);
    add_still(app, arguments);
    refuse_unknown_command(app, argc, argv);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    if (app.got_subcommand("render")) render_scenes(arguments);
    if (app.got_subcommand("still")) draw_still(arguments);
    return 0;
}

int complain(int code, const std::string& what) {
    say(what + "\n");
    return code;
}

}  // namespace

int run_command_line(int argc, const char* const* argv) {
    try {
        return parse_and_run(argc, argv);
    } catch (const SceneError& error) {
        return complain(2, error.what());
    } catch (const UsageError& error) {
        return complain(2, fmt::format("carom: {}", error.what()));
    } catch (const Interrupted&) {
        return complain(130, "carom: interrupted; nothing was written");
    } catch (const std::bad_alloc&) {
        return complain(1,
                        "carom: not enough memory; a smaller picture or fewer particles need less");
    } catch (const std::exception& error) {
        return complain(1, fmt::format("carom: {}", error.what()));
    }
}

}  // namespace carom
