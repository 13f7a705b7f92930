// The parts of works that runs, films and figures share.
#pragma once

#include <string>
#include <vector>

#include "films/cost/work.h"
#include "physics/placement/draws.h"
#include "scene/scene.h"

namespace carom {

/// Bytes of memory, upper estimates (docs/scaling.md).
inline constexpr double bytes_of_program = 120e6, bytes_of_particle = 1500.0;

inline double count_of(const Scene& scene) { return static_cast<double>(total_count(scene.gas)); }

/// The collisions of a run, or as many as it has events.
inline double collisions_of(const RunCounts& counts) {
    return counts.collisions.value_or(counts.events);
}

/// The samples of a run, that of its start included.
double samples_of(const Run& run);

/// CPU seconds in which the state of a particle is rounded to doubles, beyond what doubles take.
double seconds_of_look(int bits);

/// The simulation of a run, done so many times.
WorkPart simulation_part(const Scene& scene, const RunCounts& counts, double times);

/// A panel that sees a run, and is read in so many pictures.
struct SeeingPanel {
    std::string what;  ///< "the figure `speeds`"
    PanelSpec panel;
    double pictures = 1.0;
};

/// Panels that see `frames` moments of a run, in each of so many runs.
std::vector<WorkPart> panel_parts(const Scene& scene, const std::vector<SeeingPanel>& panels,
                                  double frames, const RunCounts& counts, double times);

}  // namespace carom
