// The events of a run that recur because its velocities are reversed: after a reversal at r, what
// happened at t is undone at 2 r - t.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "physics/run.h"

namespace carom {

struct MirroredEvent {
    double at;          ///< simulated time
    std::size_t event;  ///< index into Run::events
    bool is_undone;     ///< otherwise it is repeated, after a further reversal
};

/// The event that undoes another one, with the same time, if it follows from that event alone: the
/// opposite of opening, closing, holding, releasing, and adding an energy.
std::optional<RunEvent> opposite_of(const RunEvent& event);

/// The mirrored events up to the end of the run, in order of time.
std::vector<MirroredEvent> mirrored_events(const Run& run);

}  // namespace carom
