// Dims what lies under words or a panel, so that they are legible over anything.
#pragma once

#include "draw/canvas.h"

namespace carom {

/// Covers an area with a colour: fully in the middle, and toward the edges, over `feather` pixels,
/// less and less. `color` has the opacity of the middle.
void draw_scrim(Canvas& canvas, const Rect& area, double feather, Color color);

/// Covers what is in `all` and not in `area`, which lies in it.
void fill_around(Canvas& canvas, const Rect& all, const Rect& area, Color color);

}  // namespace carom
