#include "app/film/render.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "app/means.h"
#include "scene/time/timeline.h"
#include "util/interrupt.h"
#include "util/stopwatch.h"

namespace carom {
namespace {

// All that makes the film again: the seed, what the command line changed, and the scene itself.
std::string recipe(const Scene& scene, const FilmOptions& options) {
    std::string text = fmt::format("seed: {}\n", scene.seed);
    if (options.from) text += fmt::format("--from {}\n", *options.from);
    if (options.to) text += fmt::format("--to {}\n", *options.to);
    for (const std::string& change : scene.source.overrides)
        text += fmt::format("--set {}\n", change);
    return text + "\n" + scene.source.text;
}

Canvas blank_still(const Scene& scene, double time, const OutputFormat& format) {
    if (!format.vector) return FramePainter::blank(scene.film);
    return Canvas({scene.film.size.width, scene.film.size.height}, *format.vector,
                  {scene.title, say(scene.film.language, "The frame at time {}. {}",
                                    localised(scene.film.language, fmt::format("{:.4g}", time)),
                                    scene.description)});
}

RenderReport write_film(const FilmPlan& plan, const FilmOptions& options, FilmWriter& writer,
                        Progress& progress, const Stopwatch& watch) {
    RenderReport report;
    report.path = options.output;
    if (!plan.colors.empty()) writer.use_colors(plan.colors);
    draw_frames(plan, options.threads, writer, progress, report);
    throw_if_interrupted();
    report.simulate_seconds = watch.cpu();
    commit_with_text(writer, options.text ? &plan.text : nullptr, options.output);
    report.bytes = writer.bytes();
    report.wall_seconds = watch.wall();
    return report;
}

}  // namespace

void draw_frames(const FilmPlan& plan, int threads, FilmWriter& writer, Progress& progress,
                 RenderReport& report) {
    const std::unique_ptr<PanelSet> panels = plan.panels();
    progress.begin("rendering", static_cast<double>(plan.frames()));
    SegmentWorkers workers(*panels, plan.segments, threads, writer, progress);
    CollisionCounts collisions;
    plan.run.play(plan.frames_to_play(),
                  [&](const Tick& tick, const Sample& sample, const AdvanceResult& advanced) {
                      collisions = advanced.counts;
                      FrameData frame = panels->frame_data(tick, sample, advanced);
                      if (tick.frame >= plan.span.first) workers.frame(std::move(frame));
                  });
    const WorkerSeconds seconds = workers.finish();
    const std::vector<std::string> cut = FramePainter(*panels).cut_words();
    report.cut.insert(report.cut.end(), cut.begin(), cut.end());
    progress.finish();
    report.workers.draw += seconds.draw;
    report.workers.encode += seconds.encode;
    report.frames += plan.frames();
    report.passes.insert(report.passes.end(), plan.passes.begin(), plan.passes.end());
    report.collisions.particle += collisions.particle;
    report.collisions.wall += collisions.wall;
    report.collisions.ties += collisions.ties;
}

std::unique_ptr<FilmWriter> film_writer(const FilmPlan& plan, const FilmOptions& options,
                                        std::vector<FilmChapter> chapters) {
    const Scene& scene = plan.scene;
    const Film& film = scene.film;
    const int threads =
        std::clamp(options.threads, 1, std::max(1, static_cast<int>(plan.segments.size()) - 1));
    const double pixels = static_cast<double>(film.size.width) * film.size.height;
    const FormatCost& cost = *format_of_film(options.output).film;
    require_means(threads, static_cast<std::size_t>(threads * cost.memory_per_pixel * pixels));
    return film_writer(options.output,
                       {.width = film.size.width,
                        .height = film.size.height,
                        .fps = film.fps,
                        .quality = options.quality,
                        .transparent = film.transparent,
                        .behind = to_pixel(page_color(film)),
                        .metadata = {{"title", scene.title},
                                     {"description", scene.description},
                                     {"comment", recipe(scene, options)}},
                        .chapters = std::move(chapters)},
                       plan.frames());
}

RenderReport render(const Scene& scene, const FilmOptions& options, Progress& progress) {
    const Stopwatch watch;
    // Opened before the work, as it may not be allowed to write; but not for a gas that finds no
    // room.
    std::unique_ptr<FilmWriter> writer;
    const FilmPlan plan = prepare(scene, options, progress, [&](const FilmPlan& placed) {
        writer = film_writer(placed, options);
    });
    return write_film(plan, options, *writer, progress, watch);
}

RenderReport render(const FilmPlan& plan, const FilmOptions& options, Progress& progress) {
    return write_film(plan, options, *film_writer(plan, options), progress, {});
}

Canvas draw_still(const FilmPlan& plan, double at, const OutputFormat& format, Progress& progress) {
    const auto end = static_cast<std::size_t>(frame_nearest_to(plan.run.ticks(), at)) + 1;
    const std::unique_ptr<PanelSet> panels = plan.panels();
    progress.begin("preparing the frame", static_cast<double>(end));
    FrameData frame;
    std::size_t played = 0;
    plan.run.play(end, [&](const Tick& tick, const Sample& sample, const AdvanceResult& advanced) {
        const bool is_last = ++played == end;
        frame = panels->frame_data(tick, sample, advanced, is_last);
        progress.advance();
    });
    progress.finish();
    FramePainter painter(*panels);
    Canvas canvas = blank_still(plan.scene, frame.tick.time, format);
    painter.paint_on(canvas, frame);
    return canvas;
}

}  // namespace carom
