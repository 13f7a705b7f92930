// The marks of a collision map: points, arrows and lines, as they are in the plane and as samples
// in the key. Knows no velocities.
#pragma once

#include <vector>

#include "draw/arrow.h"
#include "panels/panel.h"

namespace carom {

/// What a mark stands for.
enum class MapMark {
    before,
    after,
    energy,
    momentum,  ///< the line of a collision
    steps,     ///< of a walk, between the two
    walls,     ///< steps of a walk
    equal,     ///< velocities
    center,    ///< the eigenvector that stays
    turning    ///< the one that turns round
};

constexpr double map_point_radius = 0.36;  // units

inline bool is_point(MapMark mark) { return mark == MapMark::before || mark == MapMark::after; }

ArrowStyle map_arrow_before(const DrawContext& dc);
ArrowStyle map_arrow_after(const DrawContext& dc);
ArrowStyle map_arrow_center(const DrawContext& dc);
Color momentum_color(const DrawContext& dc);
std::vector<double> momentum_dashes(const DrawContext& dc);
std::vector<double> wall_dashes(const DrawContext& dc);
std::vector<double> equal_dots(const DrawContext& dc);

/// The point before a collision is hollow.
void draw_map_point(Canvas& canvas, const DrawContext& dc, Point at, bool hollow);

/// As wide as `wide` units from `at`, on a line of words.
void draw_map_sample(Canvas& canvas, const DrawContext& dc, MapMark mark, Point at, double wide);

}  // namespace carom
