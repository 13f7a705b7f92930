// Arrows: a shaft and a head, with an edge in the colour of the ground, so that they stand out from
// whatever they cross. Lengths are pixels. Knows no velocities.
#pragma once

#include <array>

#include "draw/canvas.h"

namespace carom {

struct ArrowStyle {
    double shaft = 2.0;        ///< width
    double head_length = 8.0;  ///< shorter arrows have a smaller head
    double head_width = 8.0;
    double edge = 1.0;  ///< width of the edge
    Color color, edge_color;
};

/// The corners of an arrow, its tip the fourth: exactly from `from` to `to`, which are apart.
std::array<Point, 7> arrow_outline(Point from, Point to, const ArrowStyle& style);

/// Draws an arrow; none where it would be shorter than the width of its shaft.
void draw_arrow(Canvas& canvas, Point from, Point to, const ArrowStyle& style);

/// Draws an arrow that ends where it leaves `bounds`, with two strokes through its shaft if it
/// does: it is longer than it is drawn.
void draw_arrow_within(Canvas& canvas, const Rect& bounds, Point from, Point to,
                       const ArrowStyle& style);

}  // namespace carom
