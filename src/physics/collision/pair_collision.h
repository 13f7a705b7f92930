// Contact arithmetic in the plane and in space: the contact time of two disks or spheres, and the
// time at which one reaches a wall.
// Free functions on numbers, for any scalar with sqrt, abs and a correctly rounded fma; what a
// contact does is in contact_rule.h. Independent of particles, box and clock: times are counted
// from the present.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "physics/collision/lanes.h"

namespace carom {

/// Position and velocity of the second body relative to the first (second minus first).
template <typename Scalar, std::size_t Dimension = 2>
struct RelativeMotion {
    std::array<Scalar, Dimension> r, v;
};

/// The scalar product, with plain arithmetic.
template <typename A, typename B, std::size_t Dimension>
[[gnu::always_inline]] inline B scalar_product(const std::array<A, Dimension>& a,
                                               const std::array<B, Dimension>& b) {
    static_assert(Dimension == 2 || Dimension == 3);
    if constexpr (Dimension == 2)
        return a[0] * b[0] + a[1] * b[1];
    else
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

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

/// a . b (two-products by fma).
template <typename Scalar, std::size_t Dimension>
[[gnu::always_inline]] inline Unrounded<Scalar> unrounded_product(
    const std::array<Scalar, Dimension>& a, const std::array<Scalar, Dimension>& b) {
    using carom::fma;
    using std::fma;
    const Scalar xx = a[0] * b[0];
    const Scalar yy = a[1] * b[1];
    const Unrounded<Scalar> sum = unrounded_sum(xx, yy);
    const Scalar error = fma(a[0], b[0], -xx) + fma(a[1], b[1], -yy);
    if constexpr (Dimension == 2) {
        return {sum.value, sum.error + error};
    } else {
        const Scalar zz = a[2] * b[2];
        const Unrounded<Scalar> all = unrounded_sum(sum.value, zz);
        return {all.value, (sum.error + all.error) + (error + fma(a[2], b[2], -zz))};
    }
}

/// |r|^2.
template <typename Scalar, std::size_t Dimension>
[[gnu::always_inline]] inline Unrounded<Scalar> square_of_distance(
    const RelativeMotion<Scalar, Dimension>& m) {
    return unrounded_product(m.r, m.r);
}

/// |r|^2 - sigma^2 without the cancellation of the rounded squares.
template <typename Scalar, std::size_t Dimension>
[[gnu::always_inline]] inline Scalar contact_gap(const RelativeMotion<Scalar, Dimension>& m,
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
template <typename Scalar, std::size_t Dimension>
[[gnu::always_inline]] inline Scalar approach_round_off(
    const RelativeMotion<Scalar, Dimension>& m, const std::array<Scalar, Dimension>& first_v,
    const std::array<Scalar, Dimension>& second_v) {
    using carom::abs;
    using std::abs;
    Scalar sum = abs(m.r[0]) * (abs(first_v[0]) + abs(second_v[0]));
    for (std::size_t k = 1; k < Dimension; ++k)
        sum = sum + abs(m.r[k]) * (abs(first_v[k]) + abs(second_v[k]));
    return 4 * epsilon_of<Scalar>() * sum;
}

/// r x v: in the plane its only component, in space three of them.
template <typename Scalar>
[[gnu::always_inline]] inline std::array<Scalar, 1> cross_product(
    const RelativeMotion<Scalar, 2>& m) {
    return {m.r[0] * m.v[1] - m.r[1] * m.v[0]};
}
template <typename Scalar>
[[gnu::always_inline]] inline std::array<Scalar, 3> cross_product(
    const RelativeMotion<Scalar, 3>& m) {
    return {m.r[1] * m.v[2] - m.r[2] * m.v[1], m.r[2] * m.v[0] - m.r[0] * m.v[2],
            m.r[0] * m.v[1] - m.r[1] * m.v[0]};
}

/// |a|^2 of one component or of three.
template <typename Scalar, std::size_t Count>
[[gnu::always_inline]] inline Scalar sum_of_squares(const std::array<Scalar, Count>& a) {
    if constexpr (Count == 1)
        return a[0] * a[0];
    else
        return scalar_product(a, a);
}

/// |r x v| without cancellation.
template <typename Scalar>
[[gnu::always_inline]] inline Scalar length_of_cross_product(const RelativeMotion<Scalar, 2>& m) {
    using carom::abs;
    using std::abs;
    return abs(difference_of_products(m.r[0], m.v[1], m.r[1], m.v[0]));
}
template <typename Scalar>
[[gnu::always_inline]] inline Scalar length_of_cross_product(const RelativeMotion<Scalar, 3>& m) {
    using carom::sqrt;
    using std::sqrt;
    const Scalar x = difference_of_products(m.r[1], m.v[2], m.r[2], m.v[1]);
    const Scalar y = difference_of_products(m.r[2], m.v[0], m.r[0], m.v[2]);
    const Scalar z = difference_of_products(m.r[0], m.v[1], m.r[1], m.v[0]);
    return sqrt(x * x + y * y + z * z);
}

/// r . v without cancellation.
template <typename Scalar>
[[gnu::always_inline]] inline Scalar accurate_approach(const RelativeMotion<Scalar, 2>& m) {
    return difference_of_products(m.r[0], m.v[0], -m.r[1], m.v[1]);
}
template <typename Scalar>
[[gnu::always_inline]] inline Scalar accurate_approach(const RelativeMotion<Scalar, 3>& m) {
    const Unrounded<Scalar> product = unrounded_product(m.r, m.v);
    return product.value + product.error;
}

/// A fast rejection test for a pair: plain arithmetic without roots, divisions or branches. Unless
/// approach > 0 and slack >= 0 the bodies certainly do not touch: they recede, or would miss each
/// other even if one were slightly larger. The margin is far above the rounding errors for pairs
/// less than 1e10 diameters apart.
template <typename Scalar>
struct QuickLook {
    Scalar approach;  ///< -r . v
    Scalar slack;     ///< sigma^2 v^2 - |r x v|^2 and a margin
};
template <typename Scalar, std::size_t Dimension>
[[gnu::always_inline]] inline QuickLook<Scalar> quick_look(
    const RelativeMotion<Scalar, Dimension>& m, const Scalar& sigma) {
    const Scalar approach = -scalar_product(m.r, m.v);
    if constexpr (Dimension == 2) {
        return {approach, 1.0001 * (sigma * sigma * scalar_product(m.v, m.v)) -
                              sum_of_squares(cross_product(m))};
    } else {
        // With |r x v|^2 = r^2 v^2 - (r . v)^2, which takes less arithmetic in space; the first
        // factor is for the rounding errors of the products.
        const Scalar gap = (1.0 - 1e-14) * scalar_product(m.r, m.r) - 1.0001 * (sigma * sigma);
        return {approach, approach * approach - scalar_product(m.v, m.v) * gap};
    }
}

/// Whether two approaching bodies, with `approach` = -r . v > 0, might touch within `time`; for
/// several lanes a mask. Until the contact time t their gap c = |r|^2 - sigma^2 shrinks by 2
/// approach t - v^2 t^2, which is less than the first term, so no root or division is needed. The
/// margins are far above the rounding errors for pairs less than 1e10 diameters apart.
template <typename Scalar, std::size_t Dimension>
[[gnu::always_inline]] inline auto might_touch_within(const RelativeMotion<Scalar, Dimension>& m,
                                                      const Scalar& sigma, const Scalar& approach,
                                                      const Scalar& time) {
    const Scalar gap = scalar_product(m.r, m.r) - 1.0001 * (sigma * sigma);
    return gap <= 2.0001 * (approach * time);
}

/// Time until two bodies with sum of radii `sigma` touch. Returns 0 if they overlap and approach,
/// and `never` if they miss each other, recede, or approach by no more than `round_off` in r . v.
/// Gives the same bits for a scalar and for several lanes: all cases are computed and the result is
/// selected. t = c / (-b + sqrt(disc)) with b = r . v < 0 and c = |r|^2 - sigma^2.
template <typename Number, std::size_t Dimension>
[[gnu::always_inline]] inline Number contact_time(const RelativeMotion<Number, Dimension>& m,
                                                  const Number& sigma, const Number& round_off) {
    using carom::sqrt;
    using std::sqrt;
    const Number none = Number{} + never<double>;
    const Number gap = contact_gap(m, sigma);
    const Number miss = length_of_cross_product(m);
    const Number reach = sigma * sqrt(scalar_product(m.v, m.v));
    const Number root = sqrt((reach - miss) * (reach + miss));
    const Number time = gap / (root - accurate_approach(m));
    const Number contact = select(gap > 0.0, select(miss < reach, time, none), Number{});
    return select(scalar_product(m.r, m.v) < -round_off, contact, none);
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
