// What changes in the picture of a film rather than in the gas, in words: panels that come and go,
// spotlights, callouts, the camera.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "scene/time/timeline.h"

namespace carom {

/// Something that is seen from a time on.
struct FilmNote {
    double at = 0.0;                                         ///< simulated time
    std::string words;                                       ///< a sentence without its full stop
    double until = std::numeric_limits<double>::infinity();  ///< simulated time when it is over;
                                                             ///< `at`, of what only happens
};

/// Of panels, spotlights, callouts and the camera, each in the scene's order. `ticks` are the
/// film's timeline().
std::vector<FilmNote> film_notes(const Scene& scene, const std::vector<Tick>& ticks);

}  // namespace carom
