// What the pictures of surfaces are made of: hatching, waves, arrows. Knows no box.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "panels/panel.h"

namespace carom {

/// The sides of a box: left, right, bottom, top.
inline constexpr std::size_t bottom_side = 2, top_side = 3;
inline bool is_upright(std::size_t side) { return side < bottom_side; }

/// The lines of a box's outline, outside of its room. Walls are whole lines; a side that is joined
/// to the opposite one is dashed, and both have the same chevrons in their middle: one on the left
/// and the right, two on the bottom and the top. `joined`: across x, across y.
std::vector<std::vector<Point>> outline_of_box(const Rect& room, std::array<bool, 2> joined,
                                               double unit);
void draw_box_outline(Canvas& canvas, const DrawContext& dc, const Rect& room,
                      std::array<bool, 2> joined);

/// Lines that rise to the right across a polygon, parts of one grid over the whole picture.
void hatch_polygon(Canvas& canvas, const std::vector<Point>& corners, double apart, double width,
                   Color color);

/// A heat bath: a band with a wavy line along it.
void draw_bath(Canvas& canvas, const DrawContext& dc, const Rect& band, bool upright, Color color);

/// The hatching of what is driven or held: slanted lines across a band outside of a side.
void draw_ticks(Canvas& canvas, const DrawContext& dc, const Rect& band, std::size_t side);

/// A force, a motion that is imposed, or gravity.
void draw_surface_arrow(Canvas& canvas, const DrawContext& dc, Point from, Point step);

}  // namespace carom
