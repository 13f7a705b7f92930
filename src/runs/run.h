// The physics alone: from a scene to its samples and statistics, without a picture.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "physics/exact_positions.h"
#include "physics/reversal/precision.h"
#include "physics/simulation.h"
#include "scene/scene.h"
#include "stats/run_statistics.h"

namespace carom {

/// One reversal of all velocities, and how well the gas found its way back.
struct ReversalReport {
    double at = 0.0;
    double home = 0.0;  ///< 2 at, or where the way back is left before (ways_back.h)
    std::optional<ReturnDistance> distance = {};  ///< from where it was, at `home`: if the run goes
                                                  ///< on so long and no other reversal lies before
    std::int64_t events_out = 0;                  ///< collisions in [0, at], with walls too
    std::optional<std::int64_t> events_back = {};  ///< in (at, home], if the run goes on so long
};

/// Wall-clock seconds.
struct RunSeconds {
    double total = 0.0;
    double prepare = 0.0;   ///< placement and equilibration
    double simulate = 0.0;  ///< from time 0
    double samples = 0.0;   ///< statistics, and what takes the samples; at the same time as the
                            ///< simulation where they have a thread of their own
};

/// What a surface has done in a run, and where it was.
struct SurfaceReport {
    std::string name;
    SurfaceTotals totals;
    struct Position {
        double mean, deviation, last;  ///< over the samples, at the end
    };
    std::optional<Position> position = {};  ///< of one that moves, or has moved
};

struct RunReport {
    std::int64_t particles = 0;
    int bits = bits_of_double;  ///< of the numbers it calculated with
    std::int64_t samples = 0;
    RunSummary summary;
    CollisionCounts collisions;
    std::vector<ReversalReport> reversals;  ///< in order of time
    RunSeconds seconds;
    std::vector<SurfaceReport> surfaces = {};   ///< by their numbers; none in a plain box
    std::optional<EnergyAccount> account = {};  ///< where there are any
    std::string state = {};  ///< fingerprint of all positions and velocities at the end, every bit
};

/// All events: collisions between particles and with walls.
std::int64_t events_of(const CollisionCounts& counts);

/// Takes each sample in order of time; all are valid during the call only.
using SampleTaker =
    std::function<void(const Particles&, const Sample&, const std::vector<SurfaceState>& surfaces)>;

/// Takes collisions in the order in which they happened, some thousand at a time; they are valid
/// during the call only. A sample comes after all that happened up to its time.
using CollisionTaker = std::function<void(const Particles&, std::span<const Collision>)>;

/// What takes the results of a run as they come; either may be empty. With `aside` they are called,
/// and statistics are made, on a thread of their own while the run goes on: the same, in the same
/// order.
struct RunTakers {
    SampleTaker sample = {};
    CollisionTaker collisions = {};
    bool aside = false;
};

/// Called with the progress of a run; any may be empty.
struct RunCallbacks {
    TrialCallback start = {};            ///< of the trials of the precision and the equilibration
    std::function<void()> started = {};  ///< at time 0
    std::function<void(double)> reached = {};  ///< this simulated time, many times a second
};

/// Runs `scene` from time 0 to its end with a sample at every multiple of `run.sample_every` and at
/// the end. Throws SceneError (the gas cannot be placed), Interrupted, and what `take` and the
/// callbacks throw. May be called from several threads. What is taken changes nothing in the run.
RunReport run_physics(const Scene& scene, const RunTakers& take = {},
                      const RunCallbacks& on_progress = {});

}  // namespace carom
