#include "physics/surfaces/barrier.h"

#include <algorithm>
#include <cmath>

namespace carom {
namespace {

// Length of a piece of a partition that continues beyond a wall, in units of the box.
constexpr double far_beyond = 1e6;

// A partition extends from wall to wall except for its gaps, whose ends are corners.
void add_partition(const Box& box, const Partition& partition, std::int32_t surface,
                   std::vector<Barrier>& barriers) {
    const auto axis = static_cast<std::size_t>(partition.axis), along = 1 - axis;
    Barrier line{.surface = surface};
    line.normal[axis] = axis == 0 ? -1.0 : 1.0;  // the line runs upwards, or to the right
    line.place[axis] = partition.at;
    if (partition.gaps.empty()) {
        barriers.push_back(line);
        return;
    }
    const double end = box.length(along);
    double from = 0.0;
    // There is no corner at a wall. At a periodic side there is one only if a gap adjoins it on
    // exactly one side.
    const bool gap_at_low = !(partition.gaps.front().from() > 0.0);
    const bool gap_at_high = !(partition.gaps.back().to() < end);
    const bool ends_at_border = box.is_periodic(along) && gap_at_low != gap_at_high;
    const auto add_corner = [&](double where) {
        if (!(where > 0.0 && where < end) && !ends_at_border) return;
        Barrier corner{.kind = Barrier::Kind::circle, .surface = surface};
        corner.place[axis] = partition.at;
        corner.place[along] = where;
        barriers.push_back(corner);
    };
    const auto add_piece = [&](double to) {
        if (!(to > from)) return;
        // A piece that reaches a wall continues beyond it, because the wall may move.
        const bool goes_on_below = !box.is_periodic(along) && from == 0.0;
        const bool goes_on_above = !box.is_periodic(along) && to == end;
        Barrier piece = line;
        piece.place[along] = goes_on_below ? to : from;
        piece.length = goes_on_below || goes_on_above ? far_beyond * end : to - from;
        if (goes_on_below) piece.normal[axis] = -piece.normal[axis];
        barriers.push_back(piece);
    };
    for (const Gap& gap : partition.gaps) {
        add_piece(gap.from());
        add_corner(gap.from());
        add_corner(gap.to());
        from = gap.to();
    }
    add_piece(end);
}

Barrier circle_at(const Vec& center, double radius, std::int32_t surface) {
    return {.kind = Barrier::Kind::circle,
            .place = {center[0], center[1]},
            .radius = radius,
            .surface = surface};
}

void add_obstacle(const Obstacle& obstacle, std::int32_t surface, std::vector<Barrier>& barriers) {
    if (const auto* disk = std::get_if<Obstacle::Ball>(&obstacle.shape)) {
        barriers.push_back(circle_at(disk->center, disk->radius, surface));
        return;
    }
    const auto& lines = std::get<Obstacle::Lines>(obstacle.shape);
    const std::size_t count = lines.corners.size();
    for (std::size_t k = 0; k < count; ++k) {
        barriers.push_back(circle_at(lines.corners[k], 0.0, surface));
        if (k + 1 == count && !lines.is_closed) break;
        const Vec step = lines.corners[(k + 1) % count] - lines.corners[k];
        const double length = std::hypot(step[0], step[1]);
        barriers.push_back({.place = {lines.corners[k][0], lines.corners[k][1]},
                            .normal = {-step[1] / length, step[0] / length},
                            .length = length,
                            .surface = surface});
    }
}

// The images of barriers that a disk near a periodic side may touch.
void add_images(const Box& box, std::size_t axis, double reach, std::vector<Barrier>& barriers) {
    const double size = box.length(axis);
    for (std::size_t k = 0, count = barriers.size(); k < count; ++k) {
        const Barrier barrier = barriers[k];
        if (std::isinf(barrier.low(axis))) continue;
        for (const double shift : {-size, size}) {
            if (!(barrier.low(axis) + shift < size + reach) ||
                !(barrier.high(axis) + shift > -reach))
                continue;
            barriers.push_back(barrier);
            barriers.back().place[axis] += shift;
        }
    }
}

// By the parity of the number of edges to the right of the point.
bool is_inside(const Obstacle::Lines& lines, const Vec& point) {
    bool inside = false;
    const std::size_t count = lines.corners.size();
    for (std::size_t k = 0; lines.is_closed && k < count; ++k) {
        const Vec &a = lines.corners[k], &b = lines.corners[(k + 1) % count];
        if ((a[1] > point[1]) == (b[1] > point[1])) continue;
        if (point[0] < a[0] + (point[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0])) inside = !inside;
    }
    return inside;
}

}  // namespace

double distance_from(const Barrier& barrier, const Vec& point) {
    const double x = point[0] - barrier.place[0], y = point[1] - barrier.place[1];
    if (barrier.kind == Barrier::Kind::circle) return std::hypot(x, y) - barrier.radius;
    const double along = x * barrier.normal[1] - y * barrier.normal[0];
    if (!barrier.is_endless() && (along < 0.0 || along > barrier.length)) return never<double>;
    const double distance = x * barrier.normal[0] + y * barrier.normal[1];
    return barrier.side_of(distance) * distance;
}

double Barrier::end_along(std::size_t axis, bool high) const {
    const double extent = kind == Kind::circle ? (high ? radius : -radius)
                          : is_endless()       ? (high ? never<double> : -never<double>)
                                               : length;
    if (kind == Kind::circle) return place[axis] + extent;
    const double step = axis == 0 ? normal[1] : -normal[0];
    if (step == 0.0) return place[axis];
    if (is_endless()) return extent;
    const double end = place[axis] + step * extent;
    return high ? std::max(place[axis], end) : std::min(place[axis], end);
}

std::vector<Behaviour> behaviours_of(const Box& box) {
    const Surfaces& surfaces = box.surfaces;
    const auto sides = surfaces.numbered_sides();
    std::vector<Behaviour> behaviours(sides.begin(), sides.end());
    for (const Partition& partition : surfaces.partitions)
        behaviours.push_back(partition.behaviour);
    behaviours.resize(behaviours.size() + surfaces.obstacles.size());
    return behaviours;
}

std::vector<Barrier> barriers_of(const Box& box, double reach, bool with_open) {
    const Surfaces& surfaces = box.surfaces;
    std::vector<Barrier> barriers;
    std::int32_t surface = 0;
    for (; surface < surfaces.first_partition(); ++surface) {
        const int axis = surfaces.axis_of(surface);
        if (box.is_periodic(axis) || !box.has_surface(surface)) continue;
        add_partition(box, {.name = "", .axis = axis, .at = box.place_of(surface)}, surface,
                      barriers);
        barriers.back().is_wall = true;
        for (double& along : barriers.back().normal)
            along = along == 0.0 ? 0.0 : surface % 2 == 0 ? 1.0 : -1.0;
    }
    for (const Partition& partition : surfaces.partitions) {
        if (with_open || !partition.is_open) add_partition(box, partition, surface, barriers);
        ++surface;
    }
    for (const Obstacle& obstacle : surfaces.obstacles) add_obstacle(obstacle, surface++, barriers);
    for (const std::size_t axis : {0U, 1U})
        if (box.is_periodic(axis)) add_images(box, axis, reach, barriers);
    return barriers;
}

std::optional<std::int32_t> surface_in_the_way(const Box& box, const std::vector<Barrier>& barriers,
                                               const Vec& center, double radius) {
    const double slack = slack_of_places(box);
    for (const Barrier& barrier : barriers)
        if (distance_from(barrier, center) < radius - slack) return barrier.surface;
    if (barriers.empty()) return std::nullopt;
    for (std::size_t k = 0; k < box.surfaces.obstacles.size(); ++k) {
        const auto* lines = std::get_if<Obstacle::Lines>(&box.surfaces.obstacles[k].shape);
        if (lines != nullptr && is_inside(*lines, center))
            return box.surfaces.first_obstacle() + static_cast<std::int32_t>(k);
    }
    return std::nullopt;
}

}  // namespace carom
