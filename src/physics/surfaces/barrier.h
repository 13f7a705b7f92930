// The parts of which surfaces are made: straight lines and circles. A corner is a circle without
// radius.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "physics/collision/pair_collision.h"
#include "physics/gas.h"
#include "physics/surface.h"

namespace carom {

/// A straight line or a circle that stands still, or moves with its surface.
struct Barrier {
    enum class Kind : std::uint8_t { line, circle };
    Kind kind = Kind::line;
    std::array<double, 2> place{};   ///< the beginning of a line, the center of a circle
    std::array<double, 2> normal{};  ///< of a line, about of length 1; the line goes to its right;
                                     ///< that of a wall points into the box
    double length = never<double>;   ///< of a line; of one from wall to wall without end
    double radius = 0.0;             ///< of a circle
    std::int32_t surface = 0;        ///< that it is a part of

    bool is_endless() const { return kind == Kind::line && length == never<double>; }
    /// A side of the box: only one side of it counts.
    bool is_wall() const { return surface < Surfaces::first_partition; }

    /// On which side of a line a place is that is so far from it along the normal: 1 or -1.
    template <typename Scalar>
    double side_of(const Scalar& distance) const {
        return is_wall() || !(distance < 0.0) ? 1.0 : -1.0;
    }

    /// Where it begins along an axis, and where it ends.
    double low(std::size_t axis) const { return end_along(axis, false); }
    double high(std::size_t axis) const { return end_along(axis, true); }
    double end_along(std::size_t axis, bool high) const;
};

/// What each surface of a box does: the sides, the partitions, the obstacles.
std::vector<Behaviour> behaviours_of(const Box& box);

/// All barriers of the surfaces, and their images about a periodic box as far as `reach`; where not
/// `with_open`, without those of open partitions.
std::vector<Barrier> barriers_of(const Box& box, double reach, bool with_open = false);

/// How much deeper than this a disk lies in what it overlaps; less is round-off of places.
inline double slack_of_places(const Box& box) { return 1e-12 * box.size.maxCoeff(); }

/// The distance of a point from a barrier, negative only in a circle or beyond a wall; infinite
/// beside the ends of a line.
double distance_from(const Barrier& barrier, const Eigen::Array2d& point);

/// The surface that a disk at `center` would overlap, or lie in, if any.
std::optional<std::int32_t> surface_in_the_way(const Box& box, const std::vector<Barrier>& barriers,
                                               const Eigen::Array2d& center, double radius);

}  // namespace carom
