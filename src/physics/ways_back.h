// Where a run with reversals goes back the way that it came, and what leads it off: an event that
// is not undone, or one that happens on the way back. Perturbations do not: how far these lead away
// is what return distances show. Plain values.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "physics/run.h"

namespace carom {

struct WayBack {
    double begin;                                          ///< the reversal
    double end = std::numeric_limits<double>::infinity();  ///< where it is left before the run has
                                                           ///< been everywhere again, else infinite
    std::optional<std::size_t> event = {};  ///< that leads off there, an index into the events
};

/// One for each reversal, in order of time.
std::vector<WayBack> ways_back(const std::vector<RunEvent>& events);

}  // namespace carom
