// carom still: one frame of a film.
#include <fmt/format.h>

#include <memory>

#include "app/command.h"
#include "app/letters.h"
#include "app/pipeline.h"
#include "app/resources.h"
#include "util/diagnostics.h"

namespace carom {
namespace {

struct StillArguments : SceneOptions {
    std::string scene;
    std::string output;
    double at = 0.0;
};

void draw_still(const StillArguments& arguments) {
    const Scene scene = load_scene(arguments.scene, templates_folder(), overrides_of(arguments));
    require_letters(scene);
    if (!(arguments.at >= 0.0 && arguments.at <= scene.run.until))
        throw UsageError(
            fmt::format("--at {}: the scene runs from 0 to {}", arguments.at, scene.run.until));
    const std::filesystem::path output =
        output_path(arguments.output, false, arguments.scene, {".png", ".svg", ".pdf"});
    render_still(scene, arguments.at, output);
    if (!arguments.quiet) fmt::print("{}\n", output.string());
}

}  // namespace

void add_still(CLI::App& app) {
    CLI::App& command =
        *app.add_subcommand("still", "draw one frame of a film as a PNG, SVG or PDF");
    const auto arguments = std::make_shared<StillArguments>();
    command.add_option("scene", arguments->scene, "a scene file")->required();
    command.add_option("--at", arguments->at, "simulated time; the nearest frame is drawn");
    command.add_option("-o,--output", arguments->output,
                       "the picture (.png, .svg, .pdf), or a folder; out/SCENE.png if not given");
    add_scene_options(command, *arguments);
    add_picture_options(command, *arguments);
    command.callback([arguments] { draw_still(*arguments); });
}

}  // namespace carom
