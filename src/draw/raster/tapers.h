// Draws many lines whose width and colour change from one end to the other: trails. On a raster by
// a fast method: the coverage of a pixel is found from its distance to the line. In a vector
// document as short lines, each of one width and colour.
#pragma once

#include <span>

#include "draw/canvas.h"

namespace carom {

/// A line with round ends, whose width and colour change linearly along it; colours are opaque.
struct Taper {
    Point from, to;                               ///< pixels
    double width_at_start = 0, width_at_end = 0;  ///< pixels
    Color color_at_start = {}, color_at_end = {};
};

/// Draws the lines in order, later ones over earlier ones, clipped to `clip`. On a raster coverages
/// are accurate to about 1/16 along the line, and 1/8 at its ends.
void draw_tapers(Canvas& canvas, std::span<const Taper> tapers, Rect clip);

}  // namespace carom
