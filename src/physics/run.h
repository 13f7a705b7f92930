// What happens to the gas in time, as plain values.
#pragma once

#include <optional>
#include <variant>
#include <vector>

namespace carom {

struct ReverseVelocities {};

struct RunEvent {
    double at = 0.0;  ///< simulated time
    std::variant<ReverseVelocities> action;
};

struct Run {
    double until = 0.0;            ///< end, in simulated time
    double equilibrate = 0.0;      ///< simulated time before t = 0, not counted
    double sample_every = 0.0;     ///< simulated time between two samples of the statistics, which
                                   ///< are no event: the simulation itself does not look at it
    std::vector<RunEvent> events;  ///< in order of time; equal times in the order listed
};

}  // namespace carom
