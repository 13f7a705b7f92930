#include "app/film/pipeline.h"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <initializer_list>
#include <span>
#include <utility>

#include "app/film/film_words.h"
#include "app/film/frame_span.h"
#include "app/film/segment_workers.h"
#include "app/simulate.h"
#include "media/image_writer.h"
#include "panels/frame.h"
#include "panels/precision.h"
#include "scene/time/timeline.h"
#include "util/interrupt.h"

namespace carom {
namespace {

double seconds_of(clockid_t clock) {
    timespec time = {};
    clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// All that makes the film again: the seed, what the command line changed, and the scene itself.
std::string recipe(const Scene& scene, const RenderOptions& options) {
    std::string text = fmt::format("seed: {}\n", scene.seed);
    if (options.from) text += fmt::format("--from {}\n", *options.from);
    if (options.to) text += fmt::format("--to {}\n", *options.to);
    for (const std::string& change : scene.source.overrides)
        text += fmt::format("--set {}\n", change);
    return text + "\n" + scene.source.text;
}

VideoSettings video_settings(const Scene& scene, const RenderOptions& options) {
    return {.width = scene.film.size.width,
            .height = scene.film.size.height,
            .fps = scene.film.fps,
            .quality = options.quality,
            .transparent = scene.film.transparent,
            .behind = to_pixel(page_color(scene.film)),
            .metadata = {{"title", scene.title},
                         {"description", scene.description},
                         {"comment", recipe(scene, options)}}};
}

// The physics alone, so that axes and scales hold for the whole film.
void survey(const Scene& scene, const std::vector<Tick>& ticks, Simulation simulation,
            std::initializer_list<Observers*> all, Progress& progress) {
    progress.begin("simulating", static_cast<double>(ticks.size()));
    simulation.record_collisions(std::ranges::any_of(
        all, [](const Observers* observers) { return observers->surveys_collisions(); }));
    simulation.measure_return((*all.begin())->return_times(ticks));
    with_places_of_errors(scene, [&] {
        for (const Tick& tick : ticks) {
            throw_if_interrupted();
            const AdvanceResult advanced = simulation.advance_to(tick.time);
            const Sample sample = simulation.sample();
            for (Observers* observers : all) observers->survey(tick, sample, advanced);
            progress.advance();
        }
    });
    for (Observers* observers : all) observers->fix_axes();
}

// Frames of the whole film, evenly spread, drawn before it.
void show_previews(const Scene& scene, const std::vector<Tick>& ticks, const FrameSpan& span,
                   Observers& observers, FilmWriter& writer, Progress& progress) {
    Simulation simulation = simulate(scene, progress);
    progress.begin("choosing colours", static_cast<double>(span.end));
    simulation.record_collisions(observers.wants_collisions());
    FramePainter painter(scene, observers);
    const int wanted = std::min(writer.wanted_previews(), span.frames());
    int shown = 0;
    for (const Tick& tick : std::span(ticks).first(static_cast<std::size_t>(span.end))) {
        throw_if_interrupted();
        const AdvanceResult advanced = simulation.advance_to(tick.time);
        const FrameData frame = observers.frame_data(tick, simulation.sample(), advanced);
        const int next = span.first + (span.frames() - 1) * shown / std::max(1, wanted - 1);
        if (tick.frame == next && shown < wanted) {
            writer.preview(painter.paint(frame));
            ++shown;
        }
        progress.advance();
    }
    writer.previews_done();
}

Canvas picture(const Scene& scene, double time, std::string_view format) {
    const PixelSize size{scene.film.size.width, scene.film.size.height};
    if (format == "png") return FramePainter::blank(scene.film);
    return Canvas(
        size, format == "svg" ? VectorFormat::svg : VectorFormat::pdf,
        {scene.title, fmt::format("The frame at time {:.4g}. {}", time, scene.description)});
}

}  // namespace

RenderReport render(const Scene& asked, const RenderOptions& options, Progress& progress) {
    const double begun = seconds_of(CLOCK_MONOTONIC);
    const double cpu_begun = seconds_of(CLOCK_THREAD_CPUTIME_ID);
    const Scene scene = with_precision(asked, progress);
    Simulation simulation = simulate(scene, progress);
    const std::vector<Tick> ticks = timeline(scene);
    const FrameSpan span = frames_between(ticks, options.from, options.to);
    // Before the work: it may not be allowed to write.
    const std::unique_ptr<FilmWriter> writer =
        film_writer(options.output, video_settings(scene, options), span.frames());

    Observers observers(scene, simulation.particles(), simulation.sample());
    if (writer->wanted_previews() > 0) {
        Observers beforehand(scene, simulation.particles(), simulation.sample());
        survey(scene, ticks, simulate(scene, progress), {&observers, &beforehand}, progress);
        show_previews(scene, ticks, span, beforehand, *writer, progress);
    } else {
        survey(scene, ticks, simulate(scene, progress), {&observers}, progress);
    }

    FilmWords words;
    if (options.words) words = words_of_film(scene, span, progress);

    progress.begin("rendering", static_cast<double>(span.frames()));
    simulation.record_collisions(observers.wants_collisions());
    RenderReport report;
    report.path = options.output;
    report.frames = span.frames();
    SegmentWorkers workers(scene, observers,
                           segment_starts(report.frames, simulation.particles().count()),
                           options.threads, *writer, progress);
    for (const Tick& tick : std::span(ticks).first(static_cast<std::size_t>(span.end))) {
        throw_if_interrupted();
        const AdvanceResult advanced = simulation.advance_to(tick.time);
        report.collisions = advanced.counts;
        FrameData frame = observers.frame_data(tick, simulation.sample(), advanced);
        if (tick.frame >= span.first) workers.frame(std::move(frame));
    }
    report.simulate_seconds = seconds_of(CLOCK_THREAD_CPUTIME_ID) - cpu_begun;
    const WorkerSeconds seconds = workers.finish();
    throw_if_interrupted();
    writer->commit();
    if (options.words) write_words(words, options.output);
    progress.finish();

    report.bytes = writer->bytes();
    report.draw_seconds = seconds.draw;
    report.encode_seconds = seconds.encode;
    report.wall_seconds = seconds_of(CLOCK_MONOTONIC) - begun;
    return report;
}

Canvas draw_still(const Scene& asked, double at, std::string_view format, Progress& progress) {
    const Scene scene = with_precision(asked, progress);
    const std::vector<Tick> ticks = timeline(scene);
    const auto nearest = static_cast<std::size_t>(frame_nearest_to(ticks, at));

    Simulation simulation = simulate(scene, progress);
    Observers observers(scene, simulation.particles(), simulation.sample());
    survey(scene, ticks, simulate(scene, progress), {&observers}, progress);
    progress.begin("going to the frame", static_cast<double>(nearest + 1));
    simulation.record_collisions(observers.wants_collisions());
    FrameData frame;
    for (std::size_t i = 0; i <= nearest; ++i) {
        throw_if_interrupted();
        const AdvanceResult advanced = simulation.advance_to(ticks[i].time);
        frame = observers.frame_data(ticks[i], simulation.sample(), advanced);
        progress.advance();
    }
    progress.finish();
    FramePainter painter(scene, observers);
    Canvas canvas = picture(scene, frame.tick.time, format);
    painter.paint_on(canvas, frame);
    return canvas;
}

void render_still(const Scene& scene, double at, const std::filesystem::path& output,
                  Progress& progress) {
    Canvas picture = draw_still(scene, at, output.extension().string().substr(1), progress);
    write_image(picture, output);
}

}  // namespace carom
