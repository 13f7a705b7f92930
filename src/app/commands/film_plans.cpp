#include "app/commands/film_plans.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "app/commands/render_words.h"
#include "app/film/film_path.h"
#include "app/film/film_request.h"
#include "app/output.h"
#include "films/cost/work.h"
#include "films/film_checks.h"
#include "media/formats.h"
#include "runs/own_files.h"
#include "util/diagnostics.h"
#include "util/joined.h"
#include "util/text.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

fs::path folder_of_film(const std::string& scene, const std::string& output, bool several) {
    if (output.empty()) return fs::path("out") / (scene_stem(scene) + ".plan");
    return several ? fs::path(output) / scene_stem(scene) : fs::path(output);
}

// The chunks of a film make one file, so that its format is known from the start.
const OutputFormat& format_of(const FilmPlanArguments& arguments) {
    return output_format(arguments.format.empty() ? "mp4" : arguments.format);
}

std::string report_of(const fs::path& folder, const FilmPlanReport& report) {
    std::string text =
        fmt::format("{}: {}, {}", printable(folder.string()), counted(report.frames, "frame"),
                    counted(report.chunks, "chunk"));
    text += report.is_new ? fmt::format(", planned in {:.1f} s\n", report.wall_seconds)
                          : std::string(", planned before (--force plans again)\n");
    return text;
}

void refuse_same_folders(const std::vector<std::string>& scenes) {
    refuse_second_standard_input(scenes);
    std::vector<std::string> stems;
    for (const std::string& scene : scenes) {
        const std::string stem = scene_stem(scene);
        if (std::ranges::find(stems, stem) != stems.end())
            throw UsageError(fmt::format(
                "two scenes are called {}, and their plans would go into one folder; plan them "
                "one by one with -o",
                stem));
        stems.push_back(stem);
    }
}

FilmDivision division_of(const FilmPlanArguments& arguments) {
    if (arguments.chunks > 0 && arguments.chunk_seconds)
        throw UsageError("--chunks and --chunk-seconds cannot be combined");
    if (arguments.chunk_seconds && !(*arguments.chunk_seconds > 0.0))
        throw UsageError(
            fmt::format("--chunk-seconds {}: expected more than 0", *arguments.chunk_seconds));
    FilmDivision division{.seconds = arguments.chunk_seconds};
    if (arguments.chunks > 0) division.chunks = arguments.chunks;
    return division;
}

}  // namespace

std::vector<Option> film_plan_options(SceneOptions& options, FilmPlanArguments& arguments) {
    return joined<Option>(
        {{{"--chunk-seconds S", "for films: make chunks that take S seconds each, on one core",
           &arguments.chunk_seconds},
          {"--format", "for films: mp4, webm, gif, or png for single frames", &arguments.format,
           chunk_formats()}},
         picture_options(options),
         film_options(options, arguments.film)});
}

void plan_films(const std::vector<std::string>& scenes, const std::string& output,
                const FilmPlanArguments& arguments, const SceneOptions& options) {
    if (Output::is_standard_output(output))
        throw UsageError("-o -: a plan is several files; name a folder");
    refuse_same_folders(scenes);
    const FilmDivision division = division_of(arguments);
    const SceneResources resources = resources_of(options);
    const OutputFormat& format = format_of(arguments);
    const std::vector<Scene> loaded = all_made(scenes, [&](const std::string& name) {
        return load_scene(name, resources, overrides_of(options));
    });
    for (const Scene& scene : loaded) {
        say_notes(options, scene);
        refuse_unfit(scene, arguments.film, format);
        refuse_much_film(scene, arguments.film, format);
    }
    FilmOptions film = arguments.film;
    film.output = format.name == "png" ? "film/" : "film." + format.name;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        Progress progress(Progress::fitting_form(options.quiet), scene_stem(scenes[i]));
        const fs::path folder = folder_of_film(scenes[i], output, scenes.size() > 1);
        const FilmPlanReport report =
            plan_film(loaded[i], film, division, folder, arguments.force, progress);
        if (options.quiet) continue;
        Output("-").write(report_of(folder, report));
        if (loaded[i].film.sound && !format.sound) print_to_stderr(warning_of_silence(format));
        print_to_stderr(warning_of_cut(report.cut));
    }
}

void refuse_much_plan(const PlanFolder& folder) {
    SceneSource source = source_of_plan(folder);
    source.is_held_to_classroom = true;
    refuse_much_film(scene_from(source), options_of_plan(folder),
                     output_format(format_of_plan(folder)));
}

void render_chunks(const FilmChunkArguments& arguments) {
    const PlanFolder folder(arguments.plan);
    folder.require(PlanKind::film, "render");
    if (arguments.is_classroom) refuse_much_plan(folder);
    Progress progress(Progress::fitting_form(arguments.quiet), folder.path().filename().string());
    std::vector<int> numbers{arguments.chunk};
    if (arguments.chunk == 0) {
        numbers = arguments.how.force ? std::vector<int>{} : folder.missing();
        if (arguments.how.force)
            for (const PlannedChunk& chunk : folder.chunks()) numbers.push_back(chunk.number);
    }
    for (const int number : numbers) {
        const PlannedChunk& chunk = folder.chunk(number);
        const bool is_new = render_chunk(folder, chunk, arguments.how, progress);
        if (!arguments.quiet)
            fmt::print("{}: {}, {}\n", printable(folder.output(chunk).path().string()),
                       counted(chunk.count(), "frame"), is_new ? "done" : "was there already");
    }
}

void join_film(const PlanFolder& folder, const FilmJoinArguments& arguments) {
    if (Output::is_standard_output(arguments.output))
        throw UsageError("-o -: name a file; the film of a plan is not written to standard output");
    const std::string format = format_of_plan(folder);
    if (is_video(arguments.output) && format_of_film(arguments.output).name != format)
        throw UsageError(fmt::format("-o {}: {} was planned with --format {}", arguments.output,
                                     folder.path().string(), format));
    const fs::path output =
        film_path({.output = arguments.output, .format = format}, scene_of_plan(folder));
    Progress progress(Progress::fitting_form(arguments.quiet), output.filename().string());
    const RenderReport report = join_film(folder,
                                          {.output = output,
                                           .text = arguments.text,
                                           .poster = arguments.poster,
                                           .allow_mixed = arguments.allow_mixed},
                                          progress);
    if (!arguments.quiet)
        Output("-").write(fmt::format("{}: {}, {:.1f} MB, joined in {:.1f} s\n",
                                      printable(output.string()), counted(report.frames, "frame"),
                                      1e-6 * static_cast<double>(report.bytes),
                                      report.wall_seconds));
}

}  // namespace carom
