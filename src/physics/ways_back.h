// The ways back of a run with reversals: when the run retraces its path, and which event makes it
// leave that path, either one that is not undone or one that happens on the way back. Perturbations
// do not end a way back: the return distance measures their effect. Plain values.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "physics/run.h"

namespace carom {

struct WayBack {
    double begin;                                          ///< time of the reversal
    double end = std::numeric_limits<double>::infinity();  ///< time at which the run leaves the way
                                                           ///< back before it has retraced its
                                                           ///< whole path; otherwise infinite
    std::optional<std::size_t> event = {};  ///< the event at which it leaves, an index into the
                                            ///< events
};

/// One for each reversal, in order of time.
std::vector<WayBack> ways_back(const std::vector<RunEvent>& events);

}  // namespace carom
