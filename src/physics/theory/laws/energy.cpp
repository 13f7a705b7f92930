// The laws of energies and velocities. In equilibrium momenta are uniformly distributed on the
// sphere of the energy, whatever the masses, sizes and density (theory.h).
#include <algorithm>
#include <cmath>

#include "physics/theory/laws/laws.h"
#include "physics/theory/velocity_entropy.h"

namespace carom::laws {
namespace {

double mass_of(const BoxedGas& gas, Eigen::Index i) { return 1.0 / gas.particles->inverse_mass[i]; }

// The mean over the members of a function of the mass.
template <typename Function>
double mean_over(const BoxedGas& gas, const std::vector<Eigen::Index>& list, Function&& f) {
    double sum = 0.0;
    for (const Eigen::Index i : list) sum += f(mass_of(gas, i));
    return sum / static_cast<double>(list.size());
}

// Means of energies are known in more cases than distributions: those of a particle that keeps its
// energy, of two whose energies are fixed by their momentum, and of a gas that moves as a whole.
std::optional<NoLaw> why_no_mean(const BoxedGas& gas) {
    if (const auto reason = why_not_isolated(gas)) return reason;
    if (!(gas.energy > 0.0)) return NoLaw{Why::at_rest};
    if (!gas.no_equilibrium) return std::nullopt;
    switch (gas.no_equilibrium->why) {
        case Why::alone:
        case Why::pair:
            return std::nullopt;
        case Why::few:  // two particles, momentum conserved along some axes
            return gas.has_points() ? std::optional(NoLaw{Why::points}) : std::nullopt;
        case Why::drifts:
            if (gas.box.dimension == 1) return gas.no_equilibrium;
            return gas.has_points() ? std::optional(NoLaw{Why::points}) : std::nullopt;
        default:
            return gas.no_equilibrium;
    }
}

}  // namespace

std::optional<double> bath_temperature(const BoxedGas& gas) {
    const bool is_parted = gas.box.dimension == 1 && gas.fixed > 0.0;
    const auto other =
        first_of(gas, {Why::driven, Why::baths_differ, Why::piston, Why::membrane, Why::partitions,
                       Why::obstacles, Why::gravity, Why::event, Why::moving_infinite_mass});
    if (other || is_parted || !gas.influences.bath) return std::nullopt;
    return gas.influences.bath_temperatures.front();
}

Law mean_energy(const BoxedGas& gas, const Asked& asked) {
    const std::vector<Eigen::Index> list = members(gas, asked);
    if (list.empty()) return none(Why::no_finite_mass);
    const double d = gas.box.dimension;
    if (const auto bath = bath_temperature(gas)) return value(0.5 * d * *bath);
    if (const auto reason = why_no_mean(gas)) return none(*reason);
    const double half = gas.freedoms() > 0.0 ? 0.5 * gas.thermal.temperature() : 0.0;
    return value(mean_over(gas, list, [&](double mass) {
        return half * (d - gas.conserved() * mass / gas.mass) + 0.5 * mass * square(gas.drift);
    }));
}

Law mean_speed(const BoxedGas& gas, const Asked& asked) {
    const std::vector<Eigen::Index> list = members(gas, asked);
    if (list.empty()) return none(Why::no_finite_mass);
    if (const auto bath = bath_temperature(gas)) {
        const double factor = squared_mean_length(gas.box.dimension);
        return value(
            mean_over(gas, list, [&](double mass) { return std::sqrt(factor * *bath / mass); }));
    }
    const Law all = distribution(gas, asked);
    return all ? value(carom::mean_speed(*all.equilibrium)) : all;
}

Law bath(const BoxedGas& gas, const Asked&) {
    if (!gas.influences.bath) return none(Why::no_bath);
    if (gas.influences.baths_differ()) return none(Why::baths_differ);
    return value(gas.influences.bath_temperatures.front());
}

Law temperature(const BoxedGas& gas, const Asked&) {
    if (gas.finite == 0.0) return none(Why::no_finite_mass);
    if (const auto bath = bath_temperature(gas)) return value(*bath);
    if (const auto reason = why_not_isolated(gas)) return none(*reason);
    if (!(gas.energy > 0.0)) return none(Why::at_rest);
    if (!(gas.freedoms() > 0.0)) return none(Why::no_freedom);
    return value(gas.thermal.temperature());
}

Law distribution(const BoxedGas& gas, const Asked& asked) {
    if (gas.no_equilibrium) return none(*gas.no_equilibrium);
    if (!asked.of) return {.equilibrium = gas.equilibrium};
    Law law{.equilibrium = among(*gas.equilibrium, *gas.particles, *asked.of)};
    return law.equilibrium ? law : none(Why::no_finite_mass);
}

// A partition that lets nothing through and is the only one makes two gases, each with its own
// energy. Their walls conserve no momentum.
Law side_distribution(const BoxedGas& gas, const Asked& asked) {
    if (gas.box.dimension == 1) return none(Why::line);
    const Partition* partition = gas.box.surfaces.partition(asked.surface);
    if (partition == nullptr) return none(Why::passes);
    if (const auto reason = first_of(
            gas, {Why::moving_infinite_mass, Why::driven, Why::baths_differ, Why::bath, Why::piston,
                  Why::membrane, Why::event, Why::gravity, Why::obstacles, Why::fixed_particles}))
        return none(*reason);
    if (partition->is_open || !partition->gaps.empty()) return none(Why::passes);
    if (gas.box.surfaces.partitions.size() > 1) return none(Why::partitions);
    if (gas.box.is_periodic(partition->axis)) return none(Why::no_walls);
    if (gas.conserved() > 0.0) return none(Why::one_axis);
    const std::vector<Eigen::Index> list = members(gas, asked);
    if (list.empty()) return none(Why::no_finite_mass);
    if (list.size() == 1) return none(Why::alone);
    if (std::ranges::any_of(list, [&](auto i) { return gas.particles->radius[i] == 0.0; }))
        return none(Why::points);
    const double energy = asked.thermal ? asked.thermal->energy : gas.energy;
    if (!(energy > 0.0)) return none(Why::at_rest);
    const double count = static_cast<double>(list.size()), half = 0.5 * gas.box.dimension;
    const EquilibriumGas side{// the group holds what each of those of its members begins with
                              .energy = energy,
                              .alpha = half,
                              .beta = half * (count - 1.0),
                              .groups = {{0.0, 0.0}}};
    return {.equilibrium = among(side, *gas.particles, list)};
}

// With fixed numbers of particles of several masses, counts do not follow one distribution, and
// particles of infinite mass do not share the energy.
Law goodness_of_fit(const BoxedGas& gas, const Asked& asked) {
    Law law = distribution(gas, asked);
    if (!law) return law;
    const auto asked_for =
        asked.of ? static_cast<double>(asked.of->size()) : gas.finite + gas.fixed;
    if (law.equilibrium->groups.size() > 1) return none(Why::unequal_masses);
    if (law.equilibrium->groups.front().count < asked_for) return none(Why::fixed_particles);
    if (gas.conserves_some()) return none(Why::one_axis);
    return law;
}

Law velocity_entropy(const BoxedGas& gas, const Asked&) {
    if (gas.no_equilibrium) return none(*gas.no_equilibrium);
    const SampledMean mean = equilibrium_entropy(gas);
    return {.value = mean.mean, .error = mean.error};
}

}  // namespace carom::laws
