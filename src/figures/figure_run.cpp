#include "figures/figure_run.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>
#include <utility>

#include "panels/frame.h"
#include "panels/plot/plot_panel.h"
#include "panels/recording.h"

namespace carom {
namespace {

// The film's ticks without its cards, and one at each time that a figure shows: axes are the
// film's, moments exact.
std::vector<Tick> ticks_of(const Scene& scene) {
    std::vector<Tick> ticks = timeline(scene);
    std::erase_if(ticks, [](const Tick& tick) { return is_card(tick.phase); });
    const int first = ticks.front().frame;
    for (Tick& tick : ticks) tick.frame -= first;
    for (const FigureSpec& figure : scene.figures)
        for (const double time : figure.times) {
            const auto after = std::ranges::lower_bound(ticks, time, {}, &Tick::time);
            if (after != ticks.end() && after->time == time) continue;
            Tick tick = after == ticks.begin() ? ticks.front() : *(after - 1);
            tick.time = time;
            tick.phase = Phase::moving;
            ticks.insert(after, tick);
        }
    return ticks;
}

// Nothing stands beside a figure.
Scene alone(Scene scene, int later) {
    scene.film.layout.panels.clear();
    scene.gas.seed = scene.seed += static_cast<std::uint64_t>(later);
    return scene;
}

// Only plots show several runs.
PlotPanel& plot_of(const Figure& figure) { return dynamic_cast<PlotPanel&>(*figure.panel); }

bool shows(const Figure& figure, double time) {
    const std::size_t next = figure.moments.size();
    return next < figure.spec->times.size() && figure.spec->times[next] == time;
}

// Calls `work` with 0 to count - 1, on `threads` threads at most. What the first of them throws, in
// this order, is thrown.
void on_threads(int threads, std::size_t count, const std::function<void(std::size_t)>& work) {
    std::vector<std::exception_ptr> errors(count);
    std::atomic<std::size_t> next = 0;
    const auto help = [&] {
        for (std::size_t i = next++; i < count; i = next++) try {
                work(i);
            } catch (...) {
                errors[i] = std::current_exception();
            }
    };
    {
        std::vector<std::jthread> helpers;
        const auto most = static_cast<std::size_t>(std::max(1, threads));
        for (std::size_t i = 1; i < std::min(count, most); ++i) helpers.emplace_back(help);
        help();
    }
    for (const std::exception_ptr& error : errors)
        if (error) std::rethrow_exception(error);
}

}  // namespace

// One run of the physics, and the figures that show it: those of a scene that show more than
// `later` seeds.
class FigureRun::OneRun {
  public:
    OneRun(const Scene& scene, int later) : scene_(alone(scene, later)), ticks_(ticks_of(scene_)) {
        for (const FigureSpec& spec : scene_.figures)
            if (spec.panel.seeds > later && spec.compare.empty()) figures.push_back({&spec});
    }
    OneRun(const OneRun&) = delete;
    OneRun& operator=(const OneRun&) = delete;

    bool tries_bits() const { return !scene_.run.bits; }
    double time_to_simulate() const;
    void start(const RunsCallbacks& on_progress);
    void survey(const RunsCallbacks& on_progress, std::size_t most_bytes);
    void look(const RunsCallbacks& on_progress);
    const Figure& figure_of(const std::string& name) const;
    const Scene& scene() const { return scene_; }
    const Particles& particles() const { return particles_; }

    std::vector<Figure> figures;

  private:
    Scene scene_;
    std::vector<Tick> ticks_;
    std::optional<Simulation> start_;
    Particles particles_;
    std::optional<PanelSet> panels_;  ///< one for each figure
    Recording recording_;
};

const Figure& FigureRun::OneRun::figure_of(const std::string& name) const {
    return *std::ranges::find(figures, name,
                              [](const Figure& figure) { return figure.spec->name; });
}

// With the second pass, which simulates nothing where the run is kept in memory. A run that shows
// nothing is started, for its particles, and goes no further.
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

void FigureRun::OneRun::survey(const RunsCallbacks& on_progress, std::size_t most_bytes) {
    if (figures.empty()) return start_.reset();
    std::vector<PanelSpec> specs;
    for (const Figure& figure : figures) specs.push_back(figure.spec->panel);
    panels_.emplace(scene_, particles_, start_->sample(), static_cast<int>(ticks_.size()), specs);
    for (std::size_t k = 0; k < figures.size(); ++k)
        figures[k].panel = panels_->panels()[k].panel.get();
    double now = 0.0;
    const Recording::Wanted wanted{panels_->wants_collisions(), panels_->return_times(ticks_)};
    with_places_of_errors(scene_, [&] {
        recording_ = Recording(
            std::move(*start_), ticks_, wanted,
            [&](const Tick& tick, const Sample& sample, const AdvanceResult& advanced) {
                panels_->survey(tick, sample, advanced);
                on_progress.go_on(tick.time - std::exchange(now, tick.time));
            },
            most_bytes);
    });
    start_.reset();
}

// Of frames that show one time the last: at a reversal the one after it.
void FigureRun::OneRun::look(const RunsCallbacks& on_progress) {
    double now = 0.0;
    std::size_t next = 0;
    recording_.play(recording_.ticks().size(),
                    [&](const Tick& tick, const Sample& sample, const AdvanceResult& advanced) {
                        FrameData frame = panels_->frame_data(tick, sample, advanced);
                        ++next;
                        const bool last = next == ticks_.size() || ticks_[next].time != tick.time;
                        for (std::size_t k = 0; k < figures.size(); ++k)
                            if (last && shows(figures[k], tick.time))
                                figures[k].moments.push_back(
                                    {tick.time, advanced.counts, std::move(frame.states[k])});
                        on_progress.go_on(tick.time - std::exchange(now, tick.time));
                    });
    recording_ = {};
}

FigureRun::FigureRun(const Scene& scene, int threads, const RunsCallbacks& on_progress)
    : scene_(alone(scene, 0)) {
    int seeds = 1;
    for (const FigureSpec& spec : scene_.figures) seeds = std::max(seeds, spec.panel.seeds);
    std::vector<OneRun*> all;
    const auto add = [&](std::vector<std::unique_ptr<OneRun>>& to, const Scene& of, int later) {
        all.push_back(to.emplace_back(std::make_unique<OneRun>(of, later)).get());
    };
    for (int k = 0; k < seeds; ++k) add(runs_, scene_, k);
    for (const FigureSpec& spec : scene_.figures)
        for (const ComparedRun& run : spec.compare) add(compared_[spec.name], *run.scene, 0);

    double time = 0.0;
    for (const OneRun* run : all) time += run->time_to_simulate();
    RunsCallbacks shown = on_progress;
    const bool shows_trials = all.size() == 1 && all.front()->tries_bits();
    if (!shows_trials) shown.trial = nullptr;
    const auto each = [&](auto work) {
        on_threads(threads, all.size(), [&](std::size_t i) { work(*all[i]); });
    };
    if (on_progress.begin && !shows_trials) on_progress.begin(time);
    each([&](OneRun& run) { run.start(shown); });
    if (on_progress.begin && shows_trials) on_progress.begin(time);
    const std::size_t most_bytes = Recording::most_bytes / all.size();
    each([&](OneRun& run) { run.survey(shown, most_bytes); });
    fix_axes();
    each([&](OneRun& run) { run.look(shown); });
    take_means();
    collect();
}

FigureRun::~FigureRun() = default;

const Scene& FigureRun::scene() const { return scene_; }

const Particles& FigureRun::particles() const { return runs_.front()->particles(); }

const std::vector<Figure>& FigureRun::figures() const { return figures_; }

// The runs of all seeds of a figure have the same axes, and so have those that it compares.
void FigureRun::fix_axes() {
    for (const Figure& figure : runs_.front()->figures) {
        std::vector<Panel*> others;
        for (std::size_t k = 1; k < static_cast<std::size_t>(figure.spec->panel.seeds); ++k)
            others.push_back(runs_[k]->figure_of(figure.spec->name).panel);
        if (others.empty())
            figure.panel->fix_axes();
        else
            plot_of(figure).fix_axes_of_runs(others, {});
    }
    for (const FigureSpec& spec : scene_.figures) {
        if (spec.compare.empty()) continue;
        const auto& runs = compared_.at(spec.name);
        std::vector<Panel*> others;
        std::vector<std::string> names{spec.compare.front().label};
        for (std::size_t k = 1; k < runs.size(); ++k) {
            others.push_back(runs[k]->figures.front().panel);
            names.push_back(spec.compare[k].label);
        }
        plot_of(runs.front()->figures.front()).fix_axes_of_runs(others, names);
    }
}

void FigureRun::take_means() {
    for (Figure& figure : runs_.front()->figures) {
        const auto seeds = static_cast<std::size_t>(figure.spec->panel.seeds);
        if (seeds == 1) continue;
        for (std::size_t i = 0; i < figure.moments.size(); ++i) {
            std::vector<std::shared_ptr<const PanelState>> states;
            for (std::size_t k = 0; k < seeds; ++k)
                states.push_back(runs_[k]->figure_of(figure.spec->name).moments[i].state);
            figure.moments[i].state = plot_of(figure).state_of_runs(states);
        }
    }
}

// The first run's figure, which shows all of them.
Figure FigureRun::side_by_side(const FigureSpec& spec) {
    const auto& runs = compared_.at(spec.name);
    std::vector<std::shared_ptr<const PanelState>> states;
    std::vector<FigureSide> sides;
    for (std::size_t k = 0; k < runs.size(); ++k) {
        const FigureMoment& moment = runs[k]->figures.front().moments.front();
        states.push_back(moment.state);
        sides.push_back({spec.compare[k].label, runs[k]->particles().count(), moment.time,
                         moment.collisions, ""});
    }
    Figure figure = std::move(runs.front()->figures.front());
    const PlotPanel& panel = plot_of(figure);
    figure.moments.front().state = panel.state_of_runs(states);
    const plot::Plot plot = panel.plot(figure.moments.front().state.get());
    for (std::size_t k = 0; k < sides.size(); ++k) sides[k].account = plot.accounts_of_runs.at(k);
    figure.sides = std::move(sides);
    return figure;
}

void FigureRun::collect() {
    std::size_t alone = 0;
    for (const FigureSpec& spec : scene_.figures) {
        figures_.push_back(spec.compare.empty() ? std::move(runs_.front()->figures.at(alone++))
                                                : side_by_side(spec));
        figures_.back().spec = &spec;
    }
}

}  // namespace carom
