// A vector of space as a plain value: a place, a velocity, a size or a momentum. There are always
// three components; those that a plane or a line does not have are 0, so that sums and scalar
// products are the same in each dimension. Only the event loop, whose bodies have as many
// coordinates as their space, has types of its own.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <numbers>

namespace carom {

struct Vec {
    constexpr Vec() = default;
    constexpr Vec(double x, double y, double z = 0.0) : along_{x, y, z} {}

    /// The component along an axis: 0 for x, 1 for y, 2 for z.
    constexpr double operator[](std::integral auto axis) const {
        return along_[static_cast<std::size_t>(axis)];
    }
    constexpr double& operator[](std::integral auto axis) {
        return along_[static_cast<std::size_t>(axis)];
    }

    constexpr Vec& operator+=(const Vec& b) { return *this = *this + b; }
    constexpr Vec& operator-=(const Vec& b) { return *this = *this - b; }
    constexpr Vec& operator*=(double factor) { return *this = factor * *this; }
    constexpr Vec& operator/=(double divisor) { return *this = *this / divisor; }

    friend constexpr bool operator==(const Vec&, const Vec&) = default;
    friend constexpr Vec operator-(const Vec& a) { return {-a[0], -a[1], -a[2]}; }
    friend constexpr Vec operator+(const Vec& a, const Vec& b) {
        return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
    }
    friend constexpr Vec operator-(const Vec& a, const Vec& b) {
        return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    }
    friend constexpr Vec operator*(double factor, const Vec& a) {
        return {factor * a[0], factor * a[1], factor * a[2]};
    }
    friend constexpr Vec operator*(const Vec& a, double factor) { return factor * a; }
    friend constexpr Vec operator/(const Vec& a, double divisor) {
        return {a[0] / divisor, a[1] / divisor, a[2] / divisor};
    }

    template <class Archive>
    void archive(Archive& archive) {
        archive(along_);
    }

  private:
    std::array<double, 3> along_{};
};

/// The name of an axis: x, y or z.
constexpr const char* name_of_axis(std::integral auto axis) {
    constexpr std::array names{"x", "y", "z"};
    return names[static_cast<std::size_t>(axis)];
}

/// The two axes of space other than this one, in ascending order.
constexpr std::array<std::size_t, 2> other_axes(std::size_t axis) {
    return {axis == 0 ? 1U : 0U, axis == 2 ? 1U : 2U};
}

/// The scalar product.
constexpr double dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// The vector product; of vectors in the plane it has a z component only.
constexpr Vec cross(const Vec& a, const Vec& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// |a|^2, and |a|.
constexpr double square(const Vec& a) { return dot(a, a); }
inline double length(const Vec& a) { return std::sqrt(square(a)); }

/// The longest and the shortest side of a box with these sides along the first `dimension` axes,
/// and what they enclose: a length, an area or a volume.
constexpr double longest(const Vec& sides, int dimension) {
    double most = sides[0];
    for (int axis = 1; axis < dimension; ++axis) most = std::max(most, sides[axis]);
    return most;
}
constexpr double shortest(const Vec& sides, int dimension) {
    double least = sides[0];
    for (int axis = 1; axis < dimension; ++axis) least = std::min(least, sides[axis]);
    return least;
}
constexpr double content_of(const Vec& sides, int dimension) {
    double product = sides[0];
    for (int axis = 1; axis < dimension; ++axis) product *= sides[axis];
    return product;
}
/// What these sides enclose across an axis: 1 on a line, a length in the plane, an area in space.
constexpr double content_across(const Vec& sides, int dimension, int axis) {
    double product = 1.0;
    for (int other = 0; other < dimension; ++other)
        if (other != axis) product *= sides[other];
    return product;
}

/// What a sphere of this radius encloses in so many dimensions: a length, an area or a volume.
constexpr double content_of_ball(double radius, int dimension) {
    using std::numbers::pi;
    if (dimension == 1) return 2.0 * radius;
    return dimension == 2 ? pi * radius * radius : 4.0 / 3.0 * pi * radius * radius * radius;
}

/// What a function of numbers gives of the components of one vector, or of two, axis by axis.
template <class Function>
constexpr Vec by_axis(const Function& f, const Vec& a) {
    return {f(a[0]), f(a[1]), f(a[2])};
}
template <class Function>
constexpr Vec by_axis(const Function& f, const Vec& a, const Vec& b) {
    return {f(a[0], b[0]), f(a[1], b[1]), f(a[2], b[2])};
}

/// Axis by axis the smaller, the larger, and the absolute value.
constexpr Vec lower(const Vec& a, const Vec& b) {
    return by_axis([](double x, double y) { return std::min(x, y); }, a, b);
}
constexpr Vec upper(const Vec& a, const Vec& b) {
    return by_axis([](double x, double y) { return std::max(x, y); }, a, b);
}
inline Vec abs(const Vec& a) {
    return by_axis([](double x) { return std::abs(x); }, a);
}

inline bool is_finite(const Vec& a) {
    return std::isfinite(a[0]) && std::isfinite(a[1]) && std::isfinite(a[2]);
}

/// Whether something holds along each of the first `dimension` axes.
template <class Condition>
constexpr bool on_each_axis(int dimension, const Condition& holds) {
    for (int axis = 0; axis < dimension; ++axis)
        if (!holds(axis)) return false;
    return true;
}

}  // namespace carom
