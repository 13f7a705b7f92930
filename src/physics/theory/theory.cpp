#include "physics/theory/theory.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace carom {
namespace {

// ln of Euler's B(alpha, beta).
double log_beta(double alpha, double beta) {
    return std::lgamma(alpha) + std::lgamma(beta) - std::lgamma(alpha + beta);
}

// Density of the square root y of a share x = y^2 with the distribution Beta(alpha, beta): it stays
// finite where the density of x itself does not.
double root_density(const EquilibriumGas& gas, double y) {
    if (y < 0.0 || y > 1.0) return 0.0;
    const double tail =
        gas.beta == 1.0 ? 1.0 : std::exp((gas.beta - 1.0) * std::log1p(-y * y));  // 0 at y = 1
    return 2.0 * std::pow(y, 2.0 * gas.alpha - 1.0) * tail /
           std::exp(log_beta(gas.alpha, gas.beta));
}

bool is_line(const EquilibriumGas& gas) { return gas.alpha < 1.0; }

// The average of f(mass, largest share) over the particles, and over the directions of motion in a
// plane if the share depends on these: by the trapezoidal rule over the angle, which converges fast
// for what is periodic in it.
template <typename Function>
double average(const EquilibriumGas& gas, Function&& f) {
    constexpr int directions = 64;
    double sum = 0.0, count = 0.0;
    for (const MassGroup& group : gas.groups) {
        const auto [along_x, along_y] = group.largest_share;
        double own = 0.0;
        if (is_line(gas) || along_x == along_y) {
            own = f(group.mass, along_x);
        } else {
            for (int k = 0; k < directions; ++k) {
                const double c = std::cos((k + 0.5) * 0.5 * std::numbers::pi / directions);
                own += f(group.mass, along_y + (along_x - along_y) * c * c) / directions;
            }
        }
        sum += group.count * own;
        count += group.count;
    }
    return count > 0.0 ? sum / count : 0.0;
}

// The average of f(mass, largest share) over the particles, and over the axes unless one is given.
template <typename Function>
double average_along(const EquilibriumGas& gas, std::optional<int> axis, Function&& f) {
    if (!axis && !is_line(gas)) return 0.5 * (average_along(gas, 0, f) + average_along(gas, 1, f));
    const auto a = static_cast<std::size_t>(axis.value_or(0));
    double sum = 0.0, count = 0.0;
    for (const MassGroup& group : gas.groups) {
        sum += group.count * f(group.mass, group.largest_share.at(a));
        count += group.count;
    }
    return count > 0.0 ? sum / count : 0.0;
}

}  // namespace

double energy_density(const EquilibriumGas& gas, double e) {
    if (e < 0.0) return 0.0;
    return average(gas, [&](double, double share) {
        const double most = share * gas.energy;
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
    return average(gas, [&](double, double share) {
        const double most = share * gas.energy;
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
    return average(gas, [&](double mass, double share) {
        const double fastest = std::sqrt(2.0 * share * gas.energy / mass);
        return fastest > 0.0 ? root_density(gas, v / fastest) / fastest : 0.0;
    });
}

double velocity_density(const EquilibriumGas& gas, double v, std::optional<int> axis) {
    const double power = gas.alpha + gas.beta - 0.5;  // (D - 1)/2
    return average_along(gas, axis, [&](double mass, double share) {
        const double fastest = std::sqrt(2.0 * share * gas.energy / mass);
        const double u = v / fastest;
        if (!(std::abs(u) <= 1.0)) return 0.0;
        const double tail = power == 1.0 ? 1.0 : std::exp((power - 1.0) * std::log1p(-u * u));
        return tail / (std::exp(log_beta(0.5, power)) * fastest);
    });
}

double mean_speed_along(const EquilibriumGas& gas, int axis) {
    const double mean_root = std::exp(log_beta(1.0, gas.alpha + gas.beta - 0.5) -
                                      log_beta(0.5, gas.alpha + gas.beta - 0.5));
    return average_along(gas, axis, [&](double mass, double share) {
        return std::sqrt(2.0 * share * gas.energy / mass) * mean_root;
    });
}

double mean_speed_factor(double freedoms) {
    const double half = 0.5 * freedoms;
    return std::sqrt(half) * std::exp(std::lgamma(half) - std::lgamma(half + 0.5));
}

// The mean of sqrt(x) for x ~ Beta(alpha, beta) is B(alpha + 1/2, beta) / B(alpha, beta).
double mean_speed(const EquilibriumGas& gas) {
    const double mean_root =
        std::exp(log_beta(gas.alpha + 0.5, gas.beta) - log_beta(gas.alpha, gas.beta));
    return average(gas, [&](double mass, double share) {
        return std::sqrt(2.0 * share * gas.energy / mass) * mean_root;
    });
}

}  // namespace carom
