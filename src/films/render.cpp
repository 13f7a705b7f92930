#include "films/render.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "draw/machine_resources.h"
#include "draw/pages/pages.h"
#include "films/film_motion.h"
#include "films/film_plan.h"
#include "films/first_pass.h"
#include "panels/words_left_out.h"
#include "scene/load.h"
#include "scene/time/timeline.h"
#include "util/interrupt.h"
#include "util/stopwatch.h"

namespace carom {
namespace {

// The text from which the film can be made again: the seed, the changes of the command line, and
// the scene. Empty if the film shall not contain it.
std::string recipe(const Scene& scene, const FilmOptions& options) {
    if (!scene.film.has_recipe) return "";
    std::string text = fmt::format("seed: {}\n", scene.seed);
    if (options.from) text += fmt::format("--from {}\n", *options.from);
    if (options.to) text += fmt::format("--to {}\n", *options.to);
    for (const std::string& change : scene.source.overrides) text += text_of_change(change) + "\n";
    return text + "\n" + scene.source.text;
}

// `remark` is added to the description.
Canvas blank_still(const Scene& scene, double time, const std::string& remark,
                   const OutputFormat& format) {
    if (!format.vector) return FramePainter::blank(scene.film);
    const std::string description =
        say(scene.film.language, "The frame at time {}. {}",
            localised(scene.film.language, fmt::format("{:.4g}", time)), scene.description);
    return Canvas({scene.film.size.width, scene.film.size.height}, *format.vector,
                  {scene.title, description + (remark.empty() ? "" : " ") + remark});
}

Canvas paint_still(const PanelSet& panels, const FrameData& frame, const std::string& remark,
                   const OutputFormat& format) {
    FramePainter painter(panels);
    Canvas canvas = blank_still(panels.scene(), frame.tick.time, remark, format);
    painter.paint_on(canvas, frame);
    return canvas;
}

// What is to be known of a still whose panels have seen only some frames.
std::string remark_on(Language language, std::size_t frames_seen, std::size_t frames) {
    if (frames_seen == frames) return "";
    return say(language,
               "Axes, curves, averages and trails are computed from {} of the film’s {} frames.",
               frames_seen, frames);
}

// Draws each frame as a page of one document, in order.
template <typename Play>
WorkerSeconds draw_pages(const PanelSet& panels, const Play& play, Canvas& document,
                         Progress& progress) {
    WorkerSeconds seconds;
    FramePainter painter(panels);
    play([&](const FrameData& frame) {
        throw_if_interrupted();
        const Stopwatch watch;
        painter.paint_on(document, frame);
        end_page(document);
        seconds.draw += watch.cpu();
        progress.advance();
    });
    return seconds;
}

RenderReport write_film(const FilmPlan& plan, const FilmOptions& options, FilmWriter& writer,
                        Progress& progress, const Stopwatch& watch) {
    RenderReport report;
    report.path = options.output;
    if (!plan.colors.empty()) writer.use_colors(plan.colors);
    if (!plan.sound.empty()) writer.add_sound(0, plan.sound);
    report.lacks_sound = plan.scene.film.sound && plan.sound.empty();
    draw_frames(plan, options.threads, writer, progress, report);
    throw_if_interrupted();
    report.simulate_seconds = watch.cpu();
    finish_film(writer, plan.text, files_wanted(options.text, !plan.sound.empty()), options,
                report);
    report.wall_seconds = watch.wall();
    return report;
}

// Draws the frame before number `end` of a plan, as a still.
Canvas draw_frame(const FilmPlan& plan, std::size_t end, const std::string& remark,
                  const OutputFormat& format, Progress& progress) {
    FilmFrames frames(plan);
    progress.begin("preparing the frame", static_cast<double>(end));
    FrameData still;
    constexpr bool ends_still = true;
    frames.go_to(
        end,
        [&](FrameData frame, const AdvanceResult&) {
            still = std::move(frame);
            progress.advance();
        },
        ends_still);
    progress.finish();
    return paint_still(frames.panels(), still, remark, format);
}

}  // namespace

void draw_frames(const FilmPlan& plan, int threads, FilmWriter& writer, Progress& progress,
                 RenderReport& report) {
    FilmFrames frames(plan);
    const PanelSet& panels = frames.panels();
    progress.begin("rendering", static_cast<double>(plan.frames()));
    CollisionCounts collisions;
    PlotCallouts callouts(panels);
    const auto play = [&](const auto& take) {
        frames.go_to(plan.frames_to_play(), [&](FrameData frame, const AdvanceResult& advanced) {
            collisions = advanced.counts;
            if (frame.tick.frame < plan.span.first) return;
            callouts.see(frame);
            take(std::move(frame));
        });
    };
    WorkerSeconds seconds;
    if (writer.document() != nullptr) {
        seconds = draw_pages(panels, play, *writer.document(), progress);
    } else {
        SegmentWorkers workers(panels, plan.segments, threads, writer, progress);
        play([&](FrameData frame) { workers.frame(std::move(frame)); });
        seconds = workers.finish();
    }
    const std::vector<std::string> cut = words_without_room(panels, plan.ticks());
    report.cut.insert(report.cut.end(), cut.begin(), cut.end());
    const std::vector<std::string> never = callouts.never_shown();
    report.never_shown.insert(report.never_shown.end(), never.begin(), never.end());
    progress.finish();
    report.workers.draw += seconds.draw;
    report.workers.encode += seconds.encode;
    report.frames += plan.frames();
    report.passes.insert(report.passes.end(), plan.passes.begin(), plan.passes.end());
    report.collisions.particle += collisions.particle;
    report.collisions.wall += collisions.wall;
    report.collisions.ties.instants += collisions.ties.instants;
    report.collisions.ties.contacts += collisions.ties.contacts;
}

std::unique_ptr<FilmWriter> film_writer(const FilmPlan& plan, const FilmOptions& options,
                                        std::vector<FilmChapter> chapters) {
    const Scene& scene = plan.scene;
    const Film& film = scene.film;
    const int threads =
        std::clamp(options.threads, 1, std::max(1, static_cast<int>(plan.segments.size()) - 1));
    const double pixels = static_cast<double>(film.size.width) * film.size.height;
    const FormatCost& cost = *format_of_film(options.output).film;
    require_machine_resources(threads,
                              static_cast<std::size_t>(threads * cost.memory_per_pixel * pixels));
    return film_writer(options.output,
                       {.width = film.size.width,
                        .height = film.size.height,
                        .fps = film.fps,
                        .quality = options.quality,
                        .motion = motion_of(scene, plan.particles(), plan.starts.front().sample),
                        .transparent = film.transparent,
                        .behind = to_pixel(page_color(film)),
                        .metadata = {{"title", scene.title},
                                     {"description", scene.description},
                                     {"comment", recipe(scene, options)}},
                        .chapters = std::move(chapters),
                        .has_sound = has_sound(scene, format_of_film(options.output)),
                        .is_scratch = static_cast<bool>(options.take)},
                       plan.frames());
}

void finish_film(FilmWriter& writer, const FilmText& text, TextFiles wanted,
                 const FilmOptions& options, RenderReport& report) {
    writer.settle();
    report.bytes = writer.bytes();
    if (!fits(report, options)) return;
    if (options.take)
        options.take(writer);
    else
        commit_with_text(writer, text, wanted, options.output);
}

bool fits(const RenderReport& report, const FilmOptions& options) {
    return static_cast<double>(report.bytes) <= options.most_bytes;
}

RenderReport render(const Scene& scene, const FilmOptions& options, Progress& progress) {
    const Stopwatch watch;
    // Opened before the work, in case it cannot be written; but only after the gas has been placed.
    std::unique_ptr<FilmWriter> writer;
    const FilmPlan plan = prepare(scene, options, progress, [&](const FilmPlan& placed) {
        writer = film_writer(placed, options);
    });
    return write_film(plan, options, *writer, progress, watch);
}

RenderReport render(const FilmPlan& plan, const FilmOptions& options, Progress& progress) {
    return write_film(plan, options, *film_writer(plan, options), progress, {});
}

double time_of_poster(const Scene& scene, const FilmOptions& options) {
    constexpr double share = 0.3;  // of the part of the run that the film shows
    const double from = options.from.value_or(0.0), to = options.to.value_or(scene.run.until);
    return from + share * (to - from);
}

Canvas paint_still(const PanelSet& panels, const FrameData& frame, const OutputFormat& format) {
    return paint_still(panels, frame, "", format);
}

Canvas draw_still(const FilmPlan& plan, double at, const OutputFormat& format, Progress& progress) {
    const int frame = frame_nearest_to(plan.scene.film, plan.ticks(), at);
    return draw_frame(plan, static_cast<std::size_t>(frame) + 1, "", format, progress);
}

Still draw_still_alone(const Scene& scene, double at, bool is_quick,
                       const std::filesystem::path& cache, const OutputFormat& format,
                       Progress& progress) {
    const auto [plan, seen, frames] = prepare_still(scene, at, is_quick, cache, progress);
    const std::string remark = remark_on(plan.scene.film.language, seen, frames);
    return {draw_frame(plan, plan.ticks().size(), remark, format, progress), seen, frames};
}

}  // namespace carom
