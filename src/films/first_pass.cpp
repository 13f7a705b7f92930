#include "films/first_pass.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "films/segment_workers.h"
#include "media/formats.h"
#include "media/gif_palette.h"
#include "panels/frame.h"
#include "runs/run_progress.h"
#include "scene/time/timeline.h"
#include "sound/film_sound.h"
#include "util/archive.h"
#include "util/text.h"

namespace carom {
namespace {

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

// About `wanted` of the ticks, evenly spread, including the last one and that of the still.
std::vector<Tick> some_of(const std::vector<Tick>& ticks, int still) {
    constexpr std::size_t wanted = 30;
    const std::size_t step = std::max<std::size_t>(1, ticks.size() / wanted);
    std::vector<Tick> some;
    for (std::size_t k = 0; k < ticks.size(); ++k)
        if (k % step == 0 || k + 1 == ticks.size() || ticks[k].frame == still)
            some.push_back(ticks[k]);
    return some;
}

}  // namespace

FirstPass::FirstPass(const Scene& asked, const std::filesystem::path& cache, Progress& progress)
    : cache_(cache, asked), progress_(progress), settled_(cache_.find()) {
    const auto start = [&](const Scene& run) {
        StartedScene started = start_scene(run, progress);
        plan_.starts.push_back({started.simulation.particles(), started.simulation.sample()});
        simulations_.push_back(std::move(started.simulation));
        return std::move(started.scene);
    };
    plan_.scene = start(settled_ ? with_bits(asked, settled_->bits) : asked);
    for (ComparedRun& run : plan_.scene.film.runs.others)
        run.scene = std::make_shared<Scene>(start(*run.scene));
}

PanelSet& FirstPass::panels() {
    if (panels_) return *panels_;
    surveyed_ = with_usual_numbers(plan_.scene);
    panels_.emplace(*surveyed_, plan_.starts);
    if (wants_numbers()) panels_->ask(requests_of_film(plan_.scene));
    return *panels_;
}

void FirstPass::simulate(const std::vector<Tick>& ticks, PanelSet::Survey how,
                         const Recording::Viewer& see) {
    const std::size_t runs = simulations_.size();
    how.room = {how.room.memory / runs, how.room.file / static_cast<std::int64_t>(runs)};
    PanelSet::Survey of_others = how;
    of_others.all_collisions = false;
    panels();
    progress_.begin("simulating", static_cast<double>(runs * ticks.size()));
    for (std::size_t run = 0; run < runs; ++run)
        plan_.runs.push_back(panels().record(
            run, std::move(simulations_[run]), ticks,
            [&](const Tick& tick, const Sample& sample, const AdvanceResult& advanced) {
                if (run == 0 && see) see(tick, sample, advanced);
                progress_.advance();
            },
            run == 0 ? how : of_others));
    simulations_.clear();
}

void FirstPass::simulate_later(const std::vector<Tick>& ticks) {
    const bool with_collisions = panels().wants_collisions();
    for (Simulation& simulation : simulations_)
        plan_.runs.emplace_back(std::move(simulation), ticks, with_collisions);
    simulations_.clear();
}

void FirstPass::fix(bool is_whole) {
    if (!settled_) {
        settled_ = SettledAxes{bits_of(plan_.scene), fixed_axes(panels()), panels().number_texts()};
        if (is_whole) cache_.keep(*settled_);
    }
    panels_.reset();
    plan_.axes = settled_->axes;
    plan_.number_texts = settled_->number_texts;
    plan_.scene = with_numbers(std::move(plan_.scene), plan_.number_texts);
}

FilmPlan prepare(const Scene& asked, const FilmOptions& options, Progress& progress,
                 const std::function<void(const FilmPlan&)>& when_placed) {
    FirstPass pass(asked, options.cache, progress);
    const bool was_settled = pass.is_settled();
    FilmPlan& plan = pass.plan();
    std::vector<Tick> ticks = timeline(plan.scene);
    plan.span = frames_between(plan.scene.film, ticks, options.from, options.to);
    plan.segments = segment_starts(plan.frames(), plan.particles().count());
    if (when_placed) when_placed(plan);

    // With fewer particles a separate thread for the panels does not pay.
    constexpr Eigen::Index enough = 2000;
    const bool aside = options.threads > 1 && plan.particles().count() >= enough;
    std::optional<FilmTextMaker> text;
    std::optional<FilmSound> sound;
    if (has_sound(plan.scene, format_of_film(options.output)))
        sound.emplace(plan.scene.film, ticks, plan.particles(), pass.start().energy_account(),
                      plan.span.first, plan.span.end);
    if (options.text || sound)
        text.emplace(plan.scene, plan.span, ticks, plan.particles(), options.joined_at,
                     sound.has_value());
    // Frames after the span are needed only for the axes, except one: the sound of the last frame
    // is made from the collisions before the next frame.
    if (was_settled)
        ticks.resize(std::min(ticks.size(), static_cast<std::size_t>(plan.span.end) + 1));
    pass.simulate(ticks,
                  {.room = options.room, .aside = aside, .all_collisions = sound.has_value()},
                  [&](const Tick& tick, const Sample& sample, const AdvanceResult& advanced) {
                      if (text) text->see(tick, sample, advanced);
                      if (sound) sound->see(tick, advanced);
                  });
    if (sound) plan.sound = sound->samples();
    pass.fix();
    if (text) plan.text = text->text(plan.number_texts);
    const int previews = format_of_film(options.output).previews;
    if (previews > 0) plan.colors = chosen_colors(plan, previews, progress);
    const bool is_kept = std::ranges::all_of(plan.runs, &Recording::is_kept);
    plan.passes =
        passes_for(asked, was_settled, is_kept, options.text, !plan.sound.empty(), previews > 0);
    return std::move(plan);
}

StillPlan prepare_still(const Scene& scene, double at, bool is_quick,
                        const std::filesystem::path& cache, Progress& progress) {
    FirstPass pass(scene, cache, progress);
    FilmPlan& plan = pass.plan();
    std::vector<Tick> ticks = timeline(plan.scene);
    const std::size_t frames = ticks.size();
    const int still = frame_nearest_to(plan.scene.film, ticks, at);
    plan.span = {still, still + 1};
    bool is_whole = true;
    if (pass.is_settled()) {
        ticks.resize(static_cast<std::size_t>(still) + 1);
        pass.simulate_later(ticks);
    } else {
        if (is_quick && !pass.wants_numbers() && !pass.panels().wants_return_distances())
            ticks = some_of(ticks, still);
        is_whole = ticks.size() == frames;
        const auto shown = std::ranges::upper_bound(ticks, still, {}, &Tick::frame);
        pass.simulate(
            ticks,
            {.frames = static_cast<std::size_t>(shown - ticks.begin()), .only_frames = !is_whole},
            {});
    }
    pass.fix(is_whole);
    return {std::move(plan), is_whole ? frames : ticks.size(), frames};
}

std::string fixed_axes(PanelSet& panels) {
    panels.fix_axes();
    Archive axes;
    panels.archive(axes);
    return axes.finished();
}

std::vector<std::string> expected_passes(const Scene& scene, std::int64_t particles) {
    const bool kept = Recording::fits(static_cast<std::size_t>(frame_count(scene.film)), particles,
                                      scene.gas.box.dimension);
    return passes_for(scene, false, kept, false, false, false);
}

}  // namespace carom
