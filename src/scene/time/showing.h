// When something that a film shows for a while is on the screen, a function of the scene alone:
// captions, panels that come and go, spotlights, callouts.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "scene/scene.h"
#include "scene/time/timeline.h"

namespace carom {

/// From frame `first` to frame `last`, both included; none where `last` < `first`.
struct Showing {
    int first = 0;
    int last = -1;
    double from = 0.0;                                       ///< simulated time
    double until = std::numeric_limits<double>::infinity();  ///< simulated time, not included

    /// Whether it is there at a moment that need not be a frame's, as figures show them.
    bool holds(double time) const { return from <= time && time < until; }
};

/// From the first frame of the gas at the span's start or after it until the span's end, and for at
/// most so many seconds of film. `ticks` are the film's timeline().
Showing showing(const std::vector<Tick>& ticks, const Film& film, const TimeSpan& span,
                std::optional<double> seconds = {});

/// How much of it is seen in a frame, from 0 to 1: it comes and goes within `fade_seconds`, but
/// stands whole in the first frame of the gas and in the last one.
double opacity(const Showing& showing, const Film& film, int frame, double fade_seconds);

}  // namespace carom
