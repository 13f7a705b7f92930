// When captions are on the screen, a function of the scene alone: for the frames, and for files
// that carry the same words beside the film. And the room that their line takes in a layout.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"
#include "scene/time/showing.h"

namespace carom {

/// Below, a caption cannot be read.
constexpr double least_caption_seconds = 2.5;

/// A caption on the screen.
struct CaptionSpan : Showing {
    std::string words;   ///< may be empty
    double start = 0.0;  ///< seconds of film
    double end = 0.0;    ///< seconds of film
};

/// One for each of the scene's captions, in order: each from the first frame at its time or after
/// it, until the next one, the end of its own seconds or that of the film. Empty words, and
/// captions that no frame is left for (`last` < `first`), are among them.
std::vector<CaptionSpan> caption_schedule(const Scene& scene);

/// How long a caption takes to come and to go.
constexpr double caption_fade_seconds = 0.2;

/// The layout with room for the line of captions.
LayoutSpec with_caption_line(LayoutSpec layout);

}  // namespace carom
