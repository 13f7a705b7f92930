// Free flight between events, straight or under constant acceleration: position and velocity at a
// given time, and the time at which a coordinate reaches a given value. For any scalar with sqrt.
// The times stored in bodies refer to the clock of the event loop.
#pragma once

#include <cmath>
#include <cstddef>

#include "physics/collision/pair_collision.h"

namespace carom {

/// A body with its own constant acceleration; all other bodies move in straight lines.
template <typename Body>
concept Falls = requires(const Body& b) {
    b.a;
};

/// Position of a body at a time.
template <typename Body, typename Scalar>
Scalar position_at(const Body& b, std::size_t axis, const Scalar& now) {
    const Scalar t = now - b.time;
    if constexpr (Falls<Body>)
        return b.x[axis] + t * (b.v[axis] + 0.5 * t * b.a[axis]);
    else
        return b.x[axis] + b.v[axis] * t;
}

/// Velocity of a body at a time.
template <typename Body, typename Scalar>
decltype(auto) velocity_at(const Body& b, std::size_t axis, const Scalar& now) {
    if constexpr (Falls<Body>)
        return Scalar(b.v[axis] + b.a[axis] * (now - b.time));
    else
        return (b.v[axis]);
}

/// Advances a body in free flight to a time.
template <typename Body, typename Scalar>
inline void advance_body(Body& b, const Scalar& now) {
    for (std::size_t axis = 0; axis < b.x.size(); ++axis) {
        b.x[axis] = position_at(b, axis, now);
        if constexpr (Falls<Body>) b.v[axis] = velocity_at(b, axis, now);
    }
    b.time = now;
}

/// The first time at which the coordinate x + v t + a t^2 / 2, which may rise first, falls to 0.
/// Returns 0 if the coordinate is not above 0 and is falling, and `never` if it does not fall to 0.
template <typename Scalar>
Scalar fall_time(const Scalar& x, const Scalar& v, const Scalar& a) {
    using std::sqrt;
    if (!(x > 0.0) && (v < 0.0 || (v == 0.0 && a < 0.0))) return Scalar(0.0);
    if (a == 0.0) return v < 0.0 ? Scalar(x / -v) : Scalar(never<double>);
    const Scalar square = difference_of_products(v, v, Scalar(2.0 * a), x);
    if (a < 0.0) {  // concave: the later root is the one sought
        if (!(square > 0.0)) return Scalar(never<double>);
        const Scalar root = sqrt(square);
        return v > 0.0 ? Scalar((v + root) / -a) : Scalar(2.0 * x / (root - v));
    }
    if (!(v < 0.0) || !(x > 0.0) || !(square > 0.0)) return Scalar(never<double>);
    return 2.0 * x / (sqrt(square) - v);
}

}  // namespace carom
