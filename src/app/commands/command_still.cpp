// carom still: one frame of a film.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/command.h"
#include "app/depfile.h"
#include "app/film/film_request.h"
#include "app/output.h"
#include "draw/machine_resources.h"
#include "films/cost/work.h"
#include "films/render.h"
#include "films/words/letters.h"
#include "runs/own_files.h"
#include "scene/scene.h"
#include "util/diagnostics.h"
#include "util/files/atomic_file.h"
#include "util/interrupt.h"
#include "util/text.h"

namespace carom {
namespace {

struct StillArguments : SceneOptions {
    std::string scene;
    std::string output, format, depfile, cache;
    double at = 0.0;
    bool is_quick = false;
};

// The path of the picture; for standard output, a device or a pipe, the path that it would have as
// a file.
std::filesystem::path still_path(const StillArguments& arguments) {
    const std::string &output = arguments.output, &format = arguments.format;
    std::vector<std::string> extensions;
    for (const std::string& name : still_formats()) extensions.push_back("." + name);
    if (Output::is_stream(output)) {
        const std::string extension = ending_of(output);
        if (std::ranges::count(extensions, extension) == 0)
            return "still." + (format.empty() ? "png" : format);
        refuse_other_format(output, format);
        return "still" + extension;
    }
    std::rotate(extensions.begin(),
                std::ranges::find(extensions, "." + (format.empty() ? "png" : format)),
                extensions.end());
    const std::filesystem::path path = output_path(output, false, arguments.scene, extensions);
    if (!output.empty() && !names_folder(output)) refuse_other_format(output, format);
    return path;
}

void make_still(const StillArguments& arguments) {
    const Scene scene =
        load_scene(arguments.scene, resources_of(arguments), overrides_of(arguments));
    say_notes(arguments, scene);
    require_letters(scene);
    require_machine_resources(1, 0);
    if (!(arguments.at >= 0.0 && arguments.at <= scene.run.until))
        throw UsageError(
            fmt::format("--at {}: the scene runs from 0 to {}", arguments.at, scene.run.until));
    if (arguments.is_classroom)
        refuse_much_work(work_of_still(scene, arguments.is_quick, counts_of_film(scene)),
                         scene.source);
    const std::filesystem::path output = still_path(arguments);
    std::optional<Output> depfile;
    if (!arguments.depfile.empty()) {
        if (Output::is_stream(arguments.output))
            throw UsageError(
                "--depfile: the picture has no file that a rule could be about; name one with -o");
        const std::string rule = depfile_rule(std::vector{output.string()}, files_of(scene));
        depfile.emplace(arguments.depfile).write(rule);
    }
    Progress progress(Progress::fitting_form(arguments.quiet), scene_stem(arguments.scene));
    const OutputFormat& format = output_format(ending_of(output).substr(1));
    std::optional<Output> stream;  // before the work
    if (Output::is_stream(arguments.output)) stream.emplace(arguments.output);
    const EndsAtOnce whole;
    Still still = draw_still_alone(scene, arguments.at, arguments.is_quick, arguments.cache, format,
                                   progress);
    const std::vector<std::uint8_t> bytes = still.picture.file();
    if (still.frames_seen < still.frames && !arguments.quiet)
        fmt::print(stderr,
                   "carom: axes, curves, averages and trails are those of {} of the film's {} "
                   "frames (--quick)\n",
                   still.frames_seen, still.frames);
    if (stream) return stream->write({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    write_file(output, bytes);
    if (depfile) depfile->commit();
    if (!arguments.quiet) fmt::print("{}\n", printable(output.string()));
}

CommandText still_text() {
    return {
        {"carom still SCENE [--at T] [-o PICTURE] [options]"},
        "Draws the frame of the film that is nearest to simulated time T; without --at, the first. "
        "SVG and PDF contain lines, curves and text, and no pixels; the text of a PDF can be "
        "searched.",
        {{"carom still scenes/one-hot-particle.yaml --at 3", "writes out/one-hot-particle.png"},
         {"carom still scenes/one-hot-particle.yaml --at 3 -o frame.pdf --theme print",
          "the same frame for print"},
         {"carom still scenes/mixed-masses.yaml --template minimal --ground none -o gas.svg",
          "another layout on a transparent background"}}};
}

}  // namespace

Command still_command() {
    const auto arguments = std::make_shared<StillArguments>();
    StillArguments& its = *arguments;
    return {
        "still", "draw one frame of a film as PNG, SVG or PDF",
        joined<Option>({{{"scene", "a scene file; - for standard input", &its.scene},
                         {"--at T", "simulated time; the nearest frame is drawn", &its.at},
                         {"--quick",
                          "draw axes, colour scales, curves, averages and trails from about thirty "
                          "samples of the run, not from all frames",
                          &its.is_quick},
                         cache_option(its.cache),
                         {"-o,--output PICTURE",
                          "the picture (.png, .svg, .pdf; - for standard output), or a folder; "
                          "default: out/SCENE.png",
                          &its.output},
                         {"--format", "png, svg or pdf", &its.format, still_formats()},
                         depfile_option(its.depfile)},
                        scene_options(its),
                        {limits_option(its.is_classroom)},
                        picture_options(its)}),
        [arguments] { make_still(*arguments); }, still_text()};
}

}  // namespace carom
