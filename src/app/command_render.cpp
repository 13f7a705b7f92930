// carom render: the films of scenes.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <set>
#include <system_error>

#include "app/command.h"
#include "app/letters.h"
#include "app/pipeline.h"
#include "app/resources.h"
#include "util/diagnostics.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

struct RenderArguments : SceneOptions {
    std::vector<std::string> scenes;
    std::string output;
    std::string quality = "standard";
};

Quality quality_of(const std::string& name) {
    if (name == "draft") return Quality::draft;
    return name == "final" ? Quality::final_ : Quality::standard;
}

constexpr std::array video_extensions = {".mp4", ".webm"};

bool is_video(const std::string& output) {
    return std::ranges::find(video_extensions, fs::path(output).extension()) !=
           video_extensions.end();
}

// Frames never go among other files: whose they are could not be told afterwards.
void refuse_used_folder(const std::string& output, const std::string& scene) {
    std::error_code error;  // a name that cannot be looked at will be told when it is written
    if (!fs::is_directory(output, error)) return;
    if (!fs::is_empty(output, error) && !error)
        throw UsageError(
            fmt::format("-o {}: numbered frames go into a new or empty folder, and this one holds "
                        "files; for a film in it write -o {}{}.mp4",
                        output, output, fs::path(scene).stem().string()));
    if (is_same_file(output, "."))
        throw UsageError(fmt::format(
            "-o {}: this is the working folder; name a new one for the frames", output));
}

fs::path film_path(const RenderArguments& arguments, const std::string& scene) {
    const std::string& output = arguments.output;
    const bool several = arguments.scenes.size() > 1;
    std::error_code error;
    if (several || output.empty() || (!output.ends_with('/') && fs::is_directory(output, error)))
        return output_path(output, several, scene, {".mp4"});
    if (output.ends_with('/')) {
        refuse_used_folder(output, scene);
        return output;
    }
    if (!is_video(output) && !is_same_file(output, scene))
        throw UsageError(
            fmt::format("-o {}: a film ends in {}; a folder of PNG frames ends in a slash", output,
                        fmt::join(video_extensions, " or ")));
    return output_path(output, false, scene, {fs::path(output).extension().string()});
}

void refuse_same_outputs(const RenderArguments& arguments) {
    const bool several = arguments.scenes.size() > 1;
    if (several && is_video(arguments.output))
        throw UsageError(fmt::format("-o {}: several scenes are written into a folder; name one",
                                     arguments.output));
    std::set<fs::path> outputs;
    for (const std::string& scene : arguments.scenes)
        if (!outputs.insert(film_path(arguments, scene)).second)
            throw UsageError(
                fmt::format("two scenes would be written to {}; render them one by one with -o",
                            film_path(arguments, scene).string()));
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
std::vector<Scene> load_all(const RenderArguments& arguments) {
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

void tell(const RenderArguments& arguments, const Scene& scene, const RenderReport& report) {
    if (arguments.quiet && !arguments.timings) return;
    fmt::print("{}: {} frames, {}, {:.1f} MB, {} collisions between particles, made in {:.1f} s\n",
               report.path.string(), report.frames, clock_text(scene.film.seconds),
               1e-6 * static_cast<double>(report.bytes), report.collisions.particle,
               report.wall_seconds);
    if (arguments.timings) report_timings(report);
}

void render_scenes(const RenderArguments& arguments) {
    refuse_same_outputs(arguments);
    const std::vector<Scene> scenes = load_all(arguments);
    for (const Scene& scene : scenes) require_letters(scene);
    for (const Scene& scene : scenes) {
        Progress progress(Progress::fitting_form(arguments.quiet),
                          fs::path(scene.source.path).stem().string());
        const RenderOptions options{.output = film_path(arguments, scene.source.path),
                                    .quality = quality_of(arguments.quality),
                                    .threads = threads_of(arguments)};
        tell(arguments, scene, render(scene, options, progress));
    }
}

}  // namespace

void add_render(CLI::App& app) {
    CLI::App& command = *app.add_subcommand("render", "render the films of scenes");
    const auto arguments = std::make_shared<RenderArguments>();
    command.add_option("scenes", arguments->scenes, "scene files")->required();
    command.add_option(
        "-o,--output", arguments->output,
        "the film (.mp4 or .webm), an existing folder for it, or a new folder with a slash "
        "for its frames as PNG (frames/); out/SCENE.mp4 if not given");
    add_scene_options(command, *arguments);
    add_picture_options(command, *arguments);
    add_shortcut(command, *arguments, "--fps", "film.fps", "frames a second");
    add_shortcut(command, *arguments, "--seconds", "film.seconds", "length of the film");
    command.add_option("--quality", arguments->quality, "draft, standard or final")
        ->check(CLI::IsMember({"draft", "standard", "final"}));
    add_work_options(command, *arguments);
    command.callback([arguments] { render_scenes(*arguments); });
}

}  // namespace carom
