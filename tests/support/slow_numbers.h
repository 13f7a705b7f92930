// Vectors and polynomials for the slow simulators, in long double.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "physics/box.h"
#include "physics/vec.h"

namespace carom::test {

constexpr long double infinite = std::numeric_limits<long double>::infinity();

// There are always three components; those that a plane or a line does not have are 0.
struct SlowVector {
    long double x = 0.0L, y = 0.0L, z = 0.0L;
    long double& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }
    long double operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
};

inline SlowVector slow(const Vec& a) { return {a[0], a[1], a[2]}; }
inline SlowVector operator+(const SlowVector& a, const SlowVector& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline SlowVector operator-(const SlowVector& a, const SlowVector& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline SlowVector operator*(long double t, const SlowVector& a) {
    return {t * a.x, t * a.y, t * a.z};
}
inline long double dot(const SlowVector& a, const SlowVector& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline long double size(const SlowVector& a) { return std::sqrt(dot(a, a)); }
/// The largest component, as an absolute value.
inline long double largest(const SlowVector& a) {
    return std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)});
}
inline SlowVector along_axis(int axis) {
    SlowVector one;
    one[axis] = 1.0L;
    return one;
}

/// Shifts of a box to its periodic images, up to so many box lengths away along each axis.
inline std::vector<SlowVector> images_of(const Box& box, int furthest) {
    std::vector<SlowVector> images{{}};
    for (int axis = 0; axis < box.dimension; ++axis) {
        if (!box.is_periodic(axis)) continue;
        std::vector<SlowVector> all;
        for (int turns = -furthest; turns <= furthest; ++turns)
            for (SlowVector image : images) {
                image[axis] = turns * static_cast<long double>(box.size[axis]);
                all.push_back(image);
            }
        images = std::move(all);
    }
    return images;
}

// The polynomial c[0] + c[1] t + ... + c[4] t^4.
struct Polynomial {
    std::array<long double, 5> c{};

    long double operator()(long double t) const {
        return c[0] + t * (c[1] + t * (c[2] + t * (c[3] + t * c[4])));
    }
    Polynomial slope() const { return {{c[1], 2.0L * c[2], 3.0L * c[3], 4.0L * c[4], 0.0L}}; }
    bool is_constant() const {
        return std::all_of(c.begin() + 1, c.end(), [](long double one) { return one == 0.0L; });
    }
};

// The places between 0 and `end` where the polynomial changes sign. Between two neighbouring sign
// changes of its derivative there is at most one.
inline std::vector<long double> sign_changes(const Polynomial& p, long double end) {
    std::vector<long double> found;
    if (p.is_constant()) return found;
    std::vector<long double> places = sign_changes(p.slope(), end);
    places.push_back(end);
    long double before = 0.0L;
    for (const long double place : places) {
        long double low = before, high = place;
        before = place;
        const bool falls = p(high) < 0.0L;
        if ((p(low) < 0.0L) == falls) continue;
        while (true) {
            const long double middle = 0.5L * (low + high);
            if (!(middle > low && middle < high)) break;
            ((p(middle) < 0.0L) == falls ? high : low) = middle;
        }
        found.push_back(high);
    }
    return found;
}

// The times before `end` at which the polynomial becomes negative, including 0 if it is negative
// and falling there.
inline std::vector<long double> falls_of(const Polynomial& p, long double end) {
    std::vector<long double> falls;
    bool is_negative = p(0.0L) < 0.0L;
    if (is_negative && p.c[1] < 0.0L) falls.push_back(0.0L);
    for (const long double t : sign_changes(p, end)) {
        is_negative = !is_negative;
        if (is_negative) falls.push_back(t);
    }
    return falls;
}

// The component of r + v t + a t^2 / 2 along a direction, as a polynomial of t.
inline Polynomial along(const SlowVector& direction, const SlowVector& r, const SlowVector& v,
                        const SlowVector& a) {
    return {{dot(direction, r), dot(direction, v), 0.5L * dot(direction, a), 0.0L, 0.0L}};
}

}  // namespace carom::test
