// Many lines that change their width and colour from one end to the other: trails. On a raster,
// fast: the coverage of a pixel is found from its distance to the line. In a vector document: short
// lines of one width and colour each.
#pragma once

#include <span>

#include "draw/canvas.h"

namespace carom {

/// With round ends. Width and colour change evenly along the line; colours are opaque.
struct Taper {
    Point from, to;                               ///< pixels
    double width_at_start = 0, width_at_end = 0;  ///< pixels
    Color color_at_start = {}, color_at_end = {};
};

/// Draws in order, later lines over earlier ones; clipped to `clip`. On a raster coverages are
/// right to 1/16 or so along the line, to 1/8 at its ends.
void draw_tapers(Canvas& canvas, std::span<const Taper> tapers, Rect clip);

}  // namespace carom
