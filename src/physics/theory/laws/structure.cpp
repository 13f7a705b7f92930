// The laws of pressure and of places: what follows from where particles are.
#include <algorithm>
#include <cmath>

#include "physics/theory/barometric_law.h"
#include "physics/theory/collision_rate.h"
#include "physics/theory/equation_of_state.h"
#include "physics/theory/even_spread.h"
#include "physics/theory/laws/laws.h"

namespace carom::laws {
namespace {

std::optional<NoLaw> why_not_still(const BoxedGas& gas) {
    if (const auto reason = first_of(gas, {Why::moving_infinite_mass, Why::driven, Why::piston,
                                           Why::membrane, Why::gravity}))
        return reason;
    return gas.influences.wall_event ? std::optional(NoLaw{Why::event}) : std::nullopt;
}

}  // namespace

// What interactions add to an estimate for many particles errs by about its share in one of them;
// beyond this relative error of the whole it is not given.
bool is_few(double relative_to_ideal, double count) {
    constexpr double most_error = 0.015;
    return std::abs(1.0 - 1.0 / relative_to_ideal) / count > most_error;
}

// Walls and collisions give the same pressure only if the motion along both axes has the same
// energy: a single particle keeps that along each axis unless diffuse walls mix them, and of few
// particles whose momentum is conserved along one axis that one has less.
Law ideal_pressure(const BoxedGas& gas, const Asked& asked) {
    constexpr double few_along_axis = 50.0;
    if (const auto reason = why_not_isolated(gas)) return none(*reason);
    if (const auto reason = first_of(gas, {Why::no_finite_mass, Why::fixed_particles}))
        return none(*reason);
    if (!(gas.freedoms() > 0.0)) return none(Why::no_freedom);
    if (gas.keeps_axes()) return none(Why::keeps_axes);
    if (gas.conserves_some() && gas.finite < few_along_axis) return none(Why::one_axis);
    const ThermalMotion thermal = asked.thermal.value_or(gas.thermal);
    if (!(thermal.energy > 0.0)) return none(Why::at_rest);
    return value(pressure_of_points(gas.box, thermal.energy));
}

Law pressure(const BoxedGas& gas, const Asked& asked) {
    const Law ideal = ideal_pressure(gas, asked);
    const Particles& particles = *gas.particles;
    if (!ideal || (gas.are_points() && asked.phase == PhaseOfSpheres::fluid)) return ideal;
    const ThermalMotion thermal = asked.thermal.value_or(gas.thermal);
    if (asked.phase != PhaseOfSpheres::fluid) {
        const auto found = pressure_of_phase(asked.phase, gas.box, particles, thermal);
        return found ? value(*found) : none(Why::no_such_phase);
    }
    if (gas.box.dimension == 1) {
        const auto rods = pressure_of_rods(gas.box, particles, thermal);
        return rods ? value(*rods) : none(Why::no_room);
    }
    if (!are_equal(particles.radius) && gas.box.dimension != 3) return none(Why::unequal_radii);
    if (gas.has_points()) return none(Why::points);
    const auto fluid = pressure_of_fluid(asked.equation, gas.box, particles, thermal);
    if (!fluid) return none(Why::freezes);
    return is_few(*fluid / ideal.value, gas.finite) ? none(Why::few) : value(*fluid);
}

Law contact(const BoxedGas& gas, const Asked&) {
    const Particles& particles = *gas.particles;
    if (gas.box.dimension == 1) return none(Why::line);
    if (const auto reason = why_not_still(gas)) return none(*reason);
    // With different baths the gas is denser where it is colder.
    if (const auto reason = first_of(gas, {Why::baths_differ, Why::partitions, Why::obstacles,
                                           Why::no_finite_mass, Why::fixed_particles}))
        return none(*reason);
    if (gas.finite == 1.0) return none(Why::unhindered);
    if (!are_equal(particles.inverse_mass)) return none(Why::unequal_masses);
    if (!are_equal(particles.radius)) return none(Why::unequal_radii);
    if (particles.radius[0] == 0.0) return none(Why::points);
    if (!moves(gas)) return none(Why::at_rest);
    if (packing_fraction(gas.box, particles) > largest_packing_of_fluid(gas.box.dimension))
        return none(Why::freezes);
    const double radius = particles.radius[0];
    const double chi = contact_correlation(gas.box, particles, radius, radius);
    return is_few(chi, gas.finite) ? none(Why::few) : value(chi);
}

// Evenly in the end: nothing holds particles in a part of the box, and what closes a part opens.
Law position_entropy(const BoxedGas& gas, const Asked& asked) {
    if (const auto reason =
            first_of(gas, {Why::no_finite_mass, Why::moving_infinite_mass, Why::driven, Why::piston,
                           Why::membrane, Why::gravity, Why::baths_differ}))
        return none(*reason);
    if (gas.influences.divided) return none(Why::partitions);
    if (const auto reason = first_of(gas, {Why::obstacles, Why::fixed_particles}))
        return none(*reason);
    if (!moves(gas)) return none(Why::at_rest);
    return value(entropy_of_even_spread(gas.finite,
                                        double(asked.cells) * asked.cells_up * asked.cells_deep));
}

// A single particle keeps its energy along each axis, as do points, which never meet; and beads on
// a line keep the order of their masses.
Law heights(const BoxedGas& gas, const Asked& asked) {
    const Influences& all = gas.influences;
    const auto axis = static_cast<std::size_t>(asked.axis);
    if (gas.box.dimension == 1) return none(Why::line);
    if (const auto reason =
            first_of(gas, {Why::moving_infinite_mass, Why::driven, Why::bath, Why::piston,
                           Why::membrane, Why::event, Why::partitions, Why::obstacles}))
        return none(*reason);
    if (!all.gravity.at(axis)) return none(Why::no_gravity);
    for (std::size_t other = 0; other < all.gravity.size(); ++other)
        if (other != axis && all.gravity.at(other)) return none(Why::gravity);
    if (gas.box.is_periodic(asked.axis)) return none(Why::no_floor);
    if (const auto reason = first_of(gas, {Why::no_finite_mass, Why::fixed_particles}))
        return none(*reason);
    if (gas.finite == 1.0) return none(gas.keeps_axes() ? Why::keeps_axes : Why::few);
    if (gas.has_points()) return none(Why::points);
    if (gas.is_placed && !(gas.thermal.energy + gas.falling_energy > 0.0))
        return none(Why::at_rest);
    if (falling_kinds(gas, asked.axis) > most_falling_kinds) return none(Why::many_kinds);
    if (asked.cells == 0 || !gas.is_placed) return {};
    return {.curve = barometric_densities(gas, asked.axis, asked.cells, members(gas, asked))};
}

namespace {

// Whether the two sides of a partition are equal by symmetry: it is in the middle, lets all
// particles through and does nothing else.
std::optional<NoLaw> why_not_alike(const BoxedGas& gas, const Asked& asked) {
    if (gas.finite == 0.0) return NoLaw{Why::no_finite_mass};
    if (const auto reason = why_not_still(gas)) return reason;
    if (const auto reason =
            first_of(gas, {Why::bath, Why::event, Why::obstacles, Why::fixed_particles}))
        return reason;
    const Surfaces& surfaces = gas.box.surfaces;
    const double diameter = 2.0 * gas.particles->radius.maxCoeff();
    for (const Partition& line : surfaces.partitions) {
        const bool has_gap = std::ranges::any_of(line.gaps, [&](const Gap& gap) {
            return gap.extent(gas.box.dimension, 0.5 * diameter) > 0.0;
        });
        const bool reflects = is_elastic(line.behaviour);
        if (!line.is_open && !(reflects && has_gap)) return NoLaw{Why::partitions};
    }
    const Partition* line = surfaces.partition(asked.surface);
    if (line == nullptr) return NoLaw{Why::regions};
    if (line->at != 0.5 * gas.box.size[line->axis]) return NoLaw{Why::off_center};
    if (!(gas.energy > 0.0)) return NoLaw{Why::at_rest};
    return std::nullopt;
}

}  // namespace

// Half of all, with the standard deviation of their number. The number is binomial for points, with
// variance N / 4; for equal particles the variance is smaller by the relative compressibility of
// the fluid.
Law side_count(const BoxedGas& gas, const Asked& asked) {
    if (const auto reason = why_not_alike(gas, asked)) return none(*reason);
    const Particles& particles = *gas.particles;
    Law law = value(0.5 * gas.finite);
    const double packing = packing_fraction(gas.box, particles);
    const int dimension = gas.box.dimension;
    if (dimension > 1 && are_equal(particles.radius) &&
        packing <= largest_packing_of_fluid(dimension))
        law.deviation =
            std::sqrt(0.25 * gas.finite *
                      relative_compressibility(dimension, EquationOfState::accurate, packing));
    return law;
}

// Each degree of freedom has the same mean energy; the energy of half of them has a beta
// distribution.
Law side_energy(const BoxedGas& gas, const Asked& asked) {
    if (const auto reason = why_not_alike(gas, asked)) return none(*reason);
    Law law = value(gas.energy / gas.finite);
    if (!gas.drifts) law.deviation = law.value * std::sqrt(2.0 / (gas.freedoms() + 2.0));
    return law;
}

Law side_temperature(const BoxedGas& gas, const Asked& asked) {
    if (const auto reason = why_not_alike(gas, asked)) return none(*reason);
    if (!(gas.freedoms() > 0.0)) return none(Why::no_freedom);
    Law law = value(gas.thermal.temperature());
    law.deviation = law.value * std::sqrt(2.0 / (gas.freedoms() + 2.0));
    return law;
}

}  // namespace carom::laws
