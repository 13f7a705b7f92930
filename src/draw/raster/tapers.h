// Draws many lines whose width and colour change from one end to the other: trails. On a raster by
// a fast method: the coverage of a pixel is found from its distance to the line. In a vector
// document as short lines, each of one width and colour.
#pragma once

#include <span>

#include "draw/canvas.h"

namespace carom {

/// A line with round ends, whose width, colour and opacity change linearly along it; the alpha of
/// colours is not used.
struct Taper {
    Point from, to;                               ///< pixels
    double width_at_start = 0, width_at_end = 0;  ///< pixels
    Color color_at_start = {}, color_at_end = {};
    double opacity_at_start = 1,
           opacity_at_end = 1;  ///< on a raster; lines of documents are opaque
    bool is_joined = false;     ///< goes on from the line before, of the same colour: where several
                                ///< lines joined in this way overlap, the most opaque one counts
};

/// Draws the lines in order, later ones over earlier ones, clipped to `clip`. On a raster coverages
/// are accurate to about 1/16 along the line, and 1/8 at its ends.
void draw_tapers(Canvas& canvas, std::span<const Taper> tapers, Rect clip);

}  // namespace carom
