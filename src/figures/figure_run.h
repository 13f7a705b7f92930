// The figures of a scene before they are drawn: their panels, and what they show at their times.
// Axes hold for the whole run, as in a film, except for histograms of means, which have axes of
// their own. All figures of a scene share one run of the physics; those that show means of several
// seeds share one run per seed; a figure that compares runs or shows a sweep has runs of its own. A
// run that is too large for memory is simulated twice.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "panels/panel.h"
#include "panels/precision.h"
#include "scene/scene.h"

namespace carom {

/// The state of a panel at one of a figure's times, and the collisions until then.
struct FigureMoment {
    double time = 0.0;
    CollisionCounts collisions;
    std::shared_ptr<const PanelState> state;
};

/// One of the runs that a figure compares.
struct FigureSide {
    std::string label;
    Eigen::Index particles = 0;
    double time = 0.0;           ///< simulated time at which it is shown
    CollisionCounts collisions;  ///< until that time
    std::string account;         ///< what the caption says about it: "mean speed 1.25"
};

/// One figure: its panel, and a moment for each of its times.
struct Figure {
    const FigureSpec* spec;
    Panel* panel = nullptr;  ///< that of the run
    std::vector<FigureMoment> moments = {};
    std::vector<FigureSide> sides = {};  ///< of a comparison, whose moments are the first run's
};

/// Callbacks for the progress of the runs; any may be empty.
struct RunsCallbacks {
    TrialCallback trial = {};  ///< trials that find the precision, if there is only one run
    std::function<void(double time)> begin =
        {};  ///< with the total simulated time of all runs: equilibration included, both passes
    std::function<void(double time)> advance = {};  ///< time done since the last call; any thread

    void go_on(double time) const {
        if (advance) advance(time);
    }
};

class FigureRun {
  public:
    /// Runs the physics of `scene`, of each further seed and of each run that is compared, on at
    /// most `threads` threads, for the figures of these names (none: all). Nothing is measured for
    /// other figures, and no run is done that only they show; the result does not depend on which
    /// are asked for. The axes are those of the scene's film, except for histograms of means.
    /// Throws SceneError (a gas cannot be placed, or does not return), Interrupted.
    explicit FigureRun(const Scene& scene, int threads = 1, const RunsCallbacks& on_progress = {},
                       const std::vector<std::string>& names = {});
    ~FigureRun();
    FigureRun(const FigureRun&) = delete;  // its panels refer to its scene and particles
    FigureRun& operator=(const FigureRun&) = delete;

    const Scene& scene() const;
    const Particles& particles() const;          ///< of the scene's own seed
    const std::vector<Figure>& figures() const;  ///< those asked for, in the scene's order

    /// The numbers of the scene's own run for which words of these figures ask: as
    /// WordNumbers::texts().
    const std::vector<std::string>& number_texts() const { return number_texts_; }

  private:
    class OneRun;
    /// One of the runs that a figure shows, and the figure of that run alone.
    struct Part {
        OneRun* run;
        Figure* figure;
    };
    using Parts = std::vector<Part>;
    static void fix_axes(const FigureSpec& spec, const Parts& parts);
    static Figure joined_figure(const FigureSpec& spec, const Parts& parts);
    Figure sweep_figure(const FigureSpec& spec, int threads, const RunsCallbacks& on_progress);

    Scene scene_;
    std::vector<std::unique_ptr<OneRun>>
        runs_;  ///< of the scene's own seed, of those after it, and those that figures compare
    BoxedGas no_gas_;
    std::vector<std::shared_ptr<Panel>> sweeps_;  ///< of figures that show a sweep
    std::vector<Figure> figures_;
    std::vector<std::string> number_texts_;
};

}  // namespace carom
