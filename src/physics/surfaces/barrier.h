// The parts of which surfaces are made, straight lines and circles, and when a disk reaches one. A
// corner is a circle without radius. Times are counted from the present.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "physics/collision/accelerated_contact.h"
#include "physics/collision/pair_collision.h"
#include "physics/gas.h"
#include "physics/surface.h"

namespace carom {

/// A straight line or a circle that stands still, or moves with a mover.
struct Barrier {
    enum class Kind : std::uint8_t { line, circle };
    Kind kind = Kind::line;
    std::array<double, 2> place{};   ///< the beginning of a line, the center of a circle
    std::array<double, 2> normal{};  ///< of a line, about of length 1; the line goes to its right
    double length = never<double>;   ///< of a line; of one from wall to wall without end
    double radius = 0.0;             ///< of a circle
    std::int32_t surface = 0;        ///< that it is a part of
    std::int32_t mover = -1;         ///< that moves it; -1: it stands still

    bool is_endless() const { return kind == Kind::line && length == never<double>; }

    /// Where it begins along an axis, and where it ends.
    double low(std::size_t axis) const { return end_along(axis, false); }
    double high(std::size_t axis) const { return end_along(axis, true); }
    double end_along(std::size_t axis, bool high) const;
};

/// Whether such a surface moves.
bool moves(const Behaviour& behaviour);

/// Why a box cannot have its surfaces; nullptr: it can.
const char* what_is_wrong(const Box& box);

/// What each surface of a box does: the sides, the partitions, the obstacles.
std::vector<Behaviour> behaviours_of(const Box& box);

/// All barriers of the surfaces that are there, and their images about a periodic box as far as
/// `reach`. Surfaces that move are numbered in their order.
std::vector<Barrier> barriers_of(const Box& box, double reach);

/// The surface that a disk at `center` would overlap, or lie in, if any.
std::optional<std::int32_t> surface_in_the_way(const Box& box, const std::vector<Barrier>& barriers,
                                               const Eigen::Array2d& center, double radius);

/// The first time at which the coordinate x + v t + a t^2 / 2 falls to 0: 0 when it is not above 0
/// and falls. It may rise first. `never` when it does not.
template <typename Scalar>
Scalar fall_time(const Scalar& x, const Scalar& v, const Scalar& a) {
    using std::sqrt;
    if (!(x > 0) && (v < 0 || (v == 0 && a < 0))) return Scalar(0.0);
    if (a == 0) return v < 0 ? x / -v : Scalar(never<double>);
    const Scalar square = difference_of_products(v, v, 2 * a, x);
    if (a < 0) {  // concave: at the later root
        if (!(square > 0)) return Scalar(never<double>);
        const Scalar root = sqrt(square);
        return v > 0 ? (v + root) / -a : 2 * x / (root - v);
    }
    if (!(v < 0) || !(x > 0) || !(square > 0)) return Scalar(never<double>);
    return 2 * x / (sqrt(square) - v);
}

/// The motion of a disk as a barrier sees it.
struct BarrierMotion {
    std::array<double, 2> x, v, a;  ///< from the barrier's place
    double radius;
};

/// Time until a disk touches a line on either side, `never` if it does not. Where `left_it`, the
/// disk is just about to go through the line, or away from it, at this very time.
inline double line_time(const Barrier& line, const BarrierMotion& m, bool left_it) {
    const auto along = [&](const std::array<double, 2>& of) {
        return line.normal[0] * of[0] + line.normal[1] * of[1];
    };
    const auto reaches_it = [&](double t) {
        if (!(t < never<double>)) return false;
        if (line.is_endless()) return true;
        const double x = m.x[0] + t * (m.v[0] + 0.5 * t * m.a[0]);
        const double y = m.x[1] + t * (m.v[1] + 0.5 * t * m.a[1]);
        const double share = x * line.normal[1] - y * line.normal[0];
        return share >= 0.0 && share <= line.length;
    };
    const double x = along(m.x), v = along(m.v), a = along(m.a);
    const double side = x < 0.0 ? -1.0 : 1.0;
    double first = never<double>;
    if (!left_it || v * side > 0.0) {
        const double t = fall_time(side * x - m.radius, side * v, side * a);
        if (reaches_it(t)) first = t;
    }
    // From the other side, after it has gone round an end of the line, or through it.
    if (side * a > 0.0 || left_it) {
        const double t = fall_time(-side * x - m.radius, -side * v, -side * a);
        if (t > 0.0 && t < first && reaches_it(t)) first = t;
    }
    return first;
}

/// Time until a disk touches a circle, `never` if it does not.
inline double circle_time(const Barrier& circle, const BarrierMotion& m) {
    const RelativeMotion<double> motion{m.x[0], m.x[1], m.v[0], m.v[1]};
    const double sigma = circle.radius + m.radius;
    if (!(sigma > 0.0)) return never<double>;
    const double round_off = approach_round_off(motion, 0.0, 0.0, m.v[0], m.v[1]);
    if (m.a[0] == 0.0 && m.a[1] == 0.0) return contact_time(motion, sigma, round_off);
    return accelerated_contact_time<double>({m.x[0], m.x[1], m.v[0], m.v[1], m.a[0], m.a[1]}, sigma,
                                            round_off);
}

}  // namespace carom
