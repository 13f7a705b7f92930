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

ArrowStyle map_arrow_before(const Page& page);
ArrowStyle map_arrow_after(const Page& page);
ArrowStyle map_arrow_center(const Page& page);
Color momentum_color(const Page& page);
std::vector<double> momentum_dashes(const Page& page);
std::vector<double> wall_dashes(const Page& page);
std::vector<double> equal_dots(const Page& page);

/// The point before a collision is hollow.
void draw_map_point(Canvas& canvas, const Page& page, Point at, bool hollow);

/// As wide as `wide` units from `at`, on a line of words.
void draw_map_sample(Canvas& canvas, const Page& page, MapMark mark, Point at, double wide);

}  // namespace carom
