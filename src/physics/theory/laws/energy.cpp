// The laws of energies and velocities. In equilibrium momenta are uniformly distributed on the
// sphere of the energy, whatever the masses, sizes and density (theory.h).
#include <algorithm>
#include <cmath>
#include <numbers>

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
        case Why::few:  // two disks, momentum conserved along one axis
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
        return half * (d - gas.conserved() * mass / gas.mass) +
               0.5 * mass * gas.drift.square().sum();
    }));
}

Law mean_speed(const BoxedGas& gas, const Asked& asked) {
    const std::vector<Eigen::Index> list = members(gas, asked);
    if (list.empty()) return none(Why::no_finite_mass);
    if (const auto bath = bath_temperature(gas)) {
        const double factor =
            gas.box.dimension == 2 ? 0.5 * std::numbers::pi : 2.0 / std::numbers::pi;
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

// With fixed numbers of particles of several masses, counts do not follow one distribution, and
// particles of infinite mass do not share the energy.
Law goodness_of_fit(const BoxedGas& gas, const Asked& asked) {
    Law law = distribution(gas, asked);
    if (!law) return law;
    const auto asked_for =
        asked.of ? static_cast<double>(asked.of->size()) : gas.finite + gas.fixed;
    if (law.equilibrium->groups.size() > 1) return none(Why::unequal_masses);
    if (law.equilibrium->groups.front().count < asked_for) return none(Why::fixed_particles);
    if (gas.conserves_one()) return none(Why::one_axis);
    return law;
}

Law velocity_entropy(const BoxedGas& gas, const Asked&) {
    if (gas.no_equilibrium) return none(*gas.no_equilibrium);
    const SampledMean mean = equilibrium_entropy(gas);
    return {.value = mean.mean, .error = mean.error};
}

}  // namespace carom::laws
