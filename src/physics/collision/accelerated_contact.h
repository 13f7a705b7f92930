// The time at which a point on a parabola comes within a given distance of a point at rest: contact
// of a falling particle with a fixed disk or sphere, an edge or a corner, or of two particles of
// which only one falls. Free functions on numbers, for any scalar with sqrt and abs. Times are
// counted from the present. No contact is missed, however short, down to the rounding of positions.
//
// The gap c(t) = |r(t)|^2 - sigma^2 with r(t) = r + v t + a t^2 / 2 is a quartic. Its derivative is
// 2 h(t) with h = r(t) . v(t), and h' = (v^2 + r . a) + 3 (v . a) t + (3/2) a^2 t^2 is quadratic.
// The roots of h' are therefore known in closed form; between two of them h is monotone and has at
// most one root, and between the roots of h the same holds for c. Each root is bracketed and then
// refined by Newton steps that stay inside the bracket. c and h are evaluated from r(t) and v(t),
// because their expansion in powers of t suffers from cancellation.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "physics/collision/pair_collision.h"

namespace carom {

/// Position, velocity and constant acceleration of the second body relative to the first.
template <typename Scalar, std::size_t Dimension = 2>
struct AcceleratedMotion {
    std::array<Scalar, Dimension> r, v, a;

    RelativeMotion<Scalar, Dimension> at(const Scalar& t) const {
        const Scalar half = t * 0.5;
        RelativeMotion<Scalar, Dimension> then{r, v};
        for (std::size_t k = 0; k < Dimension; ++k) {
            then.r[k] = r[k] + t * (v[k] + a[k] * half);
            then.v[k] = v[k] + a[k] * t;
        }
        return then;
    }
};

/// Returns a root of a function that is monotone in [low, high] and has opposite signs, or a zero,
/// at the two ends. `value_and_slope(t)` returns the pair of value and derivative. `steps` limits
/// the Newton steps; it should be somewhat larger than the number of bits of the scalar.
template <typename Scalar, typename Function>
Scalar bracketed_root(Scalar low, Scalar high, int steps, const Function& value_and_slope) {
    const bool falls = value_and_slope(low).first > 0;
    Scalar t = (low + high) * 0.5;
    // Near a double root each Newton step gains only one bit, and a bracket much wider than its
    // root costs bisections as well.
    for (int step = 0; t > low && t < high; ++step) {
        const auto [value, slope] = value_and_slope(t);
        if ((value > 0) == falls)
            low = t;
        else
            high = t;
        const Scalar newton = t - value / slope;
        if (step < steps && newton == t) return t;
        t = step < steps && newton > low && newton < high ? newton : (low + high) * 0.5;
    }
    return low;
}

/// The positive roots of a + b t + c t^2 with c >= 0, in ascending order.
template <typename Scalar>
struct PositiveRoots {
    std::array<Scalar, 2> root{};
    int count = 0;

    PositiveRoots(const Scalar& a, const Scalar& b, const Scalar& c) {
        using std::sqrt;
        const Scalar square = difference_of_products(b, b, 4 * a, c);
        if (!(square > 0)) return;
        const Scalar q = (b > 0 ? -(b + sqrt(square)) : sqrt(square) - b) * 0.5;
        std::array<Scalar, 2> both{q / c, q == 0 ? q : a / q};
        if (both[1] < both[0]) std::swap(both[0], both[1]);
        for (Scalar& one : both)
            if (one > 0 && one < never<double>)
                root[static_cast<std::size_t>(count++)] = std::move(one);
    }
};

/// What accepts each contact: it counts at any time.
struct AcceptsAll {
    template <typename Scalar>
    bool operator()(const Scalar&) const {
        return true;
    }
};

/// The first time at which the distance falls to `sigma`. Returns 0 if the distance is already no
/// larger than `sigma` and r . v is below -`round_off`, and `never` if it does not fall to `sigma`.
/// `bits`: precision of the scalar. The acceleration must not be 0. With `is_inside` the distance
/// is at present no larger than `sigma`, except for round-off, and must first rise above `sigma`.
/// A contact counts only if accepts(t) holds at its time; otherwise the distance must rise above
/// `sigma` and fall again.
template <typename Scalar, std::size_t Dimension = 2, typename Accepts = AcceptsAll>
Scalar accelerated_contact_time(const AcceleratedMotion<Scalar, Dimension>& m, const Scalar& sigma,
                                const Scalar& round_off, int bits = 53, bool is_inside = false,
                                const Accepts& accepts = {}) {
    const int steps = bits + 64;
    const auto gap = [&](const Scalar& t) { return contact_gap(m.at(t), sigma); };
    const auto approach = [&](const Scalar& t) {
        const RelativeMotion<Scalar, Dimension> now = m.at(t);
        return scalar_product(now.r, now.v);
    };
    const auto gap_and_slope = [&](const Scalar& t) {
        return std::pair<Scalar, Scalar>(gap(t), 2 * approach(t));
    };
    const Scalar va = scalar_product(m.v, m.a), aa = scalar_product(m.a, m.a);
    const Scalar bend = scalar_product(m.v, m.v) + scalar_product(m.r, m.a);
    const auto approach_and_slope = [&](const Scalar& t) {
        return std::pair<Scalar, Scalar>(approach(t), bend + t * (3 * va + (1.5 * aa) * t));
    };
    using std::abs;
    using std::sqrt;
    const Scalar zero = m.r[0] - m.r[0];
    const Scalar now = scalar_product(m.r, m.v);
    const bool touches = is_inside || !(gap(zero) > 0);
    if (!is_inside && touches && (now < -round_off || (!(now > 0) && bend < 0))) {
        if (accepts(zero)) return zero;
        is_inside = true;
    }
    const PositiveRoots<Scalar> turns(bend, 3 * va, 1.5 * aa);
    const bool falls_at_first = now < 0 || (!(now > 0) && bend < 0);  // also if it starts from rest
    bool falls = falls_at_first && !touches;  // from `start` to the next root of h
    Scalar start = zero, low = zero;
    for (int piece = 0; piece <= turns.count; ++piece) {
        Scalar high = low;
        if (piece < turns.count) {
            high = turns.root[static_cast<std::size_t>(piece)];
        } else {  // h grows without end
            Scalar step = sqrt(scalar_product(m.r, m.r) / aa) + abs(va) / aa;
            if (!(step > 0 && step < never<double>)) step = zero + 1.0;  // the square underflows
            for (; !(approach(high) > 0); step = 2 * step) {
                high = high + step;
                if (!(high < never<double>)) return zero + never<double>;
            }
        }
        const bool falls_at_end = approach(high) < 0;
        if (falls_at_end != falls) {
            const bool falls_at_low = piece == 0 ? falls_at_first : approach(low) < 0;
            const bool turns_here = falls != falls_at_low;
            Scalar turn = turns_here ? low : bracketed_root(low, high, steps, approach_and_slope);
            if (falls && !(gap(turn) > 0) && !(is_inside && (start == zero || !(gap(start) > 0)))) {
                Scalar contact =
                    gap(start) > 0 ? bracketed_root(start, turn, steps, gap_and_slope) : start;
                if (accepts(contact)) return contact;
                is_inside = true;
            }
            start = std::move(turn);
            falls = falls_at_end;
        }
        low = std::move(high);
    }
    return zero + never<double>;
}

}  // namespace carom
