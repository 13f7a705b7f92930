#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "films/cost/film_cost.h"
#include "films/cost/panel_seconds.h"
#include "films/cost/work_parts.h"
#include "films/first_pass.h"
#include "scene/time/timeline.h"

namespace carom {
namespace {

constexpr double of_frame = 0.035e-6;  // CPU seconds of a particle in a frame that panels see
constexpr double of_picture = 1e-3;    // of a frame of a film, however small
constexpr double pixels_of_formats = 1920.0 * 1080.0;  // of the frames that formats were timed with

// How often the run of a film is simulated for its axes and pictures.
double passes_of_film(const Scene& scene) {
    const auto runs = static_cast<double>(scene.film.runs.count());
    const std::vector<std::string> passes =
        expected_passes(scene, static_cast<std::int64_t>(runs * count_of(scene)));
    return static_cast<double>(
        std::ranges::count_if(passes, [](const std::string& one) { return one != "precision"; }));
}

std::vector<SeeingPanel> panels_of_film(const Scene& scene, double frames) {
    std::vector<SeeingPanel> panels;
    for (const PanelSpec& panel : scene.film.panels)
        panels.push_back(
            {fmt::format("the panel `{}`", panel.kind), panel, panel.at ? 1.0 : frames});
    return panels;
}

// The moments of a run that its panels see: so many frames, and samples.
double moments_seen(const Scene& scene, double frames, bool sees_samples) {
    return frames + (sees_samples && !scene.film.panels.empty() ? samples_of(scene.run) : 0.0);
}

// The first pass of a film.
std::vector<WorkPart> first_pass(const Scene& scene, double passes, double frames,
                                 bool sees_samples, const SceneCounts& counts) {
    std::vector<WorkPart> parts;
    double seeds = scene.film.trails.seeds;  // of the film's own run, which comes first
    const std::vector<const Scene*> scenes = scenes_of_film(scene);
    for (std::size_t k = 0; k < scenes.size(); ++k) {
        const Scene& run = *scenes[k];
        std::ranges::move(panel_parts(run, panels_of_film(run, frames),
                                      moments_seen(run, frames, sees_samples), counts.at(k), 1.0),
                          std::back_inserter(parts));
        parts.push_back(simulation_part(run, counts.at(k), passes + std::exchange(seeds, 0.0)));
    }
    return parts;
}

FilmCollisions film_collisions(const SceneCounts& counts) {
    double all = 0.0;
    for (const RunCounts& run : counts) all += collisions_of(run);
    return {.count = all, .kept = true};
}

}  // namespace

std::vector<WorkPart> panel_parts(const Scene& scene, const std::vector<SeeingPanel>& panels,
                                  double frames, const RunCounts& counts, double times) {
    std::vector<WorkPart> parts;
    for (const auto& [what, panel, pictures] : panels) {
        const double seconds = panel_seconds(scene, panel, frames, pictures, counts);
        parts.push_back(
            {.what = what,
             .reduce = (times > 1.0 ? "`seeds`, " : "") + reduces_panel(panel, scene.run),
             .seconds = times * seconds,
             .place = panel.place});
    }
    parts.push_back(
        {.what = fmt::format("{} frames of {} particles", about(times * frames),
                             about(count_of(scene))),
         .reduce = times > 1.0 ? "`seeds` or the particles" : "the particles",
         .seconds = times * frames * count_of(scene) * (of_frame + seconds_of_look(counts.bits))});
    return parts;
}

SceneCounts counts_of_film(const Scene& scene) {
    SceneCounts counts;
    for (const Scene* run : scenes_of_film(scene)) counts.push_back(counts_of(*run));
    return counts;
}

Work work_of_film(const Scene& scene, const FilmOptions& options, const OutputFormat& format,
                  const SceneCounts& counts) {
    const Film& film = scene.film;
    const double frames = frames_of(scene, options);
    const double disks = count_of(scene) * static_cast<double>(film.runs.count());
    const double pixels = static_cast<double>(film.size.width) * film.size.height;
    Work work{.parts = first_pass(scene, passes_of_film(scene), frame_count(film), true, counts),
              .memory = static_cast<double>(memory_of_film(scene, format, total_count(scene.gas),
                                                           film_collisions(counts), 1)),
              .bytes = frames * format.film->frame_bytes(disks, pixels, options.quality) +
                       bytes_of_sound(scene, format, static_cast<int>(frames)),
              .reduces_memory = "`film.size` or the particles",
              .reduces_bytes = "`film.size`, `film.fps` or `film.seconds`"};
    work.parts.push_back(
        {.what = fmt::format("{} frames of {} by {} as {}", about(frames), film.size.width,
                             film.size.height, format.name),
         .reduce = work.reduces_bytes,
         .seconds = format.film->seconds_before(pixels) +
                    frames * of_picture * std::max(0.0, 1.0 - pixels / pixels_of_formats) +
                    frames * format.film->frame_seconds(disks, pixels, options.quality),
         .is_drawing = true});
    return work;
}

Work work_of_still(const Scene& scene, bool is_quick, const SceneCounts& counts) {
    constexpr double quick_frames = 30.0;
    const double frames = is_quick ? quick_frames : frame_count(scene.film);
    const OutputFormat& format = output_format("png");
    Work work = work_of_film(scene, {}, format, counts);
    const double pixels = static_cast<double>(scene.film.size.width) * scene.film.size.height;
    const double one = format.film->frame_seconds(count_of(scene), pixels, Quality::standard);
    work.parts = first_pass(scene, 1.0, frames, !is_quick, counts);
    work.parts.push_back({.what = "the picture", .reduce = "`film.size`", .seconds = one});
    work.bytes = format.film->frame_bytes(count_of(scene), pixels, Quality::standard);
    work.reduces_bytes = "`film.size`";
    return work;
}

Work work_of_measuring(const Scene& scene, const FilmOptions& options, const OutputFormat& format,
                       const SceneCounts& counts) {
    constexpr double most_drawn = 100.0;  // frames
    Work work = work_of_film(scene, options, format, counts);
    work.parts.back().seconds *= std::min(1.0, most_drawn / frames_of(scene, options));
    work.bytes = 0.0;
    return work;
}

void refuse_much_film(const Scene& scene, const FilmOptions& options, const OutputFormat& format,
                      int measures) {
    if (!scene.source.is_held_to_classroom) return;
    const SceneCounts counts = counts_of_film(scene);
    Work work = work_of_film(scene, options, format, counts);
    for (int k = 0; k < measures; ++k)
        work = together(work, work_of_measuring(scene, options, format, counts));
    refuse_much_work(work, scene.source);
}

}  // namespace carom
