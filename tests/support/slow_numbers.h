// Vectors and polynomials for the slow simulator of surfaces, in long double.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace carom::test {

constexpr long double infinite = std::numeric_limits<long double>::infinity();

struct SlowVector {
    long double x = 0.0L, y = 0.0L;
    long double& operator[](int axis) { return axis == 0 ? x : y; }
    long double operator[](int axis) const { return axis == 0 ? x : y; }
};

inline SlowVector operator+(SlowVector a, SlowVector b) { return {a.x + b.x, a.y + b.y}; }
inline SlowVector operator-(SlowVector a, SlowVector b) { return {a.x - b.x, a.y - b.y}; }
inline SlowVector operator*(long double t, SlowVector a) { return {t * a.x, t * a.y}; }
inline long double dot(SlowVector a, SlowVector b) { return a.x * b.x + a.y * b.y; }
inline long double size(SlowVector a) { return std::hypot(a.x, a.y); }
inline SlowVector left_of(SlowVector a) { return {-a.y, a.x}; }

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
inline Polynomial along(SlowVector direction, SlowVector r, SlowVector v, SlowVector a) {
    return {{dot(direction, r), dot(direction, v), 0.5L * dot(direction, a), 0.0L, 0.0L}};
}

}  // namespace carom::test
