// The frames in which something is on the screen for a while, computed from the scene alone:
// captions, panels that appear and disappear, spotlights, callouts.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "scene/panel_spec.h"
#include "scene/time/timeline.h"

namespace carom {

struct Film;

/// The frames `first` to `last`, both included; none if `last` < `first`.
struct Showing {
    int first = 0;
    int last = -1;
    double from = 0.0;                                       ///< simulated time
    double until = std::numeric_limits<double>::infinity();  ///< simulated time, not included

    /// Returns whether it is shown at a simulated time, which need not be that of a frame: for
    /// figures.
    bool holds(double time) const { return from <= time && time < until; }
};

/// Returns the frames from the first frame of the gas at or after the span's start until the span's
/// end, for at most `seconds` of film. `ticks` are the film's timeline().
Showing showing(const std::vector<Tick>& ticks, const Film& film, const TimeSpan& span,
                std::optional<double> seconds = {});

/// Returns the opacity in a frame, from 0 to 1, of something that is shown for a while. It fades in
/// and out within `fade_seconds`, except that it is fully visible in the first and in the last
/// frame of the gas.
double opacity(const Showing& showing, const Film& film, int frame, double fade_seconds);

}  // namespace carom
