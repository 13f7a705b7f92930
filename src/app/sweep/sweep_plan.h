// A sweep as a plan in a folder: its runs in chunks that any process can do, and what they give
// once all are there. What a folder of a plan is: app/chunks/.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/chunks/plan_folder.h"
#include "app/progress.h"
#include "app/sweep/sweep_scenes.h"
#include "runs/sweep_summary.h"
#include "scene/load.h"
#include "scene/sweep.h"

namespace carom {

/// What a sweep is planned from.
struct SweepRequest {
    std::string scene;  ///< file, or standard_input
    Overrides overrides = {};
    Sweep sweep = {};
    bool is_seed_of_scene = false;   ///< instead of the sweep's seeds
    std::optional<int> chunks = {};  ///< none: by the time that runs take
};

/// Loads the scene at every point, measures how long its runs take and what memory they need, and
/// writes the plan into a folder, where it replaces an earlier one with its chunks; a plan of the
/// same request is left as it is unless `again`. Whether it was written. Throws SceneError (naming
/// the point), UsageError, SystemError, Interrupted.
bool plan_sweep(SweepRequest request, const std::filesystem::path& folder, bool again,
                Progress& progress);

/// The sweep that is planned in a folder, ready for its runs. Scenes are loaded when they are
/// needed.
class PlannedSweep {
  public:
    /// Throws UsageError where it is the plan of something else than a sweep; `command` is what was
    /// asked for.
    PlannedSweep(const PlanFolder& folder, const std::string& command);

    const Sweep& sweep() const { return outcome_.sweep; }

    /// What each run gives.
    const std::vector<RunNumber>& numbers() const { return outcome_.numbers; }

    /// Throws SceneError, and SystemError where the scene's template was changed.
    std::shared_ptr<const Scene> scene_at(std::int64_t point) const;

    /// Does the runs of a chunk and writes its output and its manifest. Throws SceneError,
    /// SystemError, Interrupted.
    void run_chunk(const PlannedChunk& chunk, int threads, Progress& progress) const;

    /// Takes each run in order; the values are valid during the call.
    using RunTaker = std::function<void(std::int64_t run, const std::vector<double>& values)>;

    /// The summary of all runs. Throws UsageError (chunks are missing), SystemError (an output is
    /// not that of this plan, cut short or changed).
    SweepSummary summary(const RunTaker& take, bool allow_mixed) const;

  private:
    RunRows rows_of(const PlannedChunk& chunk) const;

    const PlanFolder& folder_;
    SweptScene scene_;
    std::string template_;  ///< fingerprint of the template of its film
    SweepSummary outcome_;  ///< without its points
};

/// Where join writes the summary in any case.
std::filesystem::path summary_in(const std::filesystem::path& folder);

}  // namespace carom
