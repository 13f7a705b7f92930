// When a coordinate that falls reaches a place, and impulses without drift of the energy. Free
// functions on numbers, for any scalar with sqrt and a correctly rounded fma. Times are counted
// from the present.
#pragma once

#include <cmath>

#include "physics/collision/pair_collision.h"

namespace carom {

/// The first time at which the coordinate x + v t + a t^2 / 2 falls to 0: 0 when it is not above 0
/// and falls. It may rise first. `never` when it does not.
template <typename Scalar>
Scalar fall_time(const Scalar& x, const Scalar& v, const Scalar& a) {
    using std::sqrt;
    if (!(x > 0.0) && (v < 0.0 || (v == 0.0 && a < 0.0))) return Scalar(0.0);
    if (a == 0.0) return v < 0.0 ? Scalar(x / -v) : Scalar(never<double>);
    const Scalar square = difference_of_products(v, v, Scalar(2.0 * a), x);
    if (a < 0.0) {  // concave: at the later root
        if (!(square > 0.0)) return Scalar(never<double>);
        const Scalar root = sqrt(square);
        return v > 0.0 ? Scalar((v + root) / -a) : Scalar(2.0 * x / (root - v));
    }
    if (!(v < 0.0) || !(x > 0.0) || !(square > 0.0)) return Scalar(never<double>);
    return 2.0 * x / (sqrt(square) - v);
}

/// x / (a + b), rounded as if the sum were exact. The error of a rounded sum of two inverse masses
/// is the same at each collision of the two, and would make their energy drift.
template <typename Scalar>
Scalar divided_by_sum(const Scalar& x, const Scalar& a, const Scalar& b) {
    using std::fma;
    const Scalar sum = a + b;
    const Scalar b_rounded = sum - a;
    const Scalar error = (a - (sum - b_rounded)) + (b - b_rounded);
    const Scalar quotient = x / sum;
    if (error == 0.0) return quotient;
    return quotient + (fma(-quotient, sum, x) - quotient * error) / sum;
}

}  // namespace carom
