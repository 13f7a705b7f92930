// The box as a plain value: its size, its walls and the surfaces in it. All lengths are in reduced
// units.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <utility>

#include "physics/surface.h"
#include "physics/vec.h"

namespace carom {

/// A part of a box, from corner to corner.
struct Region {
    Vec low, high;
};

enum class Wall { solid, periodic };

/// The pairs of sides perpendicular to x, to y and to z.
using Walls = std::array<Wall, 3>;

/// The box [0, size_x] x [0, size_y], or the line [0, size_x] when `dimension` is 1.
struct Box {
    int dimension = 2;
    Vec size = {};
    Walls walls{};
    Surfaces surfaces = {};  ///< behaviour of the sides, partitions, obstacles, gravity

    bool is_periodic(std::integral auto axis) const {
        return walls[static_cast<std::size_t>(axis)] == Wall::periodic;
    }
    /// Whether all of its sides are periodic, and whether none is.
    bool is_periodic() const {
        return on_each_axis(dimension, [&](int axis) { return is_periodic(axis); });
    }
    bool is_closed() const {
        return on_each_axis(dimension, [&](int axis) { return !is_periodic(axis); });
    }

    /// Its size along an axis.
    double length(std::integral auto axis) const { return size[axis]; }

    /// The longest and the shortest of its sides, and what they enclose: a length, an area or a
    /// volume.
    double longest_side() const { return longest(size, dimension); }
    double shortest_side() const { return shortest(size, dimension); }
    double content() const { return content_of(size, dimension); }

    /// The size of a side across an axis: 1 on a line, a length in the plane, an area in space.
    double content_across(int axis) const { return carom::content_across(size, dimension, axis); }

    /// Whether a part lies inside the box.
    bool contains(const Region& part) const {
        return on_each_axis(dimension, [&](int axis) {
            return !(part.low[axis] < 0.0) && !(part.high[axis] > size[axis]);
        });
    }

    /// Whether the box has this side, partition or obstacle: a line has its two ends only.
    bool has_surface(std::integral auto surface) const {
        return std::cmp_less(surface, 2 * dimension) ||
               (dimension > 1 && !surfaces.is_side(surface));
    }
    /// Initial position of a side or a partition on the axis that it is perpendicular to.
    double place_of(std::integral auto surface) const {
        const Partition* line = surfaces.partition(surface);
        if (line != nullptr) return line->at;
        return surfaces.is_far_side(surface) ? length(surface / 2) : 0.0;
    }

    /// Wraps a coordinate into [0, length) on a periodic axis; otherwise returns it unchanged.
    double wrapped(std::integral auto axis, double x) const {
        if (!is_periodic(axis)) return x;
        const double inside = x - length(axis) * std::floor(x / length(axis));
        return inside < length(axis) ? inside : 0.0;
    }

    /// The number of box lengths to subtract from a separation along an axis to get that of the
    /// nearest images; 0 if the axis is not periodic.
    double turns(std::integral auto axis, double separation) const {
        return is_periodic(axis) ? std::round(separation / length(axis)) : 0.0;
    }

    /// Minimum-image convention: the shortest vector between two points that are `separation`
    /// apart, across periodic sides where there are any. Nearest images are computed only here and
    /// in turns(), except in the contact search, which handles several pairs at once
    /// (cells/contact_search.h).
    Vec nearest(const Vec& separation) const {
        const auto along = [&](int axis) {
            const double apart = separation[axis];
            return axis < dimension ? apart - size[axis] * turns(axis, apart) : apart;
        };
        return {along(0), along(1), along(2)};
    }
};

}  // namespace carom
