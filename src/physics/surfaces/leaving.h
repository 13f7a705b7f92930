// What is drawn when a particle leaves a heat bath or a diffuse wall: directions relative to the
// normal of the surface, by dimension. All functions may be called from any thread.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "physics/multiprecision/multiprecision.h"
#include "physics/vec.h"
#include "util/random.h"

namespace carom {

/// Vectors of length 1 that are perpendicular to a normal of length 1 and to each other: along a
/// face that is perpendicular to an axis, the directions of the other axes in ascending order.
template <typename Scalar>
std::array<std::array<Scalar, 2>, 1> tangents_of(const std::array<Scalar, 2>& normal) {
    return {{{normal[1], Scalar(-normal[0])}}};
}
/// In space the rotation that takes an axis to the normal by the shortest way takes the other two
/// to the tangents; the axis is that of the largest component.
template <typename Scalar>
std::array<std::array<Scalar, 3>, 2> tangents_of(const std::array<Scalar, 3>& normal) {
    using std::abs;
    std::size_t axis = 0;
    for (const std::size_t k : {1U, 2U})
        if (abs(normal[k]) > abs(normal[axis])) axis = k;
    const double side = normal[axis] < 0.0 ? -1.0 : 1.0;
    std::array<Scalar, 3> sum = normal;
    sum[axis] += side;
    std::array<std::array<Scalar, 3>, 2> tangents{};
    const auto others = other_axes(axis);
    for (const std::size_t j : {0U, 1U}) {
        const Scalar share = normal[others[j]] / (1.0 + abs(normal[axis]));
        for (std::size_t k = 0; k < 3; ++k) tangents[j][k] = -share * sum[k];
        tangents[j][others[j]] += 1.0;
    }
    return tangents;
}

/// The velocity of a particle that leaves a heat bath: the velocity along the normal has the
/// distribution of the flux, those along the tangents are normal. `thermal`: sqrt(T / m). The
/// normal points away from the surface if `side` is 1 and towards it if it is -1. Draws one uniform
/// number for the normal velocity, and then a normal one for each tangent in their order; on a
/// line, where a particle has no others, without `has_tangents`.
template <std::size_t Count>
std::array<double, Count> velocity_from_bath(Random& random, double thermal, double side,
                                             const std::array<double, Count>& normal,
                                             bool has_tangents) {
    const double away = thermal * std::sqrt(-2.0 * std::log1p(-random.uniform()));
    std::array<double, Count> v;
    for (std::size_t k = 0; k < Count; ++k) v[k] = side * away * normal[k];
    if (!has_tangents) return v;
    for (const auto& tangent : tangents_of(normal)) {
        const double along = thermal * random.normal();
        for (std::size_t k = 0; k < Count; ++k) v[k] += along * tangent[k];
    }
    return v;
}

/// A point in the interval from -1 to 1, or in the disk of radius 1, in which it is uniform. Draws
/// one number, or pairs of them until one lies within.
template <std::size_t Count>
std::array<double, Count> point_in_ball(Random& random) {
    static_assert(Count == 1 || Count == 2);
    std::array<double, Count> point;
    double square = 0.0;
    do {
        square = 0.0;
        for (double& along : point) {
            along = 2.0 * random.uniform() - 1.0;
            square += along * along;
        }
    } while (Count > 1 && !(square < 1.0));
    return point;
}

/// A direction by the cosine law, as a vector of length 1: its density is proportional to the
/// cosine of the angle to the normal, which points away from the surface. Its components along
/// minus the tangents, in their order, are those of point_in_ball(): in the plane the sine of the
/// angle is uniform, and in space the projection of the direction onto the surface is (Lambert).
template <typename Scalar, std::size_t Count>
std::array<Scalar, Count> direction_by_cosine_law(Random& random,
                                                  const std::array<Scalar, Count>& normal) {
    using std::sqrt;
    const auto drawn = point_in_ball<Count - 1>(random);
    std::array<Scalar, Count - 1> sines;
    for (std::size_t j = 0; j < sines.size(); ++j) sines[j] = as_precise_as(normal[0], drawn[j]);
    Scalar square;
    if constexpr (Count == 2)
        square = (1.0 - sines[0]) * (1.0 + sines[0]);
    else
        square = 1.0 - (sines[0] * sines[0] + sines[1] * sines[1]);
    const Scalar cosine = sqrt(square);
    const auto tangents = tangents_of(normal);
    std::array<Scalar, Count> direction;
    for (std::size_t k = 0; k < Count; ++k) {
        direction[k] = cosine * normal[k];
        for (std::size_t j = 0; j < sines.size(); ++j)
            direction[k] = direction[k] - sines[j] * tangents[j][k];
    }
    return direction;
}

}  // namespace carom
