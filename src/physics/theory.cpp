#include "physics/theory.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace carom {
namespace {

// A curve is drawn from a few hundred points; more masses than this are merged with their
// neighbours, to within a part in a thousand of their logarithm's range.
constexpr std::size_t most_groups = 1024;

// Momentum left by round-off carries this part of the energy at most.
constexpr double negligible_share = 1e-12;

bool is_periodic(const Box& box, int axis) {
    return box.walls[static_cast<std::size_t>(axis)] == Wall::periodic;
}

std::vector<MassGroup> group_by_mass(std::vector<double> masses) {
    std::sort(masses.begin(), masses.end());
    std::vector<MassGroup> groups;
    for (const double mass : masses) {
        if (!groups.empty() && groups.back().mass == mass)
            groups.back().count += 1.0;
        else
            groups.push_back({mass, 1.0, 1.0});
    }
    if (groups.size() <= most_groups) return groups;
    std::vector<MassGroup> merged;
    const double ratio = std::pow(masses.back() / masses.front(), 1.0 / double(most_groups));
    for (const MassGroup& group : groups) {
        if (!merged.empty() && group.mass < merged.back().mass * ratio)
            merged.back().count += group.count;
        else
            merged.push_back(group);
    }
    return merged;
}

// (1 - x)^(beta - 1) beta: the density of Beta(1, beta).
double beta_density(double beta, double x) {
    if (x < 0.0 || x > 1.0) return 0.0;
    if (x == 1.0) return beta == 1.0 ? 1.0 : 0.0;
    return beta * std::exp((beta - 1.0) * std::log1p(-x));
}

template <typename Function>
double average(const EquilibriumGas& gas, Function&& f) {
    double sum = 0.0, count = 0.0;
    for (const MassGroup& group : gas.groups) {
        sum += group.count * f(group);
        count += group.count;
    }
    return count > 0.0 ? sum / count : 0.0;
}

double energy_density_of(const EquilibriumGas& gas, const MassGroup& group, double e) {
    const double most = group.largest_share * gas.energy;
    return most > 0.0 ? beta_density(gas.beta, e / most) / most : 0.0;
}

}  // namespace

std::optional<EquilibriumGas> equilibrium(const Box& box, const Particles& particles,
                                          const Sample& sample, const std::vector<int>& species) {
    if (box.dimension != 2 || particles.count() == 0) return std::nullopt;
    const auto finite = particles.inverse_mass > 0.0;
    const Eigen::ArrayXd square_speed = sample.velocity.square().rowwise().sum();
    if ((!finite && square_speed > 0.0).any()) return std::nullopt;
    if (!(particles.radius > 0.0).all()) return std::nullopt;
    const bool momentum_x = is_periodic(box, 0) && finite.all();
    const bool momentum_y = is_periodic(box, 1) && finite.all();
    if (momentum_x != momentum_y) return std::nullopt;

    const Eigen::ArrayXd masses = finite.select(particles.inverse_mass.inverse(), 0.0);
    EquilibriumGas gas;
    gas.energy = 0.5 * (masses * square_speed).sum();
    gas.beta = static_cast<double>(finite.count()) - (momentum_x ? 2.0 : 1.0);
    if (!(gas.energy > 0.0) || gas.beta < 1.0) return std::nullopt;
    if (momentum_x) {
        const Eigen::Array2d momentum((masses * sample.velocity.col(0)).sum(),
                                      (masses * sample.velocity.col(1)).sum());
        const double of_centre = 0.5 * momentum.square().sum() / masses.sum();
        if (of_centre > negligible_share * gas.energy) return std::nullopt;
    }

    std::vector<double> wanted;
    for (Eigen::Index i = 0; i < particles.count(); ++i)
        if (masses[i] > 0.0 &&
            (species.empty() ||
             std::find(species.begin(), species.end(), particles.species[i]) != species.end()))
            wanted.push_back(masses[i]);
    if (wanted.empty()) return std::nullopt;
    gas.groups = group_by_mass(std::move(wanted));
    if (momentum_x)
        for (MassGroup& group : gas.groups) group.largest_share = 1.0 - group.mass / masses.sum();
    return gas;
}

double energy_density(const EquilibriumGas& gas, double e) {
    return average(gas, [&](const MassGroup& group) { return energy_density_of(gas, group, e); });
}

double speed_density(const EquilibriumGas& gas, double v) {
    if (v < 0.0) return 0.0;
    return average(gas, [&](const MassGroup& group) {
        return group.mass * v * energy_density_of(gas, group, 0.5 * group.mass * v * v);
    });
}

double mean_energy(const EquilibriumGas& gas) {
    return average(gas, [&](const MassGroup& group) {
        return group.largest_share * gas.energy / (1.0 + gas.beta);
    });
}

// The mean of sqrt(x) for x ~ Beta(1, beta) is Gamma(3/2) Gamma(1 + beta) / Gamma(3/2 + beta).
double mean_speed(const EquilibriumGas& gas) {
    const double mean_root = 0.5 * std::sqrt(std::numbers::pi) *
                             std::exp(std::lgamma(1.0 + gas.beta) - std::lgamma(1.5 + gas.beta));
    return average(gas, [&](const MassGroup& group) {
        return std::sqrt(2.0 * group.largest_share * gas.energy / group.mass) * mean_root;
    });
}

}  // namespace carom
