// Describes in words what changes in the picture of a film rather than in the gas: panels that
// appear or disappear, spotlights, callouts, camera moves.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "scene/time/timeline.h"

namespace carom {

struct Scene;

/// A change of the picture, at a simulated time.
struct FilmNote {
    double at = 0.0;                                         ///< simulated time
    std::string words;                                       ///< a sentence without its full stop
    double until = std::numeric_limits<double>::infinity();  ///< simulated time when it ends; equal
                                                             ///< to `at` for something momentary
};

/// The notes on panels, spotlights, callouts and the camera, each kind in the scene's order.
/// `ticks` are the film's timeline().
std::vector<FilmNote> film_notes(const Scene& scene, const std::vector<Tick>& ticks);

}  // namespace carom
