#include "physics/surfaces/barrier.h"

#include <algorithm>
#include <cmath>

#include "physics/surfaces/sheet.h"

namespace carom {
namespace {

using InPlane = Barrier<2>;
using InSpace = Barrier<3>;

template <int Dimension>
Barrier<Dimension> round_at(const Vec& center, double radius, std::int32_t surface) {
    Barrier<Dimension> barrier{
        .kind = Barrier<Dimension>::Kind::round, .radius = radius, .surface = surface};
    for (std::size_t a = 0; a < barrier.axes; ++a) barrier.place[a] = center[a];
    return barrier;
}

InPlane line_between(const Vec& begin, const Vec& end, std::int32_t surface) {
    const Vec step = end - begin;
    const double length = std::hypot(step[0], step[1]);
    return {.place = {begin[0], begin[1]},
            .normal = {-step[1] / length, step[0] / length},
            .from = {0.0},
            .to = {length},
            .surface = surface};
}

// The whole plane, or the line, perpendicular to an axis.
template <int Dimension>
Barrier<Dimension> flat_at(std::size_t axis, double at, std::int32_t surface) {
    Barrier<Dimension> barrier{.axis = axis, .surface = surface};
    // In the plane the line runs upwards, or to the right.
    barrier.normal[axis] = Dimension == 2 && axis == 0 ? -1.0 : 1.0;
    barrier.place[axis] = at;
    return barrier;
}

InSpace edge_at(std::size_t axis, const std::array<double, 2>& at, double from, double to,
                std::int32_t surface) {
    InSpace edge{.kind = InSpace::Kind::edge, .axis = axis, .surface = surface};
    const auto across = other_axes(axis);
    for (const std::size_t k : {0U, 1U}) edge.place[across[k]] = at[k];
    edge.from[0] = from;
    edge.to[0] = to;
    return edge;
}

// A partition extends from wall to wall except for its gaps, whose ends are corners.
void add_partition(const Box& box, const Partition& partition, std::int32_t surface,
                   std::vector<InPlane>& barriers) {
    const auto axis = static_cast<std::size_t>(partition.axis), along = 1 - axis;
    const InPlane line = flat_at<2>(axis, partition.at, surface);
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
        InPlane corner{.kind = InPlane::Kind::round, .surface = surface};
        corner.place[axis] = partition.at;
        corner.place[along] = where;
        barriers.push_back(corner);
    };
    const auto add_piece = [&](double to) {
        if (!(to > from)) return;
        // A piece that reaches a wall continues beyond it, because the wall may move.
        const bool goes_on_below = !box.is_periodic(along) && from == 0.0;
        const bool goes_on_above = !box.is_periodic(along) && to == end;
        InPlane piece = line;
        piece.place[along] = goes_on_below ? to : from;
        piece.from[0] = 0.0;
        if (!goes_on_below && !goes_on_above) piece.to[0] = to - from;
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

// In space the gaps have rims.
void add_partition(const Box& box, const Partition& partition, std::int32_t surface,
                   std::vector<InSpace>& barriers) {
    const auto axis = static_cast<std::size_t>(partition.axis);
    const auto along = other_axes(axis);
    const auto axis_of_sheet = [&](std::size_t k) {
        return Sheet::Axis{box.length(along[k]), box.is_periodic(along[k])};
    };
    const Sheet sheet({axis_of_sheet(0), axis_of_sheet(1)}, partition.gaps);
    for (const Sheet::Rectangle& piece : sheet.pieces) {
        InSpace face = flat_at<3>(axis, partition.at, surface);
        face.from = piece.low;
        face.to = piece.high;
        barriers.push_back(face);
    }
    for (const Sheet::Rim& rim : sheet.rims) {
        InSpace edge = edge_at(along[rim.axis], {}, rim.low, rim.high, surface);
        edge.place[axis] = partition.at;
        edge.place[along[1 - rim.axis]] = rim.at;
        barriers.push_back(edge);
    }
    for (const auto& corner : sheet.corners) {
        Vec center;
        center[axis] = partition.at;
        for (const std::size_t k : {0U, 1U}) center[along[k]] = corner[k];
        barriers.push_back(round_at<3>(center, 0.0, surface));
    }
}

// A cuboid that goes all around a periodic box has neither ends nor edges and corners there.
void add_cuboid(const Box& box, const Obstacle::Cuboid& cuboid, std::int32_t surface,
                std::vector<InSpace>& barriers) {
    using Ends = std::array<double, 2>;
    std::array<bool, 3> goes_around;
    std::array<Ends, 3> ends;
    for (std::size_t a = 0; a < 3; ++a) {
        const double length = cuboid.high[a] - cuboid.low[a];
        goes_around[a] = box.is_periodic(a) && !(length < box.length(a));
        ends[a] = goes_around[a] ? Ends{-never<double>, never<double>}
                                 : Ends{cuboid.low[a], cuboid.high[a]};
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (goes_around[axis]) continue;
        const auto along = other_axes(axis);
        for (const double at : ends[axis]) {
            InSpace face = flat_at<3>(axis, at, surface);
            for (const std::size_t k : {0U, 1U}) {
                face.from[k] = ends[along[k]][0];
                face.to[k] = ends[along[k]][1];
            }
            barriers.push_back(face);
        }
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto across = other_axes(axis);
        if (goes_around[across[0]] || goes_around[across[1]]) continue;
        for (const double first : ends[across[0]])
            for (const double second : ends[across[1]])
                barriers.push_back(
                    edge_at(axis, {first, second}, ends[axis][0], ends[axis][1], surface));
    }
    if (goes_around[0] || goes_around[1] || goes_around[2]) return;
    for (const double x : ends[0])
        for (const double y : ends[1])
            for (const double z : ends[2]) barriers.push_back(round_at<3>({x, y, z}, 0.0, surface));
}

void add_obstacle(const Box&, const Obstacle& obstacle, std::int32_t surface,
                  std::vector<InPlane>& barriers) {
    if (const auto* disk = std::get_if<Obstacle::Ball>(&obstacle.shape)) {
        barriers.push_back(round_at<2>(disk->center, disk->radius, surface));
        return;
    }
    const auto& lines = std::get<Obstacle::Lines>(obstacle.shape);
    const std::size_t count = lines.corners.size();
    for (std::size_t k = 0; k < count; ++k) {
        barriers.push_back(round_at<2>(lines.corners[k], 0.0, surface));
        if (k + 1 == count && !lines.is_closed) break;
        barriers.push_back(line_between(lines.corners[k], lines.corners[(k + 1) % count], surface));
    }
}

void add_obstacle(const Box& box, const Obstacle& obstacle, std::int32_t surface,
                  std::vector<InSpace>& barriers) {
    if (const auto* sphere = std::get_if<Obstacle::Ball>(&obstacle.shape))
        barriers.push_back(round_at<3>(sphere->center, sphere->radius, surface));
    else
        add_cuboid(box, std::get<Obstacle::Cuboid>(obstacle.shape), surface, barriers);
}

// The images of barriers that a particle near a periodic side may touch.
template <int Dimension>
void add_images(const Box& box, std::size_t axis, double reach,
                std::vector<Barrier<Dimension>>& barriers) {
    const double size = box.length(axis);
    for (std::size_t k = 0, count = barriers.size(); k < count; ++k) {
        const Barrier<Dimension> barrier = barriers[k];
        if (std::isinf(barrier.low(axis))) continue;
        for (const double shift : {-size, size}) {
            if (!(barrier.low(axis) + shift < size + reach) ||
                !(barrier.high(axis) + shift > -reach))
                continue;
            barriers.push_back(barrier);
            barriers.back().shift(axis, shift);
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

bool is_inside(const Obstacle::Cuboid& cuboid, const Vec& point, const Box& box) {
    const Vec center = 0.5 * (cuboid.low + cuboid.high), half = 0.5 * (cuboid.high - cuboid.low);
    const Vec from = abs(box.nearest(point - center));
    return on_each_axis(3, [&](int axis) { return from[axis] < half[axis]; });
}

// Whether a point lies within an obstacle of which only the outside has barriers.
bool is_inside(const Obstacle& obstacle, const Vec& point, const Box& box) {
    if (const auto* lines = std::get_if<Obstacle::Lines>(&obstacle.shape))
        return is_inside(*lines, point);
    const auto* cuboid = std::get_if<Obstacle::Cuboid>(&obstacle.shape);
    return cuboid != nullptr && is_inside(*cuboid, point, box);
}

}  // namespace

template <int Dimension>
double Barrier<Dimension>::end_along(std::size_t of_axis, bool high) const {
    if (kind == Kind::round) return place[of_axis] + (high ? radius : -radius);
    if constexpr (Dimension == 2) {
        const double step = of_axis == 0 ? normal[1] : -normal[0];
        if (step == 0.0) return place[of_axis];
        const double begin = place[of_axis] + step * from[0], end = place[of_axis] + step * to[0];
        return high ? std::max(begin, end) : std::min(begin, end);
    } else {
        for (std::size_t k = 0; k < extent_count(); ++k)
            if (axis_along(k) == of_axis) return place[of_axis] + (high ? to[k] : from[k]);
        return place[of_axis];
    }
}

// What adjoins in a surface must still adjoin in its image: in space all its parts keep the same
// origin along themselves, and coordinates on both sides of a border are compared with one number.
template <int Dimension>
void Barrier<Dimension>::shift(std::size_t along_axis, double by) {
    if constexpr (Dimension == 3) {
        for (std::size_t k = 0; k < extent_count(); ++k) {
            if (axis_along(k) != along_axis) continue;
            from[k] += by;
            to[k] += by;
            return;
        }
    }
    place[along_axis] += by;
}

template struct Barrier<2>;
template struct Barrier<3>;

template <int Dimension>
double distance_from(const Barrier<Dimension>& barrier, const Vec& point) {
    using Kind = typename Barrier<Dimension>::Kind;
    typename Barrier<Dimension>::Point x;
    for (std::size_t a = 0; a < barrier.axes; ++a) x[a] = point[a] - barrier.place[a];
    if (!barrier.extends_to(x)) return never<double>;
    if (barrier.kind == Kind::flat) {
        const double distance = barrier.across(x);
        return barrier.side_of(distance) * distance;
    }
    if constexpr (Dimension == 2) {
        return std::hypot(x[0], x[1]) - barrier.radius;
    } else {
        if (barrier.kind == Kind::edge) x[barrier.axis] = 0.0;
        return std::hypot(x[0], x[1], x[2]) - barrier.radius;
    }
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

template <int Dimension>
std::vector<Barrier<Dimension>> barriers_of(const Box& box, double reach, bool with_open) {
    const Surfaces& surfaces = box.surfaces;
    std::vector<Barrier<Dimension>> barriers;
    std::int32_t surface = 0;
    for (; surface < surfaces.first_partition(); ++surface) {
        const auto axis = static_cast<std::size_t>(surfaces.axis_of(surface));
        if (box.is_periodic(axis) || !box.has_surface(surface)) continue;
        Barrier<Dimension> wall = flat_at<Dimension>(axis, box.place_of(surface), surface);
        wall.is_wall = true;
        wall.normal[axis] = surface % 2 == 0 ? 1.0 : -1.0;
        barriers.push_back(wall);
    }
    for (const Partition& partition : surfaces.partitions) {
        if (with_open || !partition.is_open) add_partition(box, partition, surface, barriers);
        ++surface;
    }
    for (const Obstacle& obstacle : surfaces.obstacles)
        add_obstacle(box, obstacle, surface++, barriers);
    for (std::size_t axis = 0; axis < Dimension; ++axis)
        if (box.is_periodic(axis)) add_images(box, axis, reach, barriers);
    return barriers;
}

template <int Dimension>
std::optional<std::int32_t> surface_in_the_way(const Box& box,
                                               const std::vector<Barrier<Dimension>>& barriers,
                                               const Vec& center, double radius) {
    const double slack = slack_of_places(box);
    for (const Barrier<Dimension>& barrier : barriers)
        if (distance_from(barrier, center) < radius - slack) return barrier.surface;
    if (barriers.empty()) return std::nullopt;
    for (std::size_t k = 0; k < box.surfaces.obstacles.size(); ++k)
        if (is_inside(box.surfaces.obstacles[k], center, box))
            return box.surfaces.first_obstacle() + static_cast<std::int32_t>(k);
    return std::nullopt;
}

template std::vector<Barrier<2>> barriers_of<2>(const Box&, double, bool);
template double distance_from<2>(const Barrier<2>&, const Vec&);
template std::optional<std::int32_t> surface_in_the_way<2>(const Box&,
                                                           const std::vector<Barrier<2>>&,
                                                           const Vec&, double);
template std::vector<Barrier<3>> barriers_of<3>(const Box&, double, bool);
template double distance_from<3>(const Barrier<3>&, const Vec&);
template std::optional<std::int32_t> surface_in_the_way<3>(const Box&,
                                                           const std::vector<Barrier<3>>&,
                                                           const Vec&, double);

InitialBarriers::InitialBarriers(const Box& box) {
    if (box.dimension == 3)
        barriers_ = barriers_of<3>(box, box.longest_side());
    else
        barriers_ = barriers_of<2>(box, box.longest_side());
}

std::optional<std::int32_t> InitialBarriers::surface_in_the_way(const Box& box, const Vec& center,
                                                                double radius) const {
    return std::visit(
        [&](const auto& barriers) {
            return carom::surface_in_the_way(box, barriers, center, radius);
        },
        barriers_);
}

}  // namespace carom
