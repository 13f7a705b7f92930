#include "films/film_plan.h"

#include <algorithm>
#include <utility>

#include "films/axes_cache.h"
#include "media/formats.h"
#include "panels/archived.h"
#include "runs/own_files.h"
#include "scene/load.h"
#include "scene/time/timeline.h"

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
    archive(plan.span, plan.segments, plan.starts, plan.axes, plan.number_texts, plan.colors,
            plan.text, plan.passes);
}

bool fits_together(const FilmPlan& plan) {
    const auto is_start = [](const RunStart& start, const Scene* scene) {
        return are_of(start.particles, scene->gas.species.size()) &&
               is_of(start.sample, scene->gas.box, start.particles.count());
    };
    const std::vector<int>& segments = plan.segments;
    const std::size_t texts = plan.number_texts.size();
    if (texts != plan.scene.numbers.size() && (texts > 0 || !requests_of_film(plan.scene).empty()))
        return false;
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
    plan.scene = with_numbers(std::move(plan.scene), plan.number_texts);
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
