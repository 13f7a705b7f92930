// A partition in space as a flat sheet with rectangular gaps: the rectangles that remain, and the
// rims and corners of the gaps. Independent of the box and of motion. All functions may be called
// from any thread.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "physics/surface.h"

namespace carom {

/// What remains of a sheet between its gaps. Coordinates are those of its two axes; they are
/// infinite where it goes on beyond a wall, and where it goes all around a periodic box.
struct Sheet {
    /// One of its two axes: the length of the box along it.
    struct Axis {
        double length;
        bool is_periodic;
    };
    struct Rectangle {
        std::array<double, 2> low, high;
    };
    /// A straight part of a rim.
    struct Rim {
        std::size_t axis;  ///< that it runs along: 0 or 1
        double at;         ///< its coordinate along the other axis
        double low, high;
    };
    std::vector<Rectangle> pieces = {};               ///< they adjoin, and do not overlap
    std::vector<Rim> rims = {};                       ///< between the sheet and a gap
    std::vector<std::array<double, 2>> corners = {};  ///< where rims turn

    /// The sheet from wall to wall, without these gaps, which do not overlap. Gaps that touch are
    /// one opening: nothing remains between them. There is no rim at a wall, because the wall may
    /// move: a gap that adjoins it goes on beyond it. At a periodic side there is one where the
    /// sheet is open on one side only.
    Sheet(const std::array<Axis, 2>& axes, const std::vector<Gap>& gaps);
};

}  // namespace carom
