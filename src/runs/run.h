// Runs the physics only: from a scene to its samples and statistics, without pictures.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "panels/meters/instruments.h"
#include "physics/exact_positions.h"
#include "physics/reversal/precision.h"
#include "physics/simulation.h"
#include "physics/units/quantity.h"
#include "stats/run_statistics.h"

namespace carom {

struct Scene;

/// One reversal of all velocities, and how accurately the gas returned to its initial state. The
/// return ends at `home`: at 2 at, or earlier if the way back is left before (ways_back.h). There
/// is a `distance` only if the run lasts until `home` and no other reversal comes before.
struct ReversalReport {
    double at = 0.0;
    double home = 0.0;                            ///< time of the return
    std::optional<ReturnDistance> distance = {};  ///< from the initial state, at `home`
    std::int64_t events_out = 0;  ///< collisions in [0, at], including those with walls
    std::optional<std::int64_t> events_back = {};  ///< in (at, home], if the run lasts that long
};

/// Wall-clock seconds.
struct RunSeconds {
    double total = 0.0;
    double prepare = 0.0;   ///< placement and equilibration
    double simulate = 0.0;  ///< from time 0
    double samples = 0.0;   ///< statistics and SampleTaker; concurrent with the simulation if they
                            ///< have a thread of their own
};

/// The totals and the positions of a surface in a run.
struct SurfaceReport {
    std::string name;
    SurfaceTotals totals;
    struct Position {
        double mean, deviation, last;  ///< over the samples; last: at the end
    };
    std::optional<Position> position = {};  ///< only of a surface that moves or has moved
};

struct RunReport {
    std::int64_t particles = 0;
    int bits = bits_of_double;  ///< precision of the numbers used in the calculation
    std::int64_t samples = 0;
    RunSummary summary;
    CollisionCounts collisions;
    std::vector<ReversalReport> reversals;  ///< in order of time
    RunSeconds seconds;
    std::vector<SurfaceReport> surfaces = {};   ///< in order of their numbers; none in a plain box
    std::optional<EnergyAccount> account = {};  ///< only if there are surfaces, or heat was added
    std::vector<LastReading> readings = {};     ///< of the scene's instruments (Scene::measure)
    std::string state = {};  ///< fingerprint of all bits of the final positions and velocities
    UnitSystem units = UnitSystem::reduced;  ///< of its numbers: those of the scene
};

/// The number of all events: collisions between particles and with walls.
std::int64_t events_of(const CollisionCounts& counts);

/// Called with each sample in order of time. The arguments are valid during the call only.
using SampleTaker =
    std::function<void(const Particles&, const Sample&, const std::vector<SurfaceState>& surfaces)>;

/// Called with collisions in the order in which they happened, some thousand at a time. They are
/// valid during the call only. All collisions up to the time of a sample are passed before that
/// sample.
using CollisionTaker = std::function<void(const Particles&, std::span<const Collision>)>;

/// The receivers of a run's results; either may be empty. With `aside` they are called, and
/// statistics are computed, on a separate thread while the run goes on; results and order are the
/// same.
struct RunTakers {
    SampleTaker sample = {};
    CollisionTaker collisions = {};
    bool aside = false;
};

/// Callbacks for the progress of a run; any may be empty.
struct RunCallbacks {
    TrialCallback start = {};  ///< in the trials that find the precision, and in the equilibration
    std::function<void()> started = {};        ///< at time 0
    std::function<void(double)> reached = {};  ///< with the simulated time, many times a second
};

/// Runs `scene` from time 0 to its end, with a sample at every multiple of `run.sample_every` and
/// at the end. `take` does not influence the run. Throws SceneError (the gas cannot be placed),
/// Interrupted, and what `take` and the callbacks throw. Thread safety: may be called from several
/// threads.
RunReport run_physics(const Scene& scene, const RunTakers& take = {},
                      const RunCallbacks& on_progress = {});

}  // namespace carom
