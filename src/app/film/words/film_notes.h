// What changes in the picture of a film rather than in the gas, in words: panels that come and go,
// spotlights, callouts, the camera.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace carom {

/// Something that is seen from a time on.
struct FilmNote {
    double at = 0.0;    ///< simulated time
    std::string words;  ///< a sentence without its full stop
};

/// Of panels, spotlights, callouts and the camera, each in the scene's order.
std::vector<FilmNote> film_notes(const Scene& scene);

}  // namespace carom
