#include "stats/pressure.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace carom {
namespace {

// The area, in a plane the length, on a line the number, of the two walls across an axis.
double extent_of_walls(const Box& box, int axis) { return 2.0 * box.content_across(axis); }

double mean_radius(const Particles& particles) {
    const auto finite = (particles.inverse_mass > 0.0).cast<double>();
    return (finite * particles.radius).sum() / finite.sum();
}

double size_of_room(const Box& box, double radius) {
    const auto reach = [&](int axis) {
        return box.size[axis] - (box.is_periodic(axis) ? 0.0 : 2.0 * radius);
    };
    double sum = 0.0;
    for (int axis = 0; axis < box.dimension; ++axis) sum += box.content_across(axis) * reach(axis);
    return sum / box.dimension;
}

}  // namespace

bool has_one_pressure(const Box& box, std::span<const SurfaceState> states) {
    if (states.empty()) return true;
    const std::size_t first_partition = box.surfaces.numbered_sides().size();
    const auto partitions = states.subspan(first_partition, box.surfaces.partitions.size());
    return !box.surfaces.has_gravity() &&
           std::ranges::none_of(states.first(first_partition),
                                [](const SurfaceState& side) { return side.motion.has_value(); }) &&
           std::ranges::all_of(partitions, &SurfaceState::is_open);
}

ImpulseTotals PressureStart::since(const ImpulseTotals& totals) const {
    ImpulseTotals change = totals;
    for (std::size_t side = 0; side < change.wall.size(); ++side)
        change.wall[side] -= impulses.wall[side];
    change.virial -= impulses.virial;
    return change;
}

void PressureWatch::see(double time, const ImpulseTotals& impulses,
                        std::span<const SurfaceState> states) {
    if (!has_one_pressure(box_, states))
        start_.reset();
    else if (!start_)
        start_ = PressureStart{time, impulses};
}

std::optional<double> wall_pressure(const Box& box, const ImpulseTotals& impulses, double time) {
    double momentum = 0.0;
    double extent = 0.0;
    for (int axis = 0; axis < box.dimension; ++axis) {
        if (box.is_periodic(axis)) continue;
        const std::size_t side = 2 * static_cast<std::size_t>(axis);
        momentum += impulses.wall[side] + impulses.wall[side + 1];
        extent += extent_of_walls(box, axis);
    }
    if (!(extent * time > 0.0) || !std::isfinite(momentum)) return std::nullopt;
    return momentum / (extent * time);
}

std::optional<double> virial_pressure(const Box& box, const Particles& particles,
                                      double thermal_energy, const ImpulseTotals& impulses,
                                      double time) {
    if (!(particles.inverse_mass > 0.0).any()) return std::nullopt;
    const double room = box.dimension * size_of_room(box, mean_radius(particles));
    if (!(room * time > 0.0)) return std::nullopt;
    return (2.0 * thermal_energy + impulses.virial / time) / room;
}

}  // namespace carom
