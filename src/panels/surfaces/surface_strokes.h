// The elements of pictures of surfaces: hatching, waves, arrows. Independent of the box.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "panels/panel.h"

namespace carom {

/// The sides of a box around its picture: left, right, bottom, top.
inline constexpr std::size_t bottom_side = 2, top_side = 3;
inline bool is_upright(std::size_t side) { return side < bottom_side; }

/// The lines of a box's outline, just outside of its interior `room`. Walls are solid lines. A
/// periodic side is dashed, and both sides of such a pair have the same chevrons in their middle:
/// one on the left and the right, two on the bottom and the top. `joined`: whether x and y are
/// periodic.
std::vector<std::vector<Point>> outline_of_box(const Rect& room, std::array<bool, 2> joined,
                                               double unit);
void draw_box_outline(Canvas& canvas, const DrawContext& dc, const Rect& room,
                      std::array<bool, 2> joined);

/// Hatches a polygon with lines that rise to the right; all are parts of one grid over the whole
/// picture.
void hatch_polygon(Canvas& canvas, const std::vector<Point>& corners, double apart, double width,
                   Color color);

/// A heat bath: a band with a wavy line along it.
void draw_bath(Canvas& canvas, const DrawContext& dc, const Rect& band, bool upright, Color color);

/// A diffuse wall: a row of teeth that point outward from a side, and on a partition a row of
/// lozenges.
void draw_teeth(Canvas& canvas, const DrawContext& dc, const Rect& band, std::size_t side);
void draw_rough_line(Canvas& canvas, const DrawContext& dc, Point from, Point to);

/// A demon: a dotted line across the box, and an eye in a block beside it.
void draw_dotted_line(Canvas& canvas, const DrawContext& dc, Point from, Point to);
void draw_eye(Canvas& canvas, const DrawContext& dc, const Rect& block);

/// The holder of a partition that moves; hatched if its motion is imposed.
void draw_holder(Canvas& canvas, const DrawContext& dc, const Rect& block, bool is_imposed);

/// The hatching of a driven or held surface: slanted lines across a band outside of a side.
void draw_ticks(Canvas& canvas, const DrawContext& dc, const Rect& band, std::size_t side);

/// An arrow for a force, an imposed motion or gravity.
void draw_surface_arrow(Canvas& canvas, const DrawContext& dc, Point from, Point step);

/// The same along the line of sight: its tip, a dot in a circle, if it points toward the viewer,
/// otherwise its feathers, a cross.
void draw_arrow_end_on(Canvas& canvas, const DrawContext& dc, Point middle, bool toward_viewer);

}  // namespace carom
