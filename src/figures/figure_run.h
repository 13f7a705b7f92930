// The figures of a scene before they are drawn: their panels with axes that hold for the whole run,
// as in a film, and what they show at their times. All figures of a scene share two runs of the
// physics.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "panels/panel.h"
#include "physics/simulation.h"
#include "scene/scene.h"

namespace carom {

/// What happened until a figure's time.
struct FigureMoment {
    double time = 0.0;
    CollisionCounts collisions;
    std::shared_ptr<const PanelState> state;
};

/// One figure: its panel, and a moment for each of its times.
struct Figure {
    const FigureSpec* spec;
    std::unique_ptr<Panel> panel;
    std::vector<FigureMoment> moments = {};
};

class FigureRun {
  public:
    /// Runs the physics of `scene` twice; `fresh` gives a simulation of it at time 0. The axes are
    /// those of the scene's film. Throws as the simulation does, and Interrupted.
    FigureRun(const Scene& scene, const std::function<Simulation()>& fresh);
    FigureRun(const FigureRun&) = delete;  // its panels refer to its scene and particles
    FigureRun& operator=(const FigureRun&) = delete;

    const Scene& scene() const { return scene_; }
    const Particles& particles() const { return particles_; }
    const std::vector<Figure>& figures() const { return figures_; }  ///< in the scene's order

  private:
    Observation observe(const Tick& tick, const Sample& sample, const Passage& passage);
    void survey(Simulation simulation, const std::vector<Tick>& ticks);
    void look(Simulation simulation, const std::vector<Tick>& ticks);

    Scene scene_;
    Particles particles_;
    std::optional<EquilibriumGas> equilibrium_;
    Eigen::ArrayXd speed_, energy_;  ///< of the present sample
    std::vector<Figure> figures_;
};

}  // namespace carom
