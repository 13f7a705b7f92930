#include "physics/theory/billiard.h"

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <vector>

namespace carom {
namespace {

// Whether the fixed bodies, enlarged by the radius of the moving one, touch neither each other nor
// their own images nor a solid wall.
bool are_apart(const Box& box, const std::vector<Obstacle::Ball>& fixed, double radius) {
    for (std::size_t i = 0; i < fixed.size(); ++i) {
        const double reach = fixed[i].radius + radius;
        for (int axis = 0; axis < box.dimension; ++axis) {
            const double at = fixed[i].center[axis], length = box.length(axis);
            const double room =
                box.is_periodic(axis) ? 0.5 * length : std::min(at, length - at) - radius;
            if (room < reach) return false;
        }
        for (std::size_t j = 0; j < i; ++j)
            if (length(box.nearest(fixed[i].center - fixed[j].center)) <
                reach + fixed[j].radius + radius)
                return false;
    }
    return true;
}

}  // namespace

std::optional<double> mean_path_of_billiard(const Box& box, double radius, bool ends_at_walls) {
    const Surfaces& surfaces = box.surfaces;
    const int dimension = box.dimension;
    const bool has_walls = !box.is_periodic();
    if (dimension == 1 || !std::ranges::all_of(surfaces.sides, is_elastic) ||
        !surfaces.partitions.empty() || surfaces.has_gravity() || (has_walls && !ends_at_walls))
        return {};
    std::vector<Obstacle::Ball> fixed;
    for (const Obstacle& obstacle : surfaces.obstacles) {
        const auto* ball = std::get_if<Obstacle::Ball>(&obstacle.shape);
        if (ball == nullptr) return {};
        fixed.push_back(*ball);
    }
    if (!are_apart(box, fixed, radius)) return {};
    Vec room;
    for (int axis = 0; axis < dimension; ++axis)
        room[axis] = box.is_periodic(axis) ? box.length(axis) : box.length(axis) - 2.0 * radius;
    double content = content_of(room, dimension), boundary = 0.0;
    for (int axis = 0; axis < dimension; ++axis)
        if (!box.is_periodic(axis)) boundary += 2.0 * content_across(room, dimension, axis);
    for (const Obstacle::Ball& ball : fixed) {
        const double reach = ball.radius + radius;
        content -= content_of_ball(reach, dimension);
        boundary += 2.0 * std::numbers::pi * reach * (dimension == 2 ? 1.0 : 2.0 * reach);
    }
    if (!(boundary > 0.0) || !(content > 0.0)) return {};
    return (dimension == 2 ? std::numbers::pi : 4.0) * content / boundary;
}

}  // namespace carom
