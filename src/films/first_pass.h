// The first pass over the runs of a film: they are simulated, its panels see them whole, and what
// holds for all frames is fixed. It ends in a FilmPlan, from which any part of the film is drawn.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "films/axes_cache.h"
#include "films/film_plan.h"
#include "util/progress.h"

namespace carom {

/// A film from the start of its runs to its plan: simulate() or simulate_later(), then fix().
class FirstPass {
  public:
    /// Starts the runs. What an earlier pass has left in the folder of an AxesCache (empty: none)
    /// need not be found again. Throws SceneError (the gas cannot be placed, or does not return),
    /// SystemError, Interrupted.
    FirstPass(const Scene& asked, const std::filesystem::path& cache, Progress& progress);

    /// What is known so far: from the start the scene and the particles.
    FilmPlan& plan() { return plan_; }

    /// The film's own run at time 0, before it is simulated.
    const Simulation& start() const { return simulations_.front(); }

    /// Whether the axes are known already, so that no panel needs to see the runs.
    bool is_settled() const { return settled_.has_value(); }

    /// Whether words of the scene ask for numbers that only the run gives.
    bool wants_numbers() const { return !settled_ && !requests_of_film(plan_.scene).empty(); }

    /// The panels that see the runs. Throws SceneError as PanelSet().
    PanelSet& panels();

    /// Simulates all runs at these times; `see` is called for the frames of the film's own run.
    /// Throws what PanelSet::record() throws.
    void simulate(const std::vector<Tick>& ticks, PanelSet::Survey how,
                  const Recording::Viewer& see);

    /// Leaves the simulation of these frames to whoever plays them.
    void simulate_later(const std::vector<Tick>& ticks);

    /// Fixes the axes and scales, and fills numbers into the words of the plan's scene. Throws
    /// SceneError if one of them has no value. `is_whole`: the panels have seen the whole runs, so
    /// that what they found is kept in the cache.
    void fix(bool is_whole = true);

  private:
    AxesCache cache_;
    Progress& progress_;
    std::optional<SettledAxes> settled_;
    FilmPlan plan_;
    std::vector<Simulation> simulations_;
    std::optional<Scene> surveyed_;  ///< with numbers of usual length in its words
    std::optional<PanelSet> panels_;
};

/// The plan of the film of a scene.
/// `when_placed` is called once the particles are placed, with a plan that contains what is known
/// then: the scene, the span and the particles. Throws SceneError (the gas cannot be placed, or
/// does not return), SystemError, Interrupted.
FilmPlan prepare(const Scene& scene, const FilmOptions& options, Progress& progress,
                 const std::function<void(const FilmPlan&)>& when_placed = {});

/// A plan for one frame of a film, which is the last of its recordings.
struct StillPlan {
    FilmPlan plan;
    std::size_t frames_seen, frames;  ///< by the panels, and in the film
};

/// The plan for the frame nearest to the simulated time `at`. With `is_quick` the panels see the
/// runs at about thirty times only, unless the cache has the axes or a panel needs all frames.
/// Throws what FirstPass throws.
StillPlan prepare_still(const Scene& scene, double at, bool is_quick,
                        const std::filesystem::path& cache, Progress& progress);

/// Ends the first pass of panels; returns what it has fixed for each, as FilmPlan::axes.
std::string fixed_axes(PanelSet& panels);

/// As FilmPlan::passes, predicted from the number of particles before the simulation.
std::vector<std::string> expected_passes(const Scene& scene, std::int64_t particles);

}  // namespace carom
