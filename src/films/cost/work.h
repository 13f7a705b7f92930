// What a command does with a scene, and what that takes: CPU time, memory and bytes of output. All
// of it is estimated from units that are counted before the work begins (collisions, frames,
// pixels, particles), never from a clock: the estimate is the same on every machine.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "films/cost/trial_run.h"
#include "films/film_options.h"
#include "media/formats.h"
#include "runs/sweep_runs.h"
#include "scene/sweep.h"
#include "util/diagnostics.h"

namespace carom {

struct Scene;
struct SceneSource;

/// A part of the work.
struct WorkPart {
    std::string what;         ///< "7200 frames of 3840 by 3840 as mp4"
    std::string reduce;       ///< what makes it less: "`film.size` or `film.seconds`"
    double seconds = 0.0;     ///< CPU time on all cores together, on the machine of docs/limits.md
    Diagnostic place = {};    ///< in the scene, with an empty message; empty: none
    bool is_drawing = false;  ///< the pictures of a film, which several cores share
};

struct Work {
    std::vector<WorkPart> parts = {};
    double memory = 0.0;              ///< bytes at the peak, on one thread
    double bytes = 0.0;               ///< of all output files
    std::string reduces_memory = {};  ///< as WorkPart::reduce
    std::string reduces_bytes = {};

    double seconds() const;

    /// The part that takes most; there must be one.
    const WorkPart& largest() const;
};

/// Both works, one after the other.
Work together(const Work& first, const Work& second);

/// What the runs of a scene's film calculate, its own first.
using SceneCounts = std::vector<RunCounts>;

/// Counts the runs of a scene by trials. Throws what try_run() throws.
SceneCounts counts_of_film(const Scene& scene);

/// The files that `carom run` writes beside its summary.
struct RunTables {
    bool samples = false, trajectory = false, collisions = false;
};

/// The work of `carom run`.
Work work_of_run(const Scene& scene, const RunCounts& counts, const RunTables& tables = {});

/// The work of the film of a scene in a format.
Work work_of_film(const Scene& scene, const FilmOptions& options, const OutputFormat& format,
                  const SceneCounts& counts);

/// The work of one frame of it, for which the whole run is simulated; `is_quick` as for
/// draw_still_alone().
Work work_of_still(const Scene& scene, bool is_quick, const SceneCounts& counts);

/// The work of measured_cost().
Work work_of_measuring(const Scene& scene, const FilmOptions& options, const OutputFormat& format,
                       const SceneCounts& counts);

/// The work of the figures of a scene with these names (none: all), each in `formats`. Tries the
/// runs that the figures compare or vary. Throws what try_run() throws.
Work work_of_figures(const Scene& scene, std::span<const std::string> names,
                     std::span<const std::string> formats, const RunCounts& counts);

/// The work of all runs of a sweep, from short trials at its points: at all of them if the scene is
/// held to limits, so that none is missed, else at up to 100, spread evenly. Throws what `scene_at`
/// and try_run() throw; Interrupted.
Work work_of_sweep(const Sweep& sweep, const SceneAtPoint& scene_at);

/// Throws SceneError if the scene is held to the limits of a classroom (scene/limits.h) and the
/// work exceeds them. The message says what takes most of it and what to reduce.
void refuse_much_work(const Work& work, const SceneSource& source);

/// The same for the work of a film, whose runs it counts only if the scene is held to limits.
/// `measures`: how often measured_cost() is called before.
void refuse_much_film(const Scene& scene, const FilmOptions& options, const OutputFormat& format,
                      int measures = 0);

/// The same for all runs of a sweep.
void refuse_much_sweep(const Sweep& sweep, const SceneAtPoint& scene_at);

/// A number of seconds, bytes or others in two digits: it is an estimate.
std::string about(double value);

}  // namespace carom
