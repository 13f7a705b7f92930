// The time at which a particle reaches a barrier. Free functions on numbers, for doubles and for
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

/// The motion of a particle relative to a barrier, with the barrier's place as the origin.
template <typename Scalar, int Dimension>
struct BarrierMotion {
    static constexpr std::size_t axes = Dimension;
    std::array<Scalar, axes> x, v, a;
    double radius;

    Scalar place_at(const Scalar& t, std::size_t axis) const {
        return x[axis] + t * (v[axis] + 0.5 * t * a[axis]);
    }
    std::array<Scalar, axes> place_at(const Scalar& t) const {
        std::array<Scalar, axes> place = x;
        for (std::size_t k = 0; k < axes; ++k) place[k] = place_at(t, k);
        return place;
    }
};

/// Calls see(axis) for the axes along which the distance from an edge, a circle or a sphere counts:
/// not the one that an edge runs along.
template <int Dimension, typename See>
void for_each_axis_across(const Barrier<Dimension>& barrier, const See& see) {
    for (std::size_t k = 0; k < barrier.axes; ++k)
        if (Dimension == 2 || barrier.kind != Barrier<Dimension>::Kind::edge || k != barrier.axis)
            see(k);
}

/// Whether a particle may touch a barrier within `time`; false only if it certainly does not. Uses
/// a bound on the distance flown that needs no roots. `size` of the box bounds the rounding errors.
template <int Dimension>
inline bool may_touch_within(const Barrier<Dimension>& barrier,
                             const BarrierMotion<double, Dimension>& m, double time, double size) {
    const auto way = [&](double v, double a) {
        return time * (std::abs(v) + 0.5 * time * std::abs(a));
    };
    const double touching = barrier.radius + m.radius + 1e-9 * size;
    if (barrier.kind != Barrier<Dimension>::Kind::flat) {
        double reach = touching, square = 0.0;
        for_each_axis_across(barrier, [&](std::size_t k) {
            reach += way(m.v[k], m.a[k]);
            square += m.x[k] * m.x[k];
        });
        return !(square > reach * reach);
    }
    const double reach = touching + way(barrier.across(m.v), barrier.across(m.a));
    return !(std::abs(barrier.across(m.x)) > reach);
}

/// Bound on the rounding error of r . (v2 - v1) for numbers with this precision, as
/// approach_round_off() gives it for doubles; `fast`: |v1| + |v2| along each axis.
template <std::size_t Count>
double approach_error(const std::array<double, Count>& r, const std::array<double, Count>& fast,
                      int bits) {
    double sum = 0.0;
    for (std::size_t k = 0; k < Count; ++k) sum += std::abs(r[k]) * fast[k];
    return std::ldexp(8.0 * sum, -bits);
}

/// As contact_time(), for any scalar with sqrt.
template <typename Scalar, std::size_t Count>
Scalar plain_contact_time(const RelativeMotion<Scalar, Count>& m, const Scalar& sigma,
                          double round_off) {
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

/// Time until two particles touch, or `never`. `a` is the acceleration of the second relative to
/// the first. With `is_let_in` the second is inside the first, and can touch it only after leaving
/// it. A contact counts only if accepts(t) holds at its time.
template <typename Scalar, std::size_t Count, typename Accepts = AcceptsAll>
Scalar falling_contact_time(const RelativeMotion<Scalar, Count>& m,
                            const std::array<Scalar, Count>& a, const Scalar& sigma,
                            double round_off, int bits, bool is_let_in = false,
                            const Accepts& accepts = {}) {
    bool falls = false;
    for (const Scalar& along : a) falls = falls || along != 0.0;
    if (falls)
        return accelerated_contact_time<Scalar, Count>({m.r, m.v, a}, sigma, Scalar(round_off),
                                                       bits, is_let_in, accepts);
    if (is_let_in) return Scalar(never<double>);
    Scalar time = plain_contact_time(m, sigma, round_off);
    return time < never<double> && !accepts(time) ? Scalar(never<double>) : time;
}

/// Time until a particle touches a line or a face from either side, or `never`. A particle whose
/// center is nearer to it than `let_in` is being let through: it can touch it only after leaving it
/// and returning.
template <typename Scalar, int Dimension>
Scalar flat_time(const Barrier<Dimension>& flat, const BarrierMotion<Scalar, Dimension>& m,
                 double let_in) {
    const auto reaches_it = [&](const Scalar& t) {
        return t < never<double> && (flat.is_endless() || flat.extends_to(m.place_at(t)));
    };
    const Scalar x = flat.across(m.x), v = flat.across(m.v), a = flat.across(m.a);
    const double side = flat.side_of(x);
    const bool is_let_in = let_in > 0.0 && side * x < let_in;
    Scalar first = never<double>;
    if (!is_let_in || side * v > 0.0) {
        const Scalar t = fall_time<Scalar>(side * x - m.radius, side * v, side * a);
        if (reaches_it(t)) first = t;
    }
    // From the other side, after passing around an end of it or through it.
    if (!flat.is_wall && (side * a > 0.0 || is_let_in)) {
        const Scalar t = fall_time<Scalar>(-side * x - m.radius, -side * v, -side * a);
        if (t > 0.0 && t < first && reaches_it(t)) first = t;
    }
    return first;
}

/// Time until a particle is at the contact distance from a barrier, as far as only these axes
/// count, or `never`. A particle nearer to the rim than `let_in` is being let through, as in
/// flat_time().
template <typename Scalar, int Dimension, std::size_t Count, typename Accepts = AcceptsAll>
Scalar time_across(const Barrier<Dimension>& barrier, const BarrierMotion<Scalar, Dimension>& m,
                   const std::array<std::size_t, Count>& axes, double let_in, int bits,
                   const Accepts& accepts = {}) {
    const Scalar sigma = as_precise_as(m.x[0], barrier.radius) + m.radius;
    if (!(sigma > 0.0)) return Scalar(never<double>);
    const auto size = [](const Scalar& number) { return std::abs(static_cast<double>(number)); };
    RelativeMotion<Scalar, Count> across;
    std::array<Scalar, Count> a;
    std::array<double, Count> far, fast;
    for (std::size_t k = 0; k < Count; ++k) {
        across.r[k] = m.x[axes[k]];
        across.v[k] = m.v[axes[k]];
        a[k] = m.a[axes[k]];
        far[k] = size(across.r[k]);
        fast[k] = size(across.v[k]);
    }
    bool is_let_in = false;
    if (let_in > 0.0) {
        if constexpr (Count == 2)
            is_let_in = std::hypot(far[0], far[1]) < barrier.radius + let_in;
        else
            is_let_in = std::hypot(far[0], far[1], far[2]) < barrier.radius + let_in;
    }
    return falling_contact_time(across, a, sigma, approach_error(far, fast, bits), bits, is_let_in,
                                accepts);
}

/// Time until a particle touches a circle or a sphere, or `never`; `let_in` as above.
template <typename Scalar, int Dimension>
Scalar round_time(const Barrier<Dimension>& round, const BarrierMotion<Scalar, Dimension>& m,
                  double let_in, int bits) {
    if constexpr (Dimension == 2)
        return time_across(round, m, std::array<std::size_t, 2>{0, 1}, let_in, bits);
    else
        return time_across(round, m, std::array<std::size_t, 3>{0, 1, 2}, let_in, bits);
}

/// Time until a sphere touches an edge between its ends, or `never`; `let_in` as above. It may come
/// near the line of the edge beyond an end first, and fall back to the edge.
template <typename Scalar>
Scalar edge_time(const Barrier<3>& edge, const BarrierMotion<Scalar, 3>& m, double let_in,
                 int bits) {
    const auto is_between_ends = [&](const Scalar& t) {
        const Scalar along = m.place_at(t, edge.axis);
        return along >= edge.from[0] && along <= edge.to[0];
    };
    return time_across(edge, m, other_axes(edge.axis), let_in, bits, is_between_ends);
}

/// Time until a particle touches a barrier, or `never`; `let_in` as above.
template <typename Scalar, int Dimension>
Scalar time_to_barrier(const Barrier<Dimension>& barrier, const BarrierMotion<Scalar, Dimension>& m,
                       double let_in, int bits) {
    using Kind = typename Barrier<Dimension>::Kind;
    if (barrier.kind == Kind::flat) return flat_time(barrier, m, let_in);
    if constexpr (Dimension == 3)
        if (barrier.kind == Kind::edge) return edge_time(barrier, m, let_in, bits);
    return round_time(barrier, m, let_in, bits);
}

}  // namespace carom
