#include "figures/figure_run.h"

#include <algorithm>
#include <utility>

#include "figures/figure_drawing.h"
#include "figures/sweep_figure.h"
#include "panels/frame.h"
#include "panels/plots/points_panel.h"
#include "panels/recording.h"
#include "panels/shared_panel.h"
#include "panels/sweep/sweep_panel.h"
#include "util/threads/on_threads.h"

namespace carom {
namespace {

// Adds a tick, unless there is one at this time.
void add_tick(std::vector<Tick>& ticks, double time) {
    const auto after = std::ranges::lower_bound(ticks, time, {}, &Tick::time);
    if (after != ticks.end() && after->time == time) return;
    Tick tick = after == ticks.begin() ? ticks.front() : *(after - 1);
    tick.time = time;
    tick.phase = Phase::moving;
    ticks.insert(after, tick);
}

// The film's ticks without its cards, for what is drawn as in the film, paths too.
std::vector<Tick> ticks_of_film(const Scene& scene) {
    std::vector<Tick> ticks = timeline(scene);
    std::erase_if(ticks, [](const Tick& tick) { return is_card(tick.phase); });
    const int first = ticks.front().frame;
    for (Tick& tick : ticks) tick.frame -= first;
    return ticks;
}

// The samples of the run and its events, for what is measured: it does not depend on the film.
std::vector<Tick> ticks_of_run(const Run& run) {
    std::vector<Tick> ticks;
    for (const double time : measured_times(run))
        ticks.push_back({.frame = static_cast<int>(ticks.size()), .time = time});
    return ticks;
}

// Whether runs that a figure compares are shown at different times.
bool end_apart(const FigureSpec& spec) {
    const auto end = [](const ComparedRun& run) { return run.scene->figures.front().times.back(); };
    return std::ranges::any_of(spec.compare, [&](const ComparedRun& run) {
        return end(run) != end(spec.compare.front());
    });
}

// The scene without the panels of its film: figures are drawn alone.
Scene alone(Scene scene, int later) {
    scene.film.layout.panels.clear();
    scene.gas.seed = scene.seed += static_cast<std::uint64_t>(later);
    return scene;
}

// The cast is valid, because only figures with such panels show several runs.
SharedPanel& shared(Panel& panel) { return dynamic_cast<SharedPanel&>(panel); }

// The figures of these names; without names, all.
std::vector<const FigureSpec*> asked_for(const Scene& scene,
                                         const std::vector<std::string>& names) {
    std::vector<const FigureSpec*> specs;
    for (const FigureSpec& spec : scene.figures)
        if (names.empty() || std::ranges::find(names, spec.name) != names.end())
            specs.push_back(&spec);
    return specs;
}

// The total simulated time of the runs of a figure that shows a sweep; 0 if the figure does no such
// runs.
double time_of_sweep(const FigureSpec& spec, const Run& run) {
    return runs_sweep(spec) ? static_cast<double>(sweep_of(spec)->sweep.runs()) * run.until : 0.0;
}

bool shows(const Figure& figure, double time) {
    const std::size_t next = figure.moments.size();
    return next < figure.spec->times.size() && figure.spec->times[next] == time;
}

}  // namespace

// One run of the physics, and the figures that show it: those asked for that show more than `later`
// seeds. It stops at the times of all figures, so that axes do not depend on which are asked for.
// If it is compared with runs that end at other times, titles say that the end is shown.
class FigureRun::OneRun {
  public:
    OneRun(const Scene& scene, int later, const std::vector<std::string>& names,
           bool at_ends = false)
        : scene_(alone(scene, later)) {
        for (FigureSpec& spec : scene_.figures) spec.panel.at_ends = at_ends;
        for (const FigureSpec* spec : asked_for(scene_, names))
            if (spec->panel.seeds > later && spec->compare.empty() && sweep_of(*spec) == nullptr)
                figures.push_back({spec});
    }
    OneRun(const OneRun&) = delete;
    OneRun& operator=(const OneRun&) = delete;

    bool tries_bits() const { return !scene_.run.bits; }
    double time_to_simulate() const;
    void start(const RunsCallbacks& on_progress);
    void survey(const RunsCallbacks& on_progress, const Recording::Room& room);
    void look(const RunsCallbacks& on_progress);
    Figure* figure_of(const std::string& name);
    const Particles& particles() const { return particles_; }
    const std::vector<std::string>& number_texts() const { return number_texts_; }

    std::vector<Figure> figures;

  private:
    /// A pass over the run for some of the figures: those that are drawn as in the film, or those
    /// that measure.
    struct Pass {
        std::vector<std::size_t> shown;  ///< numbers of figures
        std::vector<Tick> ticks;
        std::unique_ptr<PanelSet> panels = {};  ///< one for each figure
        Recording recording = {};
    };
    void plan_passes();
    void look(Pass& pass, const std::function<void(double)>& go_on);

    Scene scene_;
    std::optional<Simulation> start_;
    Particles particles_;
    std::vector<Pass> passes_;
    std::vector<std::string> number_texts_;
};

Figure* FigureRun::OneRun::figure_of(const std::string& name) {
    return &*std::ranges::find(figures, name,
                               [](const Figure& figure) { return figure.spec->name; });
}

// Includes the second pass, unless the run is kept in memory. A run without figures is only
// started, to get its particles.
double FigureRun::OneRun::time_to_simulate() const {
    const Run& run = scene_.run;
    return (tries_bits() ? 0.0 : run.equilibrate) + (figures.empty() ? 0.0 : 2.0 * run.until);
}

void FigureRun::OneRun::start(const RunsCallbacks& on_progress) {
    const bool tries = tries_bits();
    double now = -scene_.run.equilibrate;
    const auto show = [&](int bits, double time) {
        if (tries && on_progress.trial) on_progress.trial(bits, time);
        if (!tries) on_progress.go_on(time - std::exchange(now, time));
    };
    StartedScene started = start_scene(scene_, show);
    show(started.simulation.bits(), 0.0);
    scene_.run.bits = started.simulation.bits();
    particles_ = started.simulation.particles();
    start_ = std::move(started.simulation);
}

void FigureRun::OneRun::plan_passes() {
    std::vector<PanelSpec> specs;
    for (const Figure& figure : figures) specs.push_back(figure.spec->panel);
    const PanelSet all(scene_, particles_, start_->sample(), 1, specs);
    std::vector<std::size_t> drawn, measured;
    for (std::size_t k = 0; k < figures.size(); ++k) {
        const Panel* panel = all.panels()[k].panel.get();
        const bool is_drawn = dynamic_cast<const SharedPanel*>(panel) == nullptr ||
                              (dynamic_cast<const PointsPanel*>(panel) != nullptr &&
                               panel->surveyed_at() == SurveyedAt::frames);
        (is_drawn ? drawn : measured).push_back(k);
    }
    if (!drawn.empty()) passes_.push_back({drawn, ticks_of_film(scene_)});
    if (!measured.empty()) passes_.push_back({measured, ticks_of_run(scene_.run)});
    for (Pass& pass : passes_) {
        for (const std::size_t k : pass.shown)
            for (const double time : figures[k].spec->times) add_tick(pass.ticks, time);
        specs.clear();
        for (const std::size_t k : pass.shown) specs.push_back(figures[k].spec->panel);
        pass.panels = std::make_unique<PanelSet>(scene_, particles_, start_->sample(),
                                                 static_cast<int>(pass.ticks.size()), specs);
        for (std::size_t i = 0; i < pass.shown.size(); ++i)
            figures[pass.shown[i]].panel = pass.panels->panels()[i].panel.get();
    }
    std::vector<WordRequest> requests;
    for (const Figure& figure : figures)
        for (const WordRequest& request : requests_of_figure(scene_, *figure.spec))
            requests.push_back(request);
    passes_.back().panels->ask(std::move(requests));
}

void FigureRun::OneRun::survey(const RunsCallbacks& on_progress, const Recording::Room& room) {
    if (figures.empty()) return start_.reset();
    plan_passes();
    const auto passes = static_cast<double>(passes_.size());
    const auto part = static_cast<std::int64_t>(passes_.size());
    for (Pass& pass : passes_) {
        double now = 0.0;
        pass.recording = pass.panels->record(
            *start_, pass.ticks,
            [&](const Tick& tick, const Sample&, const AdvanceResult&) {
                on_progress.go_on((tick.time - std::exchange(now, tick.time)) / passes);
            },
            {room.memory / passes_.size(), room.file / part});
    }
    number_texts_ = passes_.back().panels->number_texts();
    start_.reset();
}

// The second pass. Of several frames at the same time the last counts: at a reversal, the one after
// it.
void FigureRun::OneRun::look(const RunsCallbacks& on_progress) {
    for (Pass& pass : passes_)
        look(pass,
             [&](double time) { on_progress.go_on(time / static_cast<double>(passes_.size())); });
}

void FigureRun::OneRun::look(Pass& pass, const std::function<void(double)>& go_on) {
    double now = 0.0;
    std::size_t next = 0;
    const std::vector<Tick>& ticks = pass.ticks;
    pass.recording.play(ticks.size(),
                        [&](const Tick& tick, const Sample& sample, const AdvanceResult& advanced) {
                            ++next;
                            const bool last = next == ticks.size() || ticks[next].time != tick.time;
                            const auto is_shown = [&](std::size_t i) {
                                return last && shows(figures[pass.shown[i]], tick.time);
                            };
                            auto states = pass.panels->states(tick, sample, advanced, is_shown);
                            for (std::size_t i = 0; i < states.size(); ++i)
                                if (states[i])
                                    figures[pass.shown[i]].moments.push_back(
                                        {tick.time, advanced.counts, std::move(states[i])});
                            go_on(tick.time - std::exchange(now, tick.time));
                        });
    pass.recording = {};
}

FigureRun::FigureRun(const Scene& scene, int threads, const RunsCallbacks& on_progress,
                     const std::vector<std::string>& names)
    : scene_(alone(scene, 0)) {
    for (const FigureSpec& spec : scene_.figures) refuse_long_words(scene_, spec);
    const std::vector<const FigureSpec*> specs = asked_for(scene_, names);
    int seeds = 1;
    for (const FigureSpec* spec : specs) seeds = std::max(seeds, spec->panel.seeds);
    for (int k = 0; k < seeds; ++k) runs_.push_back(std::make_unique<OneRun>(scene_, k, names));
    std::vector<Parts> parts;  // of each figure
    for (const FigureSpec* spec : specs) {
        Parts& its = parts.emplace_back();
        for (const ComparedRun& run : spec->compare) {
            if (run.scene->units != scene.units)
                refuse(spec->panel.place, "the runs that it compares have different `units`",
                       "give all of them `units: real`, or none");
            runs_.push_back(std::make_unique<OneRun>(*run.scene, 0, std::vector<std::string>{},
                                                     end_apart(*spec)));
            its.push_back({runs_.back().get(), &runs_.back()->figures.front()});
        }
        const auto seeds_shown = static_cast<std::size_t>(spec->panel.seeds);
        for (std::size_t k = 0;
             spec->compare.empty() && sweep_of(*spec) == nullptr && k < seeds_shown; ++k)
            its.push_back({runs_[k].get(), runs_[k]->figure_of(spec->name)});
    }

    double time = 0.0;
    for (const auto& run : runs_) time += run->time_to_simulate();
    for (const FigureSpec* spec : specs) time += time_of_sweep(*spec, scene_.run);
    RunsCallbacks shown = on_progress;
    const bool shows_trials = runs_.size() == 1 && runs_.front()->tries_bits();
    if (!shows_trials) shown.trial = nullptr;
    const auto each = [&](auto work) {
        on_threads(threads, runs_.size(), [&](std::size_t i) { work(*runs_[i]); });
    };
    if (on_progress.begin && !shows_trials) on_progress.begin(time);
    each([&](OneRun& run) { run.start(shown); });
    if (on_progress.begin && shows_trials) on_progress.begin(time);
    Recording::Room room;
    room.memory /= runs_.size();
    room.file /= static_cast<std::int64_t>(runs_.size());
    each([&](OneRun& run) { run.survey(shown, room); });
    for (std::size_t i = 0; i < parts.size(); ++i)
        if (!parts[i].empty()) fix_axes(*specs[i], parts[i]);
    number_texts_ = runs_.front()->number_texts();
    each([&](OneRun& run) { run.look(shown); });
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const FigureSpec& spec = *specs[i];
        figures_.push_back(sweep_of(spec) != nullptr ? sweep_figure(spec, threads, shown)
                                                     : joined_figure(spec, parts[i]));
    }
}

FigureRun::~FigureRun() = default;

const Scene& FigureRun::scene() const { return scene_; }

const Particles& FigureRun::particles() const { return runs_.front()->particles(); }

const std::vector<Figure>& FigureRun::figures() const { return figures_; }

// Gives all runs that a figure shows the same axes.
void FigureRun::fix_axes(const FigureSpec& spec, const Parts& parts) {
    Panel& first = *parts.front().figure->panel;
    if (parts.size() == 1) return first.fix_axes();
    std::vector<Panel*> others;
    for (std::size_t k = 1; k < parts.size(); ++k) others.push_back(parts[k].figure->panel);
    std::vector<std::string> names;
    for (const ComparedRun& run : spec.compare) names.push_back(run.label);
    shared(first).fix_axes_of_runs(others, names);
}

// Makes a figure of a sweep, from runs that no other figure shows.
Figure FigureRun::sweep_figure(const FigureSpec& spec, int threads,
                               const RunsCallbacks& on_progress) {
    const auto panel = std::make_shared<SweepPanel>(
        PanelContext{scene_, particles(), 1, no_gas_, false}, spec.panel);
    panel->set_axis_words(spec.panel.x_title, spec.panel.y_title);
    panel->show(swept_numbers(scene_, spec, threads, [&] { on_progress.go_on(scene_.run.until); }));
    sweeps_.push_back(panel);
    return {&spec, panel.get(), {{scene_.run.until, {}, panel->state()}}};
}

// The figure of the first run, made to show all runs.
Figure FigureRun::joined_figure(const FigureSpec& spec, const Parts& parts) {
    Figure figure = *parts.front().figure;
    figure.spec = &spec;
    if (parts.size() == 1) return figure;
    const SharedPanel& panel = shared(*figure.panel);
    for (std::size_t i = 0; i < figure.moments.size(); ++i) {
        std::vector<std::shared_ptr<const PanelState>> states;
        for (const Part& part : parts) states.push_back(part.figure->moments[i].state);
        figure.moments[i].state = panel.state_of_runs(states);
    }
    if (spec.compare.empty()) return figure;
    const std::vector<std::string> accounts = panel.accounts_of_runs(*figure.moments.front().state);
    for (std::size_t k = 0; k < parts.size(); ++k) {
        const FigureMoment& moment = parts[k].figure->moments.front();
        figure.sides.push_back({spec.compare[k].label, parts[k].run->particles().count(),
                                moment.time, moment.collisions, accounts.at(k)});
    }
    return figure;
}

}  // namespace carom
