// The events of a run that come again because its velocities are reversed: at a reversal at r, what
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
    bool is_undone;     ///< otherwise it is done once more, after a further reversal
};

/// What undoes an event, at the same time, if that alone says it: the opposite of opening, closing,
/// holding, releasing, and of giving an energy.
std::optional<RunEvent> opposite_of(const RunEvent& event);

/// Those up to the end of the run, in order of time.
std::vector<MirroredEvent> mirrored_events(const Run& run);

}  // namespace carom
