// The figures of a scene before they are drawn: their panels with axes that hold for the whole run,
// as in a film, and what they show at their times. All figures of a scene share two runs of the
// physics; those that show means of several seeds share two for each of these; one that compares
// runs has two of each of its own.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "panels/panel.h"
#include "physics/reversal/precision.h"
#include "physics/simulation.h"
#include "scene/scene.h"

namespace carom {

/// What happened until a figure's time.
struct FigureMoment {
    double time = 0.0;
    CollisionCounts collisions;
    std::shared_ptr<const PanelState> state;
};

/// One of the runs that a figure compares.
struct FigureSide {
    std::string label;
    Eigen::Index particles = 0;
    double time = 0.0;           ///< that it is seen at
    CollisionCounts collisions;  ///< until then
    std::string account;         ///< what a caption says of it: "mean speed 1.25"
};

/// One figure: its panel, and a moment for each of its times.
struct Figure {
    const FigureSpec* spec;
    std::unique_ptr<Panel> panel;
    std::vector<FigureMoment> moments = {};
    std::vector<FigureSide> sides = {};  ///< of a comparison; its moments are the first one's
};

/// Gives a simulation of a scene at time 0, and tells of the time before it; from any thread.
using Fresh = std::function<Simulation(const Scene&, const TimeCallback&)>;

/// Told how far the runs have come.
struct RunsCallbacks {
    TrialCallback trial;  ///< where there is but one run: of its precision
    std::function<void(double time)>
        begin;  ///< how much all will simulate together, equilibration included
    std::function<void(double time)> advance;  ///< how much more is simulated; from any thread
};

class FigureRun {
  public:
    /// Runs the physics of `scene` twice, and twice for each further seed, on `threads` threads at
    /// most. The axes are those of the scene's film. `told` has all its functions or none. Throws
    /// as the simulation does, and Interrupted.
    FigureRun(const Scene& scene, const Fresh& fresh, int threads = 1,
              const RunsCallbacks& on_progress = {});
    ~FigureRun();
    FigureRun(const FigureRun&) = delete;  // its panels refer to its scene and particles
    FigureRun& operator=(const FigureRun&) = delete;

    const Scene& scene() const;
    const Particles& particles() const;          ///< of the scene's own seed
    const std::vector<Figure>& figures() const;  ///< in the scene's order

  private:
    class OfSeed;
    void fix_axes();
    void take_means();
    Figure side_by_side(const FigureSpec& spec);
    void collect();

    Scene scene_;
    std::vector<std::unique_ptr<OfSeed>>
        runs_;  ///< of the scene's own seed, then of those after it
    std::map<std::string, std::vector<std::unique_ptr<OfSeed>>>
        compared_;  ///< by the name of a figure, the runs that it compares
    std::vector<Figure> figures_;
};

}  // namespace carom
