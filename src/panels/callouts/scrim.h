// Dims what lies under words or a panel, so that they are legible over anything.
#pragma once

#include <functional>

#include "draw/canvas.h"

namespace carom {

/// Covers an area with a colour: fully in the middle, and toward the edges, over `feather` pixels,
/// less and less. `color` has the opacity of the middle.
void draw_scrim(Canvas& canvas, const Rect& area, double feather, Color color);

/// Calls `cover` with the parts of `all` around `area`, which lies in it.
void cover_around(const Rect& all, const Rect& area, const std::function<void(const Rect&)>& cover);

}  // namespace carom
