// Arrows: a shaft and a head, with an edge in the colour of the ground, so that they stand out from
// whatever they cross. Lengths are pixels. Independent of velocities.
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

/// The corners of an arrow that reaches exactly from `from` to `to`, which must differ; its tip is
/// the fourth corner.
std::array<Point, 7> arrow_outline(Point from, Point to, const ArrowStyle& style);

/// Draws an arrow, unless it would be shorter than the width of its shaft.
void draw_arrow(Canvas& canvas, Point from, Point to, const ArrowStyle& style);

/// Draws an arrow that is cut where it leaves `bounds`; two strokes through its shaft then mark
/// that it is longer than drawn.
void draw_arrow_within(Canvas& canvas, const Rect& bounds, Point from, Point to,
                       const ArrowStyle& style);

}  // namespace carom
