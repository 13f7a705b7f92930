// The laws of what crosses lines, and of walls that move.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "physics/theory/collision_rate.h"
#include "physics/theory/laws/laws.h"

namespace carom::laws {
namespace {

// Beyond this share of the box the theory of dilute gases has errors of more than a few per cent.
constexpr double densest = 0.05;
constexpr double widest_gaps = 0.25;  // share of a partition

// The places along the axis of a line that centres can reach, if theory knows the density there:
// all places of a periodic axis; between solid walls those of points on a line, and of a dilute gas
// away from the walls.
Law length_for(const BoxedGas& gas, const Asked& asked, const std::vector<Eigen::Index>& list) {
    const Eigen::ArrayXd& radius = gas.particles->radius;
    const double length = gas.box.length(asked.axis), r = radius[list.front()];
    if (gas.box.is_periodic(asked.axis)) return value(length);
    if (gas.box.dimension == 1 && radius.maxCoeff() > 0.0) return none(Why::rods);
    if (gas.box.dimension > 1 && packing_fraction(gas.box, *gas.particles) > densest)
        return none(Why::dense);
    if (!std::ranges::all_of(list, [&](Eigen::Index i) { return radius[i] == r; }))
        return none(Why::unequal_radii);
    const double at = asked.at.value_or(0.5 * length);
    if (at < 8.0 * r || at > length - 8.0 * r) return none(Why::near_wall);
    return value(length - 2.0 * r);
}

}  // namespace

// In each direction the rate of a particle is half of the mean |v| along the axis over the length
// available to it. Crossing particles are weighted with their speed, so that the mean energy of
// their motion along the axis is 2 / (D + 1) of what one component can have at most, and along
// another axis 1 / (D + 1).
Law flux(const BoxedGas& gas, const Asked& asked) {
    const Law all = distribution(gas, asked);
    if (!all) return all;
    if (gas.fixed > 0.0) return none(Why::fixed_particles);
    if (!asked.is_whole_line) return none(Why::part_of_line);
    const Law length = length_for(gas, asked, members(gas, asked));
    if (!length) return length;
    const EquilibriumGas& found = *all.equilibrium;
    const auto axis = static_cast<std::size_t>(asked.axis);
    double rate = 0.0, energy = 0.0;
    for (const MassGroup& group : found.groups) {
        EquilibriumGas own = found;
        own.groups = {group};
        const double crossing =
            0.5 * group.count * mean_speed_along(own, asked.axis) / length.value;
        double share = 2.0 * group.largest_share.at(axis);
        for (std::size_t other = 0; std::cmp_less(other, gas.box.dimension); ++other)
            if (other != axis) share += group.largest_share.at(other);
        rate += crossing;
        energy += crossing * found.energy * share / (freedoms(found) + 1.0);
    }
    return {.value = rate, .energy = energy};
}

// Whether the flux through gaps follows from the number and the temperature of the gas on each
// side. Whether it does so at a time also depends on the mean free path on each side.
Law gap_flux(const BoxedGas& gas, const Asked& asked) {
    const Partition* partition = gas.box.surfaces.partition(asked.surface);
    if (gas.box.dimension == 1) return none(Why::line);
    if (const auto reason =
            first_of(gas, {Why::no_finite_mass, Why::fixed_particles, Why::driven, Why::bath,
                           Why::piston, Why::membrane, Why::gravity, Why::obstacles}))
        return none(*reason);
    if (!gas.box.is_closed()) return none(Why::no_walls);
    if (partition == nullptr || gas.box.surfaces.partitions.size() > 1)
        return none(Why::partitions);
    double gaps = 0.0;
    for (const Gap& gap : partition->gaps) gaps += gap.extent(gas.box.dimension);
    if (!(gaps > 0.0)) return none(Why::no_gap);
    if (gaps > widest_gaps * gas.box.content_across(partition->axis)) return none(Why::wide_gap);
    if (packing_fraction(gas.box, *gas.particles) > densest) return none(Why::dense);
    return {};
}

// A free side on which only the gas and a constant force towards it act; on the gas act only this
// side and walls at rest. All share the energy, which excludes a single particle, points that never
// meet and a gas whose momentum along the piston is conserved.
Law piston(const BoxedGas& gas, const Asked& asked) {
    const Surfaces& surfaces = gas.box.surfaces;
    if (!surfaces.is_side(asked.surface)) return none(Why::partitions);
    const auto side = static_cast<std::size_t>(asked.surface);
    const auto* free_side = piston_of(surfaces.sides.at(side));
    if (free_side == nullptr) return none(Why::no_piston);
    if (const auto reason =
            first_of(gas, {Why::moving_infinite_mass, Why::driven, Why::bath, Why::event,
                           Why::partitions, Why::obstacles, Why::gravity}))
        return none(*reason);
    if (gas.influences.velocities) return none(Why::event);
    for (std::size_t k = 0; k < surfaces.numbered_sides().size(); ++k)
        if (k != side && piston_of(surfaces.sides[k])) return none(Why::pistons);
    const double inward =
        surfaces.is_far_side(asked.surface) ? -free_side->force : free_side->force;
    if (!(inward > 0.0)) return none(Why::no_force);
    if (const auto reason = first_of(gas, {Why::no_finite_mass, Why::fixed_particles}))
        return none(*reason);
    if (gas.box.dimension == 1) return {};
    if (gas.finite < 2.0) return none(gas.keeps_axes() ? Why::keeps_axes : Why::few);
    if (gas.conserves_across(surfaces.axis_of(asked.surface))) return none(Why::one_axis);
    return gas.has_points() ? none(Why::points) : Law{};
}

}  // namespace carom::laws
