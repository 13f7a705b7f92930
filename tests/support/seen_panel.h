// A panel together with the run that it has processed, as in the two passes of a film.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "panels/plot/plot_panel.h"
#include "panels/plots/series_panel.h"
#include "panels/registry.h"
#include "physics/mechanics.h"
#include "physics/simulation.h"
#include "scene/scene.h"
#include "support/scene_text.h"

namespace carom::test {

/// Times from 0 to `end` in `steps` equal steps, both ends included.
inline std::vector<double> times_up_to(double end, int steps) {
    std::vector<double> times;
    for (int i = 0; i <= steps; ++i) times.push_back(end * i / steps);
    return times;
}

/// A panel of a scene after the first pass. If constructed from a scene alone, it is the first
/// panel of its film.
struct SeenPanel {
    Scene scene;
    std::vector<double> times;
    Particles particles;
    BoxedGas gas;
    std::unique_ptr<Panel> panel;
    std::vector<EnergyAccount> accounts = {};  ///< one for each time

    SeenPanel(Scene of, const PanelSpec& spec, std::vector<double> at)
        : scene(std::move(of)),
          times(std::move(at)),
          particles(Simulation(scene.gas, scene.run).particles()),
          gas(scene.gas.box, scene.run.events, particles,
              Simulation(scene.gas, scene.run).sample()),
          panel(make_panel({scene, particles, static_cast<int>(times.size()), gas}, spec)) {
        if (times.size() > 1) scene.run.sample_every = times[1] - times[0];  // its samples
        run(panel->surveys_collisions(), [&](const FrameInput& input, Simulation& simulation) {
            panel->survey(input);
            accounts.push_back(simulation.energy_account());
        });
        panel->fix_axes();
    }
    SeenPanel(const Scene& of, int steps)
        : SeenPanel(of, of.film.panels.at(0), times_up_to(of.run.until, steps)) {}

    /// The state of the panel at the last time, after the second pass.
    std::shared_ptr<const PanelState> last_state() const {
        std::shared_ptr<const PanelState> last;
        run(panel->wants_collisions(),
            [&](const FrameInput& input, Simulation&) { last = panel->state(input); });
        return last;
    }

    const History& series() const {
        return dynamic_cast<const SeriesPanel&>(*panel).record().runs.front();
    }
    plot::Plot plot(const PanelState* state = nullptr) const {
        return dynamic_cast<const PlotPanel&>(*panel).plot(state);
    }

  private:
    template <class Take>
    void run(bool records_collisions, const Take& take) const {
        Simulation simulation(scene.gas, scene.run);
        simulation.record_collisions(records_collisions);
        for (const double time : times) {
            const AdvanceResult advanced = simulation.advance_to(time);
            Tick tick;
            tick.time = time;
            tick.reversals = advanced.reversals;
            const Sample& sample = simulation.sample();
            take({tick, sample, speeds(sample), kinetic_energies(particles, sample), advanced},
                 simulation);
        }
    }
};

}  // namespace carom::test
