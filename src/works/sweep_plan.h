// A sweep as a plan in a folder: its runs, in chunks that any process can do, and the summary once
// all chunks are done. For the folder of a plan see plan_folder.h.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "runs/sweep_summary.h"
#include "scene/load.h"
#include "scene/sweep.h"
#include "util/progress.h"
#include "works/plan_folder.h"
#include "works/sweep_scenes.h"

namespace carom {

/// The input from which a sweep is planned.
struct SweepRequest {
    std::string scene;  ///< file, or standard_input
    Overrides overrides = {};
    Sweep sweep = {};
    bool is_seed_of_scene = false;   ///< use the seed of the scene instead of the sweep's seeds
    std::optional<int> chunks = {};  ///< none: chosen by the time that runs take
    bool is_classroom = false;       ///< hold the scene at each point to the limits of a classroom
    bool is_strict = false;          ///< refuse a scene with notes
};

/// Called with a sweep and its scenes before any of its runs is done, for instance to refuse it.
using SweepChecker = std::function<void(const Sweep&, const SceneAtPoint&)>;

/// Loads the scene at every point, calls `check`, measures the time and the memory that runs need,
/// and writes the plan into a folder, where it replaces an earlier plan and its chunks. A plan of
/// the same request is left as it is, unless `again`. Returns whether the plan was written. Throws
/// SceneError (naming the point), UsageError, SystemError, Interrupted.
bool plan_sweep(SweepRequest request, const std::filesystem::path& folder, bool again,
                Progress& progress, const SweepChecker& check = {});

/// The planned sweep of a folder, ready for its runs. Scenes are loaded when they are needed.
class PlannedSweep {
  public:
    /// Throws UsageError if the plan is not that of a sweep; `command` is the command of the user,
    /// for the message. With `is_classroom` its scenes are held to the limits of a classroom.
    PlannedSweep(const PlanFolder& folder, const std::string& command, bool is_classroom = false);

    const Sweep& sweep() const { return outcome_.sweep; }

    /// The numbers that each run gives.
    const std::vector<RunNumber>& numbers() const { return outcome_.numbers; }

    /// The scene at a point. Throws SceneError, and SystemError if the scene's template was
    /// changed.
    std::shared_ptr<const Scene> scene_at(std::int64_t point) const;

    /// Does the runs of a chunk and writes its output and its manifest. Throws SceneError,
    /// SystemError, Interrupted.
    void run_chunk(const PlannedChunk& chunk, int threads, Progress& progress) const;

    /// Called with each run in order; the values are valid during the call only.
    using RunTaker = std::function<void(std::int64_t run, const std::vector<double>& values)>;

    /// The summary of all runs. Throws UsageError (chunks are missing), SystemError (an output does
    /// not belong to this plan, is truncated or was changed).
    SweepSummary summary(const RunTaker& take, bool allow_mixed) const;

  private:
    RunRows rows_of(const PlannedChunk& chunk) const;

    const PlanFolder& folder_;
    SweptScene scene_;
    std::string template_;  ///< fingerprint of the template of its film
    SweepSummary outcome_;  ///< without its points
};

/// The path at which `carom join` always writes the summary.
StoredFile summary_in(const std::filesystem::path& folder);

}  // namespace carom
