// The time at which a disk reaches a barrier. Free functions on numbers, for doubles and for
// multiprecision. Times are counted from the present.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "physics/collision/accelerated_contact.h"
#include "physics/collision/flight.h"
#include "physics/collision/pair_collision.h"
#include "physics/multiprecision/multiprecision.h"
#include "physics/surfaces/barrier.h"

namespace carom {

/// The motion of a disk relative to a barrier, with the barrier's place as the origin.
template <typename Scalar>
struct BarrierMotion {
    std::array<Scalar, 2> x, v, a;
    double radius;
};

template <typename Scalar>
Scalar dot(const std::array<double, 2>& a, const std::array<Scalar, 2>& b) {
    return a[0] * b[0] + a[1] * b[1];
}

/// Whether a disk may touch a barrier within `time`; false only if it certainly does not. Uses a
/// bound on the distance flown that needs no roots. `size` of the box bounds the rounding errors.
inline bool may_touch_within(const Barrier& barrier, const BarrierMotion<double>& m, double time,
                             double size) {
    const auto way = [&](double v, double a) {
        return time * (std::abs(v) + 0.5 * time * std::abs(a));
    };
    const double touching = barrier.radius + m.radius + 1e-9 * size;
    if (barrier.kind == Barrier::Kind::circle) {
        const double reach = touching + way(m.v[0], m.a[0]) + way(m.v[1], m.a[1]);
        return !(m.x[0] * m.x[0] + m.x[1] * m.x[1] > reach * reach);
    }
    const std::array<double, 2>& n = barrier.normal;
    const double reach = touching + way(dot(n, m.v), dot(n, m.a));
    return !(std::abs(dot(n, m.x)) > reach);
}

/// Bound on the rounding error of r . (v2 - v1) for numbers with this precision, as
/// approach_round_off() gives it for doubles; `fast`: |v1| + |v2| along each axis.
inline double approach_error(double x, double y, double fast_x, double fast_y, int bits) {
    return std::ldexp(8.0 * (std::abs(x) * fast_x + std::abs(y) * fast_y), -bits);
}

/// As contact_time(), for any scalar with sqrt.
template <typename Scalar>
Scalar plain_contact_time(const RelativeMotion<Scalar>& m, const Scalar& sigma, double round_off) {
    if constexpr (HasLimits<Scalar>) {
        return contact_time(m, sigma, round_off);
    } else {
        using std::sqrt;
        const Scalar approach = scalar_product(m.r, m.v);
        if (!(approach < -round_off)) return Scalar(never<double>);
        const Scalar gap = scalar_product(m.r, m.r) - sigma * sigma;
        if (!(gap > 0.0)) return Scalar(0.0);
        const Scalar square =
            sigma * sigma * scalar_product(m.v, m.v) - sum_of_squares(cross_product(m));
        return square > 0.0 ? gap / (sqrt(square) - approach) : Scalar(never<double>);
    }
}

/// Time until two disks touch, or `never`. `a` is the acceleration of the second relative to the
/// first. With `is_let_in` the second is inside the first, and can touch it only after leaving it.
template <typename Scalar>
Scalar falling_contact_time(const RelativeMotion<Scalar>& m, const std::array<Scalar, 2>& a,
                            const Scalar& sigma, double round_off, int bits,
                            bool is_let_in = false) {
    if (a[0] == 0.0 && a[1] == 0.0)
        return is_let_in ? Scalar(never<double>) : plain_contact_time(m, sigma, round_off);
    return accelerated_contact_time<Scalar>({m.r, m.v, a}, sigma, Scalar(round_off), bits,
                                            is_let_in);
}

/// Time until a disk touches a line from either side, or `never`. A disk whose center is nearer to
/// the line than `let_in` is being let through: it can touch the line only after leaving it and
/// returning.
template <typename Scalar>
Scalar line_time(const Barrier& line, const BarrierMotion<Scalar>& m, double let_in) {
    const auto reaches_it = [&](const Scalar& t) {
        if (!(t < never<double>)) return false;
        if (line.is_endless()) return true;
        const Scalar x = m.x[0] + t * (m.v[0] + 0.5 * t * m.a[0]);
        const Scalar y = m.x[1] + t * (m.v[1] + 0.5 * t * m.a[1]);
        const Scalar share = x * line.normal[1] - y * line.normal[0];
        return share >= 0.0 && share <= line.length;
    };
    const Scalar x = dot(line.normal, m.x), v = dot(line.normal, m.v), a = dot(line.normal, m.a);
    const double side = line.side_of(x);
    const bool is_let_in = let_in > 0.0 && side * x < let_in;
    Scalar first = never<double>;
    if (!is_let_in || side * v > 0.0) {
        const Scalar t = fall_time<Scalar>(side * x - m.radius, side * v, side * a);
        if (reaches_it(t)) first = t;
    }
    // From the other side, after passing around an end of the line or through it.
    if (!line.is_wall && (side * a > 0.0 || is_let_in)) {
        const Scalar t = fall_time<Scalar>(-side * x - m.radius, -side * v, -side * a);
        if (t > 0.0 && t < first && reaches_it(t)) first = t;
    }
    return first;
}

/// Time until a disk touches a circle, or `never`. A disk whose center is nearer to the rim than
/// `let_in` is being let through, as in line_time().
template <typename Scalar>
Scalar circle_time(const Barrier& circle, const BarrierMotion<Scalar>& m, double let_in, int bits) {
    const Scalar sigma = as_precise_as(m.x[0], circle.radius) + m.radius;
    if (!(sigma > 0.0)) return Scalar(never<double>);
    const auto size = [](const Scalar& number) { return std::abs(static_cast<double>(number)); };
    const double round_off =
        approach_error(size(m.x[0]), size(m.x[1]), size(m.v[0]), size(m.v[1]), bits);
    const bool is_let_in =
        let_in > 0.0 && std::hypot(size(m.x[0]), size(m.x[1])) < circle.radius + let_in;
    return falling_contact_time<Scalar>({m.x, m.v}, m.a, sigma, round_off, bits, is_let_in);
}

}  // namespace carom
