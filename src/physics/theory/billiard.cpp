#include "physics/theory/billiard.h"

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <vector>

namespace carom {
namespace {

// Whether the fixed disks, enlarged by the radius of the moving disk, touch neither each other nor
// their own images nor a solid wall.
bool are_apart(const Box& box, const std::vector<Obstacle::Ball>& disks, double radius) {
    for (std::size_t i = 0; i < disks.size(); ++i) {
        const double reach = disks[i].radius + radius;
        for (int axis = 0; axis < 2; ++axis) {
            const double at = disks[i].center[axis], length = box.length(axis);
            const double room =
                box.is_periodic(axis) ? 0.5 * length : std::min(at, length - at) - radius;
            if (room < reach) return false;
        }
        for (std::size_t j = 0; j < i; ++j)
            if (length(box.nearest(disks[i].center - disks[j].center)) <
                reach + disks[j].radius + radius)
                return false;
    }
    return true;
}

}  // namespace

std::optional<double> mean_path_of_billiard(const Box& box, double radius, bool ends_at_walls) {
    const Surfaces& surfaces = box.surfaces;
    const bool has_walls = !box.is_periodic(0) || !box.is_periodic(1);
    if (box.dimension != 2 || !std::ranges::all_of(surfaces.sides, is_elastic) ||
        !surfaces.partitions.empty() || surfaces.has_gravity() || (has_walls && !ends_at_walls))
        return {};
    std::vector<Obstacle::Ball> disks;
    for (const Obstacle& obstacle : surfaces.obstacles) {
        const auto* disk = std::get_if<Obstacle::Ball>(&obstacle.shape);
        if (disk == nullptr) return {};
        disks.push_back(*disk);
    }
    if (!are_apart(box, disks, radius)) return {};
    const auto room = [&](int axis) {
        return box.is_periodic(axis) ? box.length(axis) : box.length(axis) - 2.0 * radius;
    };
    double area = room(0) * room(1), perimeter = 0.0;
    for (int axis = 0; axis < 2; ++axis)
        if (!box.is_periodic(axis)) perimeter += 2.0 * room(1 - axis);
    for (const Obstacle::Ball& disk : disks) {
        const double reach = disk.radius + radius;
        area -= std::numbers::pi * reach * reach;
        perimeter += 2.0 * std::numbers::pi * reach;
    }
    if (!(perimeter > 0.0) || !(area > 0.0)) return {};
    return std::numbers::pi * area / perimeter;
}

}  // namespace carom
