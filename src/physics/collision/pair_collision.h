// Contact arithmetic: the contact time of two disks, and the time at which a disk reaches a wall.
// Free functions on numbers, for any scalar with sqrt, abs and a correctly rounded fma; what a
// contact does is in contact_rule.h. Independent of particles, box and clock: times are counted
// from the present.
#pragma once

#include <cmath>
#include <limits>

#include "physics/collision/lanes.h"

namespace carom {

/// Position and velocity of the second disk relative to the first (second minus first).
template <typename Scalar>
struct RelativeMotion {
    Scalar x, y, vx, vy;
};

/// A number type with std::numeric_limits, which vectors of lanes do not have.
template <typename T>
concept HasLimits = std::numeric_limits<T>::is_specialized;

/// The time of an event that never happens; never<double> is used for lanes too.
template <HasLimits Scalar>
inline constexpr Scalar never = std::numeric_limits<Scalar>::infinity();

/// Machine epsilon of a number or of each of several lanes: the distance from 1 to the next larger
/// number.
template <HasLimits Scalar>
constexpr Scalar epsilon_of() {
    return std::numeric_limits<Scalar>::epsilon();
}
template <SomeLanes Lanes>
constexpr double epsilon_of() {
    return std::numeric_limits<double>::epsilon();
}

/// a b - c d to within 1.5 ulp (Kahan; proof: Jeannerod, Louvet and Muller 2013).
template <typename Scalar>
[[gnu::always_inline]] inline Scalar difference_of_products(const Scalar& a, const Scalar& b,
                                                            const Scalar& c, const Scalar& d) {
    using carom::fma;
    using std::fma;
    const Scalar cd = c * d;
    const Scalar error = fma(-c, d, cd);
    return fma(a, b, -cd) + error;
}

/// An unevaluated sum of two numbers: `value` is the rounded result and `error` its rounding error,
/// so that value + error is more accurate than one number can be.
template <typename Scalar>
struct Unrounded {
    Scalar value, error;
};

/// a + b (two-sum).
template <typename Scalar>
[[gnu::always_inline]] inline Unrounded<Scalar> unrounded_sum(const Scalar& a, const Scalar& b) {
    const Scalar sum = a + b;
    const Scalar b_rounded = sum - a;
    return {sum, (a - (sum - b_rounded)) + (b - b_rounded)};
}

/// |r|^2 (two-products by fma).
template <typename Scalar>
[[gnu::always_inline]] inline Unrounded<Scalar> square_of_distance(
    const RelativeMotion<Scalar>& m) {
    using carom::fma;
    using std::fma;
    const Scalar xx = m.x * m.x;
    const Scalar yy = m.y * m.y;
    const Unrounded<Scalar> sum = unrounded_sum(xx, yy);
    return {sum.value, sum.error + (fma(m.x, m.x, -xx) + fma(m.y, m.y, -yy))};
}

/// |r|^2 - sigma^2 without the cancellation of the rounded squares.
template <typename Scalar>
[[gnu::always_inline]] inline Scalar contact_gap(const RelativeMotion<Scalar>& m,
                                                 const Scalar& sigma) {
    using carom::fma;
    using std::fma;
    const Scalar ss = sigma * sigma;
    const Unrounded<Scalar> square = square_of_distance(m);
    return (square.value - ss) + (square.error - fma(sigma, sigma, -ss));
}

/// Bound on the rounding error of r . (v2 - v1): 4 epsilon sum |r_a| (|v1_a| + |v2_a|). An approach
/// slower than this cannot be distinguished from none, and its impulse might round to nothing again
/// and again.
template <typename Scalar>
[[gnu::always_inline]] inline Scalar approach_round_off(const RelativeMotion<Scalar>& m,
                                                        const Scalar& first_vx,
                                                        const Scalar& first_vy,
                                                        const Scalar& second_vx,
                                                        const Scalar& second_vy) {
    using carom::abs;
    using std::abs;
    return 4 * epsilon_of<Scalar>() *
           (abs(m.x) * (abs(first_vx) + abs(second_vx)) +
            abs(m.y) * (abs(first_vy) + abs(second_vy)));
}

/// A fast rejection test for a pair: plain arithmetic without roots, divisions or branches. Unless
/// approach > 0 and slack >= 0 the disks certainly do not touch: they recede, or would miss each
/// other even if one were slightly larger. The margin is far above the rounding errors for pairs
/// less than 1e10 diameters apart.
template <typename Scalar>
struct QuickLook {
    Scalar approach;  ///< -r . v
    Scalar slack;     ///< sigma^2 v^2 - |r x v|^2 and a margin
};
template <typename Scalar>
[[gnu::always_inline]] inline QuickLook<Scalar> quick_look(const RelativeMotion<Scalar>& m,
                                                           const Scalar& sigma) {
    const Scalar miss = m.x * m.vy - m.y * m.vx;
    return {-(m.x * m.vx + m.y * m.vy),
            1.0001 * (sigma * sigma * (m.vx * m.vx + m.vy * m.vy)) - miss * miss};
}

/// Whether two approaching disks, with `approach` = -r . v > 0, might touch within `time`; for
/// several lanes a mask. Until the contact time t their gap c = |r|^2 - sigma^2 shrinks by 2
/// approach t - v^2 t^2, which is less than the first term, so no root or division is needed. The
/// margins are far above the rounding errors for pairs less than 1e10 diameters apart.
template <typename Scalar>
[[gnu::always_inline]] inline auto might_touch_within(const RelativeMotion<Scalar>& m,
                                                      const Scalar& sigma, const Scalar& approach,
                                                      const Scalar& time) {
    const Scalar gap = (m.x * m.x + m.y * m.y) - 1.0001 * (sigma * sigma);
    return gap <= 2.0001 * (approach * time);
}

/// Time until two disks with sum of radii `sigma` touch. Returns 0 if they overlap and approach,
/// and `never` if they miss each other, recede, or approach by no more than `round_off` in r . v.
/// Gives the same bits for a scalar and for several lanes: all cases are computed and the result is
/// selected. t = c / (-b + sqrt(disc)) with b = r . v < 0 and c = |r|^2 - sigma^2.
template <typename Number>
[[gnu::always_inline]] inline Number contact_time(const RelativeMotion<Number>& m,
                                                  const Number& sigma, const Number& round_off) {
    using carom::abs;
    using carom::sqrt;
    using std::abs;
    using std::sqrt;
    const Number none = Number{} + never<double>;
    const Number gap = contact_gap(m, sigma);
    const Number miss = abs(difference_of_products(m.x, m.vy, m.y, m.vx));
    const Number reach = sigma * sqrt(m.vx * m.vx + m.vy * m.vy);
    const Number root = sqrt((reach - miss) * (reach + miss));
    const Number time = gap / (root - difference_of_products(m.x, m.vx, -m.y, m.vy));
    const Number contact = select(gap > 0.0, select(miss < reach, time, none), Number{});
    return select(m.x * m.vx + m.y * m.vy < -round_off, contact, none);
}

/// x / d.
template <typename Scalar>
[[gnu::always_inline]] inline Unrounded<Scalar> quotient_of(const Scalar& x,
                                                            const Unrounded<Scalar>& d) {
    using std::fma;
    const Scalar quotient = x / d.value;
    return {quotient, (fma(-quotient, d.value, x) - quotient * d.error) / d.value};
}

/// a b with one rounding.
template <typename Scalar>
[[gnu::always_inline]] inline Scalar product_of(const Scalar& a, const Unrounded<Scalar>& b) {
    using std::fma;
    const Scalar product = a * b.value;
    return product + (fma(a, b.value, -product) + a * b.error);
}

/// Time until a coordinate at x with velocity v reaches `low` (v < 0) or `high` (v > 0). Returns 0
/// if it is already beyond, and `never` for v = 0.
template <typename Scalar>
Scalar wall_time(const Scalar& x, const Scalar& v, const Scalar& low, const Scalar& high) {
    if (v == 0) return Scalar(never<double>);
    const Scalar time = ((v < 0 ? low : high) - x) / v;
    return time > 0 ? time : Scalar(0);
}

}  // namespace carom
