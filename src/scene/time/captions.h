// The times at which captions are on the screen, computed from the scene alone: for the frames, and
// for files with the same words that accompany the film. Also the room for the line of captions in
// a layout.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/layout.h"
#include "scene/time/showing.h"

namespace carom {

struct Scene;

/// A caption on the screen for less time than this cannot be read.
constexpr double least_caption_seconds = 2.5;

/// A caption on the screen.
struct CaptionSpan : Showing {
    std::string words;   ///< may be empty
    double start = 0.0;  ///< seconds of film
    double end = 0.0;    ///< seconds of film
};

/// Returns one span for each caption of the scene, in order. It begins at the first frame at or
/// after the caption's time, and ends at the next caption, after the caption's own seconds, or at
/// the end of the film. Includes captions without words, and those for which no frame is left
/// (`last` < `first`).
std::vector<CaptionSpan> caption_schedule(const Scene& scene);

/// The frames in which the subtitle stands at the place of captions: in the first seconds. None if
/// the template has no such place, or if it would be too short to be read.
std::optional<Showing> subtitle_showing(const Scene& scene);
constexpr double subtitle_seconds = 4.0;

/// The duration of a caption's fade-in and of its fade-out.
constexpr double caption_fade_seconds = 0.2;

/// Returns the layout with room made for the line of captions.
LayoutSpec with_caption_line(LayoutSpec layout);

}  // namespace carom
