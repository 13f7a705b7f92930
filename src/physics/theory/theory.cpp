#include "physics/theory/theory.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numeric>

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

// ln of Euler's B(alpha, beta).
double log_beta(double alpha, double beta) {
    return std::lgamma(alpha) + std::lgamma(beta) - std::lgamma(alpha + beta);
}

// Density at y of the root of a share x = y^2 of Beta(alpha, beta): finite where that of the share
// itself is not.
double root_density(const EquilibriumGas& gas, double y) {
    if (y < 0.0 || y > 1.0) return 0.0;
    const double tail =
        gas.beta == 1.0 ? 1.0 : std::exp((gas.beta - 1.0) * std::log1p(-y * y));  // 0 at y = 1
    return 2.0 * std::pow(y, 2.0 * gas.alpha - 1.0) * tail /
           std::exp(log_beta(gas.alpha, gas.beta));
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

bool is_wanted(const std::vector<int>& species, int which) {
    return species.empty() || std::find(species.begin(), species.end(), which) != species.end();
}

// Whether all beads of finite mass are in one stretch between those that never move.
bool beads_are_together(const Box& box, const Particles& particles, const Sample& sample) {
    std::vector<Eigen::Index> order(static_cast<std::size_t>(particles.count()));
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) {
        return sample.position(a, 0) < sample.position(b, 0);
    });
    const auto moves = [&](std::size_t k) { return particles.inverse_mass[order[k]] > 0.0; };
    int stretches = moves(0) && !(is_periodic(box, 0) && moves(order.size() - 1)) ? 1 : 0;
    for (std::size_t k = 1; k < order.size(); ++k) stretches += moves(k) && !moves(k - 1);
    return stretches <= 1;
}

// What a wire forbids beyond what a plane does; `momentum`: whether it is conserved.
bool wire_mixes(const Box& box, const Particles& particles, const Sample& sample, bool momentum) {
    const auto finite = particles.inverse_mass > 0.0;
    const double lightest = particles.inverse_mass.maxCoeff();
    const bool equal = (finite.select(particles.inverse_mass, lightest) == lightest).all();
    return !equal && finite.count() >= (momentum ? 4 : 3) &&
           beads_are_together(box, particles, sample);
}

// Whether momentum is conserved along every axis; nothing if along some only.
std::optional<bool> momentum_conserved(const Box& box, const Particles& particles) {
    const bool free = (particles.inverse_mass > 0.0).all();
    const bool along_x = is_periodic(box, 0) && free;
    const bool along_y = is_periodic(box, 1) && free;
    if (box.dimension == 2 && along_x != along_y) return std::nullopt;
    return along_x;
}

bool drifts(const Eigen::ArrayXd& masses, const Sample& sample, double energy) {
    const Eigen::RowVectorXd momentum = masses.matrix().transpose() * sample.velocity.matrix();
    return 0.5 * momentum.squaredNorm() / masses.sum() > negligible_share * energy;
}

}  // namespace

std::optional<EquilibriumGas> equilibrium(const Box& box, const Particles& particles,
                                          const Sample& sample, const std::vector<int>& species) {
    if (particles.count() == 0) return std::nullopt;
    const auto finite = particles.inverse_mass > 0.0;
    const Eigen::ArrayXd square_speed = sample.velocity.square().rowwise().sum();
    if ((!finite && square_speed > 0.0).any()) return std::nullopt;
    const std::optional<bool> momentum = momentum_conserved(box, particles);
    if (!momentum) return std::nullopt;
    if (box.dimension == 2 && !(particles.radius > 0.0).all()) return std::nullopt;
    if (box.dimension == 1 && !wire_mixes(box, particles, sample, *momentum)) return std::nullopt;

    const Eigen::ArrayXd masses = finite.select(particles.inverse_mass.inverse(), 0.0);
    EquilibriumGas gas;
    gas.energy = 0.5 * (masses * square_speed).sum();
    gas.alpha = 0.5 * box.dimension;
    const double others = static_cast<double>(finite.count()) - (*momentum ? 2.0 : 1.0);
    gas.beta = gas.alpha * others;
    if (!(gas.energy > 0.0) || others < 1.0) return std::nullopt;
    if (*momentum && drifts(masses, sample, gas.energy)) return std::nullopt;

    std::vector<double> wanted;
    for (Eigen::Index i = 0; i < particles.count(); ++i)
        if (masses[i] > 0.0 && is_wanted(species, particles.species[i]))
            wanted.push_back(masses[i]);
    if (wanted.empty()) return std::nullopt;
    gas.groups = group_by_mass(std::move(wanted));
    if (*momentum)
        for (MassGroup& group : gas.groups) group.largest_share = 1.0 - group.mass / masses.sum();
    return gas;
}

std::optional<EquilibriumGas> among(const EquilibriumGas& gas, const Particles& particles,
                                    const std::vector<Eigen::Index>& chosen) {
    std::vector<double> wanted;
    for (const Eigen::Index i : chosen)
        if (particles.inverse_mass[i] > 0.0) wanted.push_back(1.0 / particles.inverse_mass[i]);
    if (wanted.empty()) return std::nullopt;
    EquilibriumGas some = gas;
    some.groups = group_by_mass(std::move(wanted));
    for (MassGroup& group : some.groups) {
        const auto heavier =
            std::upper_bound(gas.groups.begin(), gas.groups.end(), group.mass,
                             [](double mass, const MassGroup& other) { return mass < other.mass; });
        group.largest_share = std::prev(heavier)->largest_share;
    }
    return some;
}

double energy_density(const EquilibriumGas& gas, double e) {
    if (e < 0.0) return 0.0;
    return average(gas, [&](const MassGroup& group) {
        const double most = group.largest_share * gas.energy;
        if (!(most > 0.0) || e > most) return 0.0;
        if (e == 0.0)
            return gas.alpha < 1.0 ? std::numeric_limits<double>::infinity() : gas.beta / most;
        const double y = std::sqrt(e / most);
        return root_density(gas, y) / (2.0 * y * most);
    });
}

// Simpson's rule over the angle whose sine is the root of the share: there the integrand is smooth
// at both ends.
double energy_probability(const EquilibriumGas& gas, double low, double high) {
    constexpr int steps = 16;
    return average(gas, [&](const MassGroup& group) {
        const double most = group.largest_share * gas.energy;
        const auto angle = [&](double e) {
            return std::asin(std::sqrt(std::clamp(e / most, 0.0, 1.0)));
        };
        if (!(most > 0.0)) return 0.0;
        const double from = angle(low), to = angle(high);
        double sum = 0.0;
        for (int i = 0; i <= steps; ++i) {
            const double weight = i == 0 || i == steps ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
            const double at = from + (to - from) * i / steps;
            sum += weight * root_density(gas, std::sin(at)) * std::cos(at);
        }
        return sum * (to - from) / (3.0 * steps);
    });
}

double speed_density(const EquilibriumGas& gas, double v) {
    if (v < 0.0) return 0.0;
    return average(gas, [&](const MassGroup& group) {
        const double fastest = std::sqrt(2.0 * group.largest_share * gas.energy / group.mass);
        return fastest > 0.0 ? root_density(gas, v / fastest) / fastest : 0.0;
    });
}

double velocity_density(const EquilibriumGas& gas, double v) {
    const double power = gas.alpha + gas.beta - 0.5;  // (D - 1)/2
    return average(gas, [&](const MassGroup& group) {
        const double fastest = std::sqrt(2.0 * group.largest_share * gas.energy / group.mass);
        const double u = v / fastest;
        if (!(std::abs(u) <= 1.0)) return 0.0;
        const double tail = power == 1.0 ? 1.0 : std::exp((power - 1.0) * std::log1p(-u * u));
        return tail / (std::exp(log_beta(0.5, power)) * fastest);
    });
}

double velocity_deviation(const EquilibriumGas& gas) {
    const double dimensions = 2.0 * (gas.alpha + gas.beta);
    return std::sqrt(average(gas, [&](const MassGroup& group) {
        return 2.0 * group.largest_share * gas.energy / (group.mass * dimensions);
    }));
}

double mean_energy(const EquilibriumGas& gas) {
    return average(gas, [&](const MassGroup& group) {
        return group.largest_share * gas.energy * gas.alpha / (gas.alpha + gas.beta);
    });
}

// The mean of sqrt(x) for x ~ Beta(alpha, beta) is B(alpha + 1/2, beta) / B(alpha, beta).
double mean_speed(const EquilibriumGas& gas) {
    const double mean_root =
        std::exp(log_beta(gas.alpha + 0.5, gas.beta) - log_beta(gas.alpha, gas.beta));
    return average(gas, [&](const MassGroup& group) {
        return std::sqrt(2.0 * group.largest_share * gas.energy / group.mass) * mean_root;
    });
}

}  // namespace carom
