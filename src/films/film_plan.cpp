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

// The palette of a film, chosen from `previews` of its frames, evenly spread.
std::vector<std::uint32_t> chosen_colors(const FilmPlan& plan, int previews, Progress& progress) {
    progress.begin("choosing colours", static_cast<double>(plan.span.end));
    FilmFrames frames(plan);
    FramePainter painter(frames.panels());
    PaletteMaker maker(plan.scene.film.size.width, plan.scene.film.size.height);
    const int wanted = std::min(previews, plan.frames());
    int shown = 0;
    frames.go_to(static_cast<std::size_t>(plan.span.end), [&](const FrameData& frame,
                                                              const AdvanceResult&) {
        const int next = plan.span.first + (plan.frames() - 1) * shown / std::max(1, wanted - 1);
        if (frame.tick.frame == next && shown < wanted) {
            maker.add(painter.paint(frame).pixels());
            ++shown;
        }
        progress.advance();
    });
    const GifPalette palette = maker.finish();
    return {palette.begin(), palette.end()};
}

// If the run is kept, one simulation serves both the first pass and the pictures.
std::vector<std::string> passes_for(const Scene& asked, bool settled, bool kept, bool text,
                                    bool sound, bool colors) {
    std::vector<std::string> passes;
    if (!asked.run.bits && !settled) passes.emplace_back("precision");
    std::vector<std::string> first;
    if (!settled) first.emplace_back("axes");
    if (text) first.emplace_back("words");
    if (sound) first.emplace_back("sound");
    std::vector<std::string> later;
    if (colors) later.emplace_back("colours");
    later.emplace_back("pictures");
    if (kept) first.insert(first.end(), later.begin(), later.end());
    if (!first.empty()) passes.push_back(listed(first));
    if (!kept) passes.insert(passes.end(), later.begin(), later.end());
    return passes;
}

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
    archive(plan.span, plan.segments, plan.particles, plan.start, plan.axes, plan.colors, plan.text,
            plan.passes);
    if (!plan.scene.film.beside) return;
    if (archive.is_reading()) plan.beside.emplace();
    archive(plan.beside->start);
}

bool fits_together(const FilmPlan& plan) {
    const auto is_start = [](const Scene& scene, const Particles& particles, const Sample& start) {
        return are_of(particles, scene.gas.species.size()) &&
               is_of(start, scene.gas.box, particles.count());
    };
    const std::vector<int>& segments = plan.segments;
    if (plan.span.first < 0 || plan.span.end > frame_count(plan.scene.film) || plan.frames() <= 0 ||
        segments.size() < 2 || segments.front() != 0 || segments.back() != plan.frames() ||
        std::ranges::adjacent_find(segments, std::ranges::greater_equal{}) != segments.end())
        return false;
    return is_start(plan.scene, plan.particles, plan.start) &&
           (!plan.beside || is_start(*plan.scene.film.beside->scene, plan.beside->start.particles,
                                     plan.beside->start.sample));
}

// The box as in a simulation of the gas: heat baths draw velocities with the seed of the gas.
Box box_of(const Gas& gas) {
    Box box = gas.box;
    box.surfaces.seed = gas.seed;
    return box;
}

void archive_run(Archive& archive, FilmPlan& plan) {
    archive(plan.progress);
    plan.run.archive(archive, box_of(plan.scene.gas), plan.particles, plan.scene.run);
    if (!plan.beside) return;
    const Scene& other = *plan.scene.film.beside->scene;
    plan.beside->run.archive(archive, box_of(other.gas), plan.beside->start.particles, other.run);
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

// Prepares the second run, which its panels survey while it is recorded.
void start_beside(FilmPlan& plan, std::optional<Simulation>& simulation, Progress& progress) {
    if (!plan.scene.film.beside) return;
    auto [scene, start] = start_scene(*plan.scene.film.beside->scene, progress);
    plan.scene.film.beside->scene = std::make_shared<Scene>(std::move(scene));
    plan.beside = RunBeside{{start.particles(), start.sample()}, {}};
    simulation = std::move(start);
}

}  // namespace

std::unique_ptr<PanelSet> FilmPlan::panels() const {
    auto set =
        std::make_unique<PanelSet>(scene, particles, start, beside ? &beside->start : nullptr);
    Archive archive(axes, "what the first pass has fixed");
    set->archive(archive);
    archive.expect_end();
    if (!progress.empty()) {
        Archive so_far(progress, "how far the panels are");
        set->archive_progress(so_far);
        so_far.expect_end();
    }
    if (beside) set->play_beside(beside->run);
    return set;
}

FilmFrames::FilmFrames(const FilmPlan& plan) : panels_(plan.panels()), player_(plan.run) {}

void FilmFrames::go_to(std::size_t end, const Taker& take, bool ends_still) {
    while (player_.shown() < end) {
        player_.next();
        const bool is_still = ends_still && player_.shown() == end;
        take(panels_->frame_data(player_.tick(), player_.sample(), player_.advanced(), is_still),
             player_.advanced());
    }
}

FilmPlan FilmFrames::rest(FilmPlan without_run, std::size_t end) const {
    FilmPlan part = std::move(without_run);
    Archive progress;
    panels_->archive_progress(progress);
    part.progress = progress.finished();
    part.run = player_.rest(end);
    if (part.beside) part.beside->run = *panels_->rest_beside(end);
    return part;
}

std::string fixed_axes(PanelSet& panels) {
    panels.fix_axes();
    Archive axes;
    panels.archive(axes);
    return axes.finished();
}

FilmPlan prepare(const Scene& asked, const FilmOptions& options, Progress& progress,
                 const std::function<void(const FilmPlan&)>& when_placed) {
    FilmPlan plan;
    const AxesCache cache(options.cache, asked);
    std::optional<SettledAxes> settled = cache.find();
    const bool was_settled = settled.has_value();
    auto [scene, start] = start_scene(settled ? with_bits(asked, settled->bits) : asked, progress);
    plan.scene = std::move(scene);
    plan.particles = start.particles();
    plan.start = start.sample();
    std::vector<Tick> ticks = timeline(plan.scene);
    plan.span = frames_between(plan.scene.film, ticks, options.from, options.to);
    plan.segments = segment_starts(plan.frames(), plan.particles.count());
    std::optional<Simulation> other;
    start_beside(plan, other, progress);
    if (when_placed) when_placed(plan);

    PanelSet panels(plan.scene, plan.particles, plan.start,
                    plan.beside ? &plan.beside->start : nullptr);
    Recording::Room room = options.room;
    if (other) room = {room.memory / 2, room.file / 2};
    // With fewer particles a separate thread for the panels does not pay.
    constexpr Eigen::Index enough = 2000;
    const bool aside = options.threads > 1 && plan.particles.count() >= enough;
    std::optional<FilmTextMaker> text;
    std::optional<FilmSound> sound;
    if (has_sound(plan.scene, format_of_film(options.output)))
        sound.emplace(plan.scene.film, ticks, plan.particles, start.energy_account(),
                      plan.span.first, plan.span.end);
    if (options.text || sound)
        text.emplace(plan.scene, plan.span, ticks, plan.particles, options.joined_at,
                     sound.has_value());
    // Frames after the span are needed only for the axes, except one: the sound of the last frame
    // is made from the collisions before the next frame.
    if (settled) ticks.resize(std::min(ticks.size(), static_cast<std::size_t>(plan.span.end) + 1));
    progress.begin("simulating", static_cast<double>((other ? 2 : 1) * ticks.size()));
    if (other)
        plan.beside->run = panels.record_beside(
            std::move(*other), ticks,
            [&](const Tick&, const Sample&, const AdvanceResult&) { progress.advance(); }, room,
            aside);
    plan.run = panels.record(
        std::move(start), ticks,
        [&](const Tick& tick, const Sample& sample, const AdvanceResult& advanced) {
            if (text) text->see(tick, sample, advanced);
            if (sound) sound->see(tick, advanced);
            progress.advance();
        },
        room, aside, sound.has_value());
    if (sound) plan.sound = sound->samples();
    if (!settled) {
        settled = SettledAxes{bits_of(plan.scene), fixed_axes(panels)};
        cache.keep(*settled);
    }
    plan.axes = std::move(settled->axes);
    if (text) plan.text = text->text();
    const int previews = format_of_film(options.output).previews;
    if (previews > 0) plan.colors = chosen_colors(plan, previews, progress);
    const bool is_kept = plan.run.is_kept() && (!plan.beside || plan.beside->run.is_kept());
    plan.passes =
        passes_for(asked, was_settled, is_kept, options.text, !plan.sound.empty(), previews > 0);
    return plan;
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
    const double disks = static_cast<double>(particles) * (scene.film.beside ? 2.0 : 1.0);
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

std::vector<std::string> expected_passes(const Scene& scene, std::int64_t particles) {
    const bool kept = Recording::fits(static_cast<std::size_t>(frame_count(scene.film)), particles,
                                      scene.gas.box.dimension);
    return passes_for(scene, false, kept, false, false, false);
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
