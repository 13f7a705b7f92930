#include "figures/figure_run.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>
#include <utility>

#include "panels/echo/echo_record.h"
#include "panels/plot/plot_panel.h"
#include "panels/precision.h"
#include "panels/registry.h"
#include "util/interrupt.h"

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

// The figures of one seed.
class FigureRun::OfSeed {
  public:
    // Of the figures that show more than `later` seeds.
    OfSeed(const Scene& scene, int later, const Fresh& fresh, const TrialCallback& trial)
        : scene_(with_precision(alone(scene, later), trial)),
          fresh_(fresh),
          ticks_(ticks_of(scene_)) {
        for (const FigureSpec& spec : scene_.figures)
            if (spec.panel.seeds > later && spec.compare.empty()) specs_.push_back(&spec);
    }
    OfSeed(const OfSeed&) = delete;
    OfSeed& operator=(const OfSeed&) = delete;

    void begin(const RunsCallbacks& on_progress);
    void survey(const RunsCallbacks& on_progress);
    void look(const RunsCallbacks& on_progress);
    double time_to_simulate() const;
    const Figure& figure_of(const std::string& name) const;
    const Scene& scene() const { return scene_; }
    const Particles& particles() const { return particles_; }

    std::vector<Figure> figures;

  private:
    Simulation fresh(const RunsCallbacks& on_progress) const;
    FrameInput observe(const Tick& tick, const Sample& sample, const AdvanceResult& advanced);

    Scene scene_;
    const Fresh& fresh_;
    std::vector<Tick> ticks_;
    std::vector<const FigureSpec*> specs_;
    std::optional<Simulation> start_;
    Particles particles_;
    std::optional<EquilibriumGas> equilibrium_;
    Eigen::ArrayXd speed_, energy_;  // of the present sample
};

const Figure& FigureRun::OfSeed::figure_of(const std::string& name) const {
    return *std::ranges::find(figures, name,
                              [](const Figure& figure) { return figure.spec->name; });
}

// One that shows nothing is begun, for its particles, and goes no further.
double FigureRun::OfSeed::time_to_simulate() const {
    const Run& run = scene_.run;
    return specs_.empty() ? run.equilibrate : 2.0 * (run.equilibrate + run.until);
}

Simulation FigureRun::OfSeed::fresh(const RunsCallbacks& on_progress) const {
    double now = -scene_.run.equilibrate;
    const auto tell = [&](double time) {
        if (on_progress.advance) on_progress.advance(time - std::exchange(now, time));
    };
    Simulation simulation = fresh_(scene_, tell);
    tell(0.0);
    return simulation;
}

// Makes the panels, with the particles at time 0.
void FigureRun::OfSeed::begin(const RunsCallbacks& on_progress) {
    start_ = fresh(on_progress);
    particles_ = start_->particles();
    equilibrium_ = equilibrium(scene_.gas.box, particles_, start_->sample());
    const PanelContext context{scene_, particles_, static_cast<int>(ticks_.size()), equilibrium_,
                               false};
    for (const FigureSpec* spec : specs_)
        figures.push_back({spec, make_panel(context, spec->panel)});
}

FrameInput FigureRun::OfSeed::observe(const Tick& tick, const Sample& sample,
                                      const AdvanceResult& advanced) {
    speed_ = speeds(sample);
    energy_ = kinetic_energies(particles_, sample);
    return {tick, sample, speed_, energy_, advanced};
}

void FigureRun::OfSeed::survey(const RunsCallbacks& on_progress) {
    if (figures.empty()) return;
    Simulation simulation = fresh(on_progress);
    simulation.record_collisions(std::ranges::any_of(
        figures, [](const Figure& figure) { return figure.panel->surveys_collisions(); }));
    if (std::ranges::any_of(
            figures, [](const Figure& figure) { return figure.panel->wants_return_distances(); }))
        simulation.measure_return(return_times(scene_, particles_.count(), ticks_));
    double now = 0.0;
    with_places_of_errors(scene_, [&] {
        for (const Tick& tick : ticks_) {
            throw_if_interrupted();
            const AdvanceResult advanced = simulation.advance_to(tick.time);
            const FrameInput input = observe(tick, simulation.sample(), advanced);
            for (const Figure& figure : figures) figure.panel->survey(input);
            if (on_progress.advance) on_progress.advance(tick.time - std::exchange(now, tick.time));
        }
    });
}

// Of frames that show one time the last: at a reversal the one after it.
void FigureRun::OfSeed::look(const RunsCallbacks& on_progress) {
    if (figures.empty()) return start_.reset();
    start_->record_collisions(std::ranges::any_of(
        figures, [](const Figure& figure) { return figure.panel->wants_collisions(); }));
    double now = 0.0;
    for (std::size_t i = 0; i < ticks_.size(); ++i) {
        throw_if_interrupted();
        const AdvanceResult advanced = start_->advance_to(ticks_[i].time);
        const FrameInput input = observe(ticks_[i], start_->sample(), advanced);
        const bool last = i + 1 == ticks_.size() || ticks_[i + 1].time != ticks_[i].time;
        for (Figure& figure : figures) {
            auto state = figure.panel->state(input);
            if (last && shows(figure, ticks_[i].time))
                figure.moments.push_back({ticks_[i].time, advanced.counts, std::move(state)});
        }
        if (on_progress.advance)
            on_progress.advance(ticks_[i].time - std::exchange(now, ticks_[i].time));
    }
    start_.reset();
}

FigureRun::FigureRun(const Scene& scene, const Fresh& fresh, int threads,
                     const RunsCallbacks& on_progress)
    : scene_(alone(scene, 0)) {
    int seeds = 1;
    struct Job {
        std::unique_ptr<OfSeed>* run;
        const Scene* scene;
        int later;
    };
    std::vector<Job> jobs;
    for (const FigureSpec& spec : scene_.figures) {
        seeds = std::max(seeds, spec.panel.seeds);
        if (!spec.compare.empty()) compared_[spec.name].resize(spec.compare.size());
    }
    runs_.resize(static_cast<std::size_t>(seeds));
    for (int k = 0; k < seeds; ++k)
        jobs.push_back({&runs_[static_cast<std::size_t>(k)], &scene_, k});
    for (const FigureSpec& spec : scene_.figures)
        for (std::size_t k = 0; k < spec.compare.size(); ++k)
            jobs.push_back({&compared_[spec.name][k], spec.compare[k].scene.get(), 0});
    on_threads(threads, jobs.size(), [&](std::size_t i) {
        const Job& job = jobs[i];
        *job.run = std::make_unique<OfSeed>(*job.scene, job.later, fresh,
                                            jobs.size() == 1 ? on_progress.trial : TrialCallback{});
    });
    double all = 0.0;
    for (const Job& job : jobs) all += (*job.run)->time_to_simulate();
    if (on_progress.begin) on_progress.begin(all);
    on_threads(threads, jobs.size(), [&](std::size_t i) { (*jobs[i].run)->begin(on_progress); });
    on_threads(threads, jobs.size(), [&](std::size_t i) { (*jobs[i].run)->survey(on_progress); });
    fix_axes();
    on_threads(threads, jobs.size(), [&](std::size_t i) { (*jobs[i].run)->look(on_progress); });
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
            others.push_back(runs_[k]->figure_of(figure.spec->name).panel.get());
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
            others.push_back(runs[k]->figures.front().panel.get());
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
