#include "films/film_plan.h"

#include <algorithm>
#include <utility>

#include "films/axes_cache.h"
#include "films/segment_workers.h"
#include "media/formats.h"
#include "media/gif_palette.h"
#include "panels/archived.h"
#include "panels/precision.h"
#include "panels/registry.h"
#include "physics/sample_times.h"
#include "runs/own_files.h"
#include "runs/run_progress.h"
#include "scene/limits.h"
#include "scene/load.h"
#include "scene/panel_kind.h"
#include "scene/time/timeline.h"
#include "sound/film_sound.h"
#include "util/text.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

// The data from which a plan's scene is made again, and with which it is checked that nothing has
// changed.
struct SceneRecord {
    std::string program = CAROM_VERSION;
    SceneSource source;
    RunBits bits;

    void archive(Archive& archive) {
        archive(program, source.path, source.text, source.template_text, source.overrides,
                source.files, bits);
    }
};

SceneRecord record_of(const Scene& scene) {
    return {.source = scene.source, .bits = bits_of(scene)};
}

Scene scene_of(const SceneRecord& record, const Archive& archive) {
    if (record.program != CAROM_VERSION)
        archive.refuse("it was written by carom " + record.program);
    Scene scene = scene_from(record.source);
    if (scene.source.template_text != record.source.template_text)
        archive.refuse("the template of its film has changed");
    return with_bits(std::move(scene), record.bits);
}

// Archives the options of a film. Its output path is not restored: the reader is asked for it
// again.
void archive_options(Archive& archive, FilmOptions& options) {
    std::string output = options.output.string();
    archive(output, options.quality, options.from, options.to);
    if (!archive.is_reading()) return;
    // Only the format is taken from the archived path, which is replaced by a dummy.
    options.output = fs::path(output).has_filename()
                         ? fs::path("film").replace_extension(fs::path(output).extension())
                         : fs::path("film/");
    if (options.quality < Quality::draft || options.quality > Quality::final_)
        archive.refuse("it is of an unknown quality");
}

void archive_shared(Archive& archive, FilmPlan& plan) {
    archive(plan.span, plan.segments, plan.starts, plan.axes, plan.colors, plan.text, plan.passes);
}

bool fits_together(const FilmPlan& plan) {
    const auto is_start = [](const RunStart& start, const Scene* scene) {
        return are_of(start.particles, scene->gas.species.size()) &&
               is_of(start.sample, scene->gas.box, start.particles.count());
    };
    const std::vector<int>& segments = plan.segments;
    if (plan.span.first < 0 || plan.span.end > frame_count(plan.scene.film) || plan.frames() <= 0 ||
        segments.size() < 2 || segments.front() != 0 || segments.back() != plan.frames() ||
        std::ranges::adjacent_find(segments, std::ranges::greater_equal{}) != segments.end())
        return false;
    return std::ranges::equal(plan.starts, scenes_of_film(plan.scene), is_start);
}

// The box as in a simulation of the gas: heat baths draw velocities with the seed of the gas.
Box box_of(const Gas& gas) {
    Box box = gas.box;
    box.surfaces.seed = gas.seed;
    return box;
}

void archive_run(Archive& archive, FilmPlan& plan) {
    archive(plan.progress);
    const std::vector<const Scene*> scenes = scenes_of_film(plan.scene);
    plan.runs.resize(scenes.size());
    for (std::size_t k = 0; k < scenes.size(); ++k)
        plan.runs[k].archive(archive, box_of(scenes[k]->gas), plan.starts.at(k).particles,
                             scenes[k]->run);
}

// Bytes for stored parts of the paths of particles: for trails, and for panels that average over
// all starting times.
double memory_of_ways(const Scene& scene, double particles) {
    constexpr double of_trail = 1000.0, of_place = 250.0, of_lags = 7000.0;  // measured peaks
    const Film& film = scene.film;
    double bytes = 0.0;
    const auto add_trails = [&](double count, double seconds) {
        if (seconds > 0.0) bytes += count * (of_trail + of_place * seconds * film.fps);
    };
    for (std::size_t k = 0; k < scene.looks.size(); ++k)
        add_trails(static_cast<double>(scene.gas.species[k].count),
                   scene.looks[k].trail.value_or(0.0));
    for (const Chosen& chosen : film.trails.of)
        add_trails(chosen.particle  ? 1.0
                   : chosen.species ? static_cast<double>(scene.gas.species[*chosen.species].count)
                                    : particles,
                   film.trails.seconds);
    for (const PanelSpec& panel : film.panels) {
        const PanelWork work = work_of(panel, scene.run);
        if (work.flights == PanelWork::Flights::lags)
            bytes += of_lags * particles;
        else if (work.keeps_places)  // of both runs
            bytes += sizeof(Vec) * std::min(particles, 2.0 * most_in_both_runs.value) *
                     (frame_count(film) + static_cast<double>(sample_count(scene.run)));
    }
    return bytes;
}

}  // namespace

std::unique_ptr<PanelSet> FilmPlan::panels() const {
    auto set = std::make_unique<PanelSet>(scene, starts);
    Archive archive(axes, "what the first pass has fixed");
    set->archive(archive);
    archive.expect_end();
    if (!progress.empty()) {
        Archive so_far(progress, "how far the panels are");
        set->archive_progress(so_far);
        so_far.expect_end();
    }
    return set;
}

FilmFrames::FilmFrames(const FilmPlan& plan) : panels_(plan.panels()), player_(plan.runs) {}

void FilmFrames::go_to(std::size_t end, const Taker& take, bool ends_still) {
    while (player_.shown() < end) {
        player_.next();
        const bool is_still = ends_still && player_.shown() == end;
        const std::vector<RunFrame> runs = player_.frames();
        take(panels_->frame_data(player_.tick(), runs, is_still), runs.front().advanced);
    }
}

FilmPlan FilmFrames::rest(FilmPlan without_runs, std::size_t end) const {
    FilmPlan part = std::move(without_runs);
    Archive progress;
    panels_->archive_progress(progress);
    part.progress = progress.finished();
    part.runs = player_.rest(end);
    return part;
}

int frames_of(const Scene& scene, const FilmOptions& options) {
    if (!options.from && !options.to) return frame_count(scene.film);
    return frames_between(scene.film, timeline(scene), options.from, options.to).frames();
}

bool has_sound(const Scene& scene, const OutputFormat& format) {
    return scene.film.sound && format.sound;
}

std::int64_t memory_of_film(const Scene& scene, const OutputFormat& format, std::int64_t particles,
                            const FilmCollisions& collisions, int threads) {
    constexpr double of_program = 120e6, of_particle = 1500.0;
    constexpr double of_kept_particle = 40.0, of_frame = 8192.0;  // bytes, recorded or waiting
    constexpr double of_filed_frame = 512.0;  // bytes; samples are in a temporary file
    constexpr double most_of_pixel = 0.5;  // encoded bytes per pixel; PNGs of dense gases have 0.2
    constexpr double most_kept = static_cast<double>(Recording::most_bytes) + most_waiting_bytes;
    const double pixels = static_cast<double>(scene.film.size.width) * scene.film.size.height;
    const int frames = frame_count(scene.film);
    const double disks =
        static_cast<double>(particles) * static_cast<double>(scene.film.runs.count());
    const std::vector<int> segments = segment_starts(frames, particles);
    const auto workers = static_cast<double>(std::clamp<std::size_t>(
        static_cast<std::size_t>(std::max(1, threads)), 1, segments.size() - 1));
    // Two encoded segments per worker: one that is growing, and one that is finished and waits to
    // be joined.
    const double encoded =
        std::min(frames * most_of_pixel * pixels, 2.0 * workers * most_encoded_bytes);
    const double of_collisions = sizeof(Collision) * collisions.count;
    const double kept = std::min(
        most_kept + frames * of_filed_frame,
        frames * (of_frame + of_kept_particle * disks) + (collisions.kept ? of_collisions : 0.0));
    // Collisions of one frame: a growing list, its copy on the way to the panels, and the list that
    // is kept.
    const bool are_seen = collisions.kept || has_sound(scene, format);
    const double of_one_frame = are_seen ? 4.0 * of_collisions / frames : 0.0;
    const double sound =
        has_sound(scene, format)
            ? frames / scene.film.fps * (sizeof(std::int16_t) * sound_rate + format.sound->bytes)
            : 0.0;
    const double previews = 4.0 * pixels * std::min(format.previews, frames);
    return static_cast<std::int64_t>(
        of_program + of_particle * disks + memory_of_ways(scene, disks) + kept + of_one_frame +
        2.0 * encoded + sound + previews + workers * format.film->memory_per_pixel * pixels);
}

std::string shared_bytes(FilmPlan& plan, FilmOptions& options) {
    Archive archive;
    SceneRecord record = record_of(plan.scene);
    archive(record);
    archive_options(archive, options);
    archive_shared(archive, plan);
    return archive.finished();
}

FilmPlan read_shared(std::string bytes, const std::string& name, FilmOptions& options) {
    Archive archive(std::move(bytes), name);
    SceneRecord record;
    archive(record);
    FilmPlan plan;
    plan.scene = scene_of(record, archive);
    archive_options(archive, options);
    archive_shared(archive, plan);
    archive.expect_end();
    if (!fits_together(plan)) archive.refuse("its parts do not fit together");
    return plan;
}

std::string run_bytes(FilmPlan& plan) {
    Archive archive;
    archive_run(archive, plan);
    return archive.finished();
}

void read_run(FilmPlan& plan, std::string bytes, const std::string& name) {
    Archive archive(std::move(bytes), name);
    archive_run(archive, plan);
    archive.expect_end();
}

}  // namespace carom
