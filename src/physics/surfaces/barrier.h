// Barriers, the parts that make up a surface: straight lines and circles. A corner is a circle of
// radius 0.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "physics/box.h"
#include "physics/collision/pair_collision.h"
#include "physics/surface.h"

namespace carom {

/// A straight line or a circle, at rest or moving with its surface.
struct Barrier {
    enum class Kind : std::uint8_t { line, circle };
    Kind kind = Kind::line;
    std::array<double, 2> place{};   ///< the beginning of a line, or the center of a circle
    std::array<double, 2> normal{};  ///< of a line, of length about 1, to the left of its
                                     ///< direction; that of a wall points into the box
    double length = never<double>;   ///< of a line; infinite if it runs from wall to wall
    double radius = 0.0;             ///< of a circle
    std::int32_t surface = 0;        ///< number of the surface it belongs to
    bool is_wall = false;            ///< a side of the box, which acts only inwards

    bool is_endless() const { return kind == Kind::line && length == never<double>; }

    /// The side of a line, 1 or -1, on which a point at this signed distance along the normal lies;
    /// always 1 for a wall.
    template <typename Scalar>
    double side_of(const Scalar& distance) const {
        return is_wall || !(distance < 0.0) ? 1.0 : -1.0;
    }

    /// The lower and the upper end of the barrier along an axis.
    double low(std::size_t axis) const { return end_along(axis, false); }
    double high(std::size_t axis) const { return end_along(axis, true); }
    double end_along(std::size_t axis, bool high) const;
};

/// The behaviour of each surface of a box in the order of their numbers: the sides, the partitions,
/// the obstacles.
std::vector<Behaviour> behaviours_of(const Box& box);

/// All barriers of the surfaces, and their images outside a periodic box up to a distance of
/// `reach`; unless `with_open`, without the barriers of open partitions.
std::vector<Barrier> barriers_of(const Box& box, double reach, bool with_open = false);

/// Overlaps of a disk up to this depth are attributed to the round-off of positions; a length.
inline double slack_of_places(const Box& box) { return 1e-12 * box.longest_side(); }

/// The distance of a point from a barrier: negative only inside a circle or beyond a wall, infinite
/// past the ends of a line.
double distance_from(const Barrier& barrier, const Vec& point);

/// The surface that a disk at `center` would overlap, or lie in, if any.
std::optional<std::int32_t> surface_in_the_way(const Box& box, const std::vector<Barrier>& barriers,
                                               const Vec& center, double radius);

}  // namespace carom
