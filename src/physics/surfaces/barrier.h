// Barriers, the parts that make up a surface: in the plane straight lines and circles, in space
// faces, edges and spheres. A corner is a circle or a sphere of radius 0. In space faces and edges
// are parallel to the axes.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "physics/box.h"
#include "physics/collision/pair_collision.h"
#include "physics/surface.h"

namespace carom {

/// A part of a surface, at rest or moving with it. Where there is no thickness, the two sides are
/// alike. `Dimension` is 2, also for the ends of a line, or 3.
template <int Dimension>
struct Barrier {
    static_assert(Dimension == 2 || Dimension == 3);
    static constexpr std::size_t axes = Dimension;
    using Point = std::array<double, axes>;
    using Extents = std::array<double, axes - 1>;
    enum class Kind : std::uint8_t {
        flat,  ///< a straight line, or in space a face
        edge,  ///< in space: a straight line along an axis
        round  ///< a circle or a sphere
    };
    static constexpr Extents all_equal(double value) {
        Extents all;
        all.fill(value);
        return all;
    }

    Kind kind = Kind::flat;
    bool is_wall = false;  ///< a side of the box, which acts only inwards
    std::size_t axis =
        0;           ///< in space: that a face is perpendicular to, or that an edge runs along
    Point place{};   ///< the center of a circle or a sphere; a point of a line, an edge or a
                     ///< face: in space the one whose coordinates along it are 0
    Point normal{};  ///< of a line or a face, of length about 1; that of a wall points inwards
    /// Where a line, an edge or a face begins and ends along itself, relative to its place: a line
    /// in the direction that has the normal to its left; a face along the other two axes, in
    /// ascending order; an edge has the first of the two only. Infinite where it goes on beyond a
    /// wall, because that may move, or around a periodic box.
    Extents from = all_equal(-never<double>), to = all_equal(never<double>);
    double radius = 0.0;       ///< of a circle or a sphere
    std::int32_t surface = 0;  ///< number of the surface it belongs to

    /// Whether it is a line or a face that runs from wall to wall in each direction.
    bool is_endless() const {
        if (kind != Kind::flat) return false;
        for (std::size_t k = 0; k < from.size(); ++k)
            if (from[k] != -never<double> || to[k] != never<double>) return false;
        return true;
    }

    /// The number of directions in which it extends.
    std::size_t extent_count() const {
        return kind == Kind::flat ? axes - 1 : kind == Kind::edge ? 1 : 0;
    }
    /// In space: the axis of extent k of a face or an edge.
    std::size_t axis_along(std::size_t k) const {
        return kind == Kind::edge ? axis : other_axes(axis)[k];
    }

    /// Coordinates relative to the place of a line or a face: along the normal, and along the
    /// barrier in the direction of extent k.
    template <typename Scalar>
    Scalar across(const std::array<Scalar, axes>& x) const {
        if constexpr (Dimension == 2)
            return scalar_product(normal, x);
        else
            return normal[axis] * x[axis];
    }
    template <typename Scalar>
    Scalar along(const std::array<Scalar, axes>& x, std::size_t k) const {
        if constexpr (Dimension == 2)
            return x[0] * normal[1] - x[1] * normal[0];
        else
            return x[axis_along(k)];
    }
    /// Whether the foot of the perpendicular from a point is between the ends.
    template <typename Scalar>
    bool extends_to(const std::array<Scalar, axes>& x) const {
        for (std::size_t k = 0; k < extent_count(); ++k) {
            const Scalar share = along(x, k);
            if (!(share >= from[k] && share <= to[k])) return false;
        }
        return true;
    }

    /// The side of a line or a face, 1 or -1, on which a point at this signed distance along the
    /// normal lies; always 1 for a wall.
    template <typename Scalar>
    double side_of(const Scalar& distance) const {
        return is_wall || !(distance < 0.0) ? 1.0 : -1.0;
    }

    /// The lower and the upper end of the barrier along an axis.
    double low(std::size_t of_axis) const { return end_along(of_axis, false); }
    double high(std::size_t of_axis) const { return end_along(of_axis, true); }

    /// Moves it along an axis.
    void shift(std::size_t along_axis, double by);

  private:
    double end_along(std::size_t of_axis, bool high) const;
};

extern template struct Barrier<2>;
extern template struct Barrier<3>;

/// The behaviour of each surface of a box in the order of their numbers: the sides, the partitions,
/// the obstacles.
std::vector<Behaviour> behaviours_of(const Box& box);

/// All barriers of the surfaces, and their images outside a periodic box up to a distance of
/// `reach`; unless `with_open`, without the barriers of open partitions. With `Dimension` 3 the box
/// is in space.
template <int Dimension>
std::vector<Barrier<Dimension>> barriers_of(const Box& box, double reach, bool with_open = false);

/// Overlaps of a particle up to this depth are attributed to the round-off of positions; a length.
inline double slack_of_places(const Box& box) { return 1e-12 * box.longest_side(); }

/// The distance of a point from a barrier: negative only inside a circle or a sphere or beyond a
/// wall, infinite past the ends of a line, an edge or a face.
template <int Dimension>
double distance_from(const Barrier<Dimension>& barrier, const Vec& point);

/// The surface that a particle at `center` would overlap, or lie in, if any.
template <int Dimension>
std::optional<std::int32_t> surface_in_the_way(const Box& box,
                                               const std::vector<Barrier<Dimension>>& barriers,
                                               const Vec& center, double radius);

/// The barriers of a box of any dimension at the start.
class InitialBarriers {
  public:
    /// None, as for a box with plain walls.
    InitialBarriers() = default;
    /// As barriers_of(), with all images that a particle in the box may touch.
    explicit InitialBarriers(const Box& box);

    /// As the function above.
    std::optional<std::int32_t> surface_in_the_way(const Box& box, const Vec& center,
                                                   double radius) const;

  private:
    std::variant<std::vector<Barrier<2>>, std::vector<Barrier<3>>> barriers_;
};

}  // namespace carom
