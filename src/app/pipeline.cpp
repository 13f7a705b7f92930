#include "app/pipeline.h"

#include <fmt/format.h>

#include <cmath>
#include <ctime>

#include "app/segment_workers.h"
#include "app/simulate.h"
#include "media/image_writer.h"
#include "panels/frame.h"
#include "scene/timeline.h"
#include "util/interrupt.h"

namespace carom {
namespace {

double seconds_of(clockid_t clock) {
    timespec time = {};
    clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// All that makes the film again: the seed, what the command line changed, and the scene itself.
std::string recipe(const Scene& scene) {
    std::string text = fmt::format("seed: {}\n", scene.seed);
    for (const std::string& change : scene.source.overrides)
        text += fmt::format("--set {}\n", change);
    return text + "\n" + scene.source.text;
}

VideoSettings video_settings(const Scene& scene, Quality quality) {
    return {.width = scene.film.size.width,
            .height = scene.film.size.height,
            .fps = scene.film.fps,
            .quality = quality,
            .metadata = {{"title", scene.title},
                         {"description", scene.description},
                         {"comment", recipe(scene)}}};
}

// The physics alone, so that axes and scales hold for the whole film.
void survey(const std::vector<Tick>& ticks, Simulation simulation, Observers& observers,
            Progress& progress) {
    progress.begin("simulating", static_cast<double>(ticks.size()));
    for (const Tick& tick : ticks) {
        throw_if_interrupted();
        const Passage passage = simulation.advance_to(tick.time);
        observers.survey(tick, simulation.sample(), passage);
        progress.advance();
    }
    observers.settle();
}

Canvas picture(const Scene& scene, double time, const std::filesystem::path& extension) {
    const PixelSize size{scene.film.size.width, scene.film.size.height};
    if (extension == ".png") return Canvas(size);
    return Canvas(
        size, extension == ".svg" ? VectorFormat::svg : VectorFormat::pdf,
        {scene.title, fmt::format("The frame at time {:.4g}. {}", time, scene.description)});
}

}  // namespace

RenderReport render(const Scene& scene, const RenderOptions& options, Progress& progress) {
    const double begun = seconds_of(CLOCK_MONOTONIC);
    const double cpu_begun = seconds_of(CLOCK_THREAD_CPUTIME_ID);
    Simulation simulation = simulate(scene);
    // Before the work: it may not be allowed to write.
    const std::unique_ptr<FilmWriter> writer = film_writer(
        options.output, video_settings(scene, options.quality), frame_count(scene.film));

    const std::vector<Tick> ticks = timeline(scene);
    Observers observers(scene, simulation.particles(), simulation.sample());
    survey(ticks, simulate(scene), observers, progress);

    progress.begin("rendering", static_cast<double>(ticks.size()));
    simulation.record_collisions(observers.wants_collisions());
    RenderReport report;
    report.path = options.output;
    report.frames = static_cast<int>(ticks.size());
    SegmentWorkers workers(scene, observers,
                           segment_starts(report.frames, simulation.particles().count()),
                           options.threads, *writer, progress);
    for (const Tick& tick : ticks) {
        throw_if_interrupted();
        const Passage passage = simulation.advance_to(tick.time);
        report.collisions = passage.counts;
        workers.frame(observers.frame_data(tick, simulation.sample(), passage));
    }
    report.simulate_seconds = seconds_of(CLOCK_THREAD_CPUTIME_ID) - cpu_begun;
    const WorkerSeconds seconds = workers.finish();
    throw_if_interrupted();
    writer->commit();
    progress.finish();

    report.bytes = writer->bytes();
    report.draw_seconds = seconds.draw;
    report.encode_seconds = seconds.encode;
    report.wall_seconds = seconds_of(CLOCK_MONOTONIC) - begun;
    return report;
}

void render_still(const Scene& scene, double at, const std::filesystem::path& output) {
    const std::vector<Tick> ticks = timeline(scene);
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < ticks.size(); ++i)
        if (std::abs(ticks[i].time - at) < std::abs(ticks[nearest].time - at)) nearest = i;

    Progress silent(Progress::Form::silent, "");
    Simulation simulation = simulate(scene);
    Observers observers(scene, simulation.particles(), simulation.sample());
    survey(ticks, simulate(scene), observers, silent);
    simulation.record_collisions(observers.wants_collisions());
    FrameData frame;
    for (std::size_t i = 0; i <= nearest; ++i) {
        throw_if_interrupted();
        const Passage passage = simulation.advance_to(ticks[i].time);
        frame = observers.frame_data(ticks[i], simulation.sample(), passage);
    }
    FramePainter painter(scene, observers);
    Canvas canvas = picture(scene, frame.tick.time, output.extension());
    painter.paint_on(canvas, frame);
    write_image(canvas, output);
}

}  // namespace carom
