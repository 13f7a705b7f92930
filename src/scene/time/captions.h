// When captions are on the screen, a function of the scene alone: for the frames, and for files
// that carry the same words beside the film. And the room that their line takes in a layout.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace carom {

/// Below, a caption cannot be read.
constexpr double least_caption_seconds = 2.5;

/// A caption on the screen: in every frame from `first` to `last`.
struct CaptionSpan {
    std::string words;   ///< not empty
    int first = 0;       ///< frame
    int last = 0;        ///< frame, included
    double start = 0.0;  ///< seconds of film
    double end = 0.0;    ///< seconds of film
};

/// One for each of the scene's captions, in order: each from the first frame at its time or after
/// it, until the next one, the end of its own seconds or that of the film. Empty words, and
/// captions that no frame is left for (`last` < `first`), are among them.
std::vector<CaptionSpan> caption_schedule(const Scene& scene);

/// How much of a caption is seen in a frame, from 0 to 1: it comes and goes within 0.2 s, but
/// stands whole in the first frame of the gas and in the last one.
double caption_opacity(const CaptionSpan& span, const Film& film, int frame);

/// The layout with room for the line of captions.
LayoutSpec with_caption_line(LayoutSpec layout);

}  // namespace carom
