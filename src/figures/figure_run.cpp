#include "figures/figure_run.h"

#include <algorithm>

#include "panels/registry.h"
#include "util/interrupt.h"

namespace carom {
namespace {

// The film's ticks, and one at each time that a figure shows: axes are the film's, moments exact.
std::vector<Tick> ticks_of(const Scene& scene) {
    std::vector<Tick> ticks = timeline(scene);
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
Scene alone(Scene scene) {
    scene.film.layout.panels.clear();
    return scene;
}

bool shows(const Figure& figure, double time) {
    const std::size_t next = figure.moments.size();
    return next < figure.spec->times.size() && figure.spec->times[next] == time;
}

}  // namespace

FigureRun::FigureRun(const Scene& scene, const std::function<Simulation()>& fresh)
    : scene_(alone(scene)) {
    Simulation start = fresh();
    particles_ = start.particles();
    equilibrium_ = equilibrium(scene_.gas.box, particles_, start.sample());
    const std::vector<Tick> ticks = ticks_of(scene_);
    const Cast cast{scene_, particles_, static_cast<int>(ticks.size()), equilibrium_, false};
    for (const FigureSpec& spec : scene_.figures)
        figures_.push_back({&spec, spec.panel.kind == "gas" ? make_gas_panel(cast)
                                                            : make_panel(cast, spec.panel)});
    survey(fresh(), ticks);
    look(std::move(start), ticks);
}

Observation FigureRun::observe(const Tick& tick, const Sample& sample, const Passage& passage) {
    speed_ = speeds(sample);
    energy_ = kinetic_energies(particles_, sample);
    return {tick, sample, speed_, energy_, passage};
}

void FigureRun::survey(Simulation simulation, const std::vector<Tick>& ticks) {
    simulation.record_collisions(std::ranges::any_of(
        figures_, [](const Figure& figure) { return figure.panel->surveys_collisions(); }));
    for (const Tick& tick : ticks) {
        throw_if_interrupted();
        const Passage passage = simulation.advance_to(tick.time);
        const Observation observation = observe(tick, simulation.sample(), passage);
        for (const Figure& figure : figures_) figure.panel->survey(observation);
    }
    for (const Figure& figure : figures_) figure.panel->settle();
}

// Of frames that show one time the last: at a reversal the one after it.
void FigureRun::look(Simulation simulation, const std::vector<Tick>& ticks) {
    simulation.record_collisions(std::ranges::any_of(
        figures_, [](const Figure& figure) { return figure.panel->wants_collisions(); }));
    for (std::size_t i = 0; i < ticks.size(); ++i) {
        throw_if_interrupted();
        const Passage passage = simulation.advance_to(ticks[i].time);
        const Observation observation = observe(ticks[i], simulation.sample(), passage);
        const bool last = i + 1 == ticks.size() || ticks[i + 1].time != ticks[i].time;
        for (Figure& figure : figures_) {
            auto state = figure.panel->state(observation);
            if (last && shows(figure, ticks[i].time))
                figure.moments.push_back({ticks[i].time, passage.counts, std::move(state)});
        }
    }
}

}  // namespace carom
