#include "physics/theory/theory.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
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

// The nodes and weights of Gauss-Legendre quadrature over [0, 1]: the zeros of a Legendre
// polynomial, by Newton's method.
struct Quadrature {
    static constexpr int count = 48;
    std::array<double, count> nodes{}, weights{};

    Quadrature() {
        for (int k = 0; k < count; ++k) {
            double x = std::cos(std::numbers::pi * (k + 0.75) / (count + 0.5)), slope = 1.0;
            for (int step = 0; step < 8; ++step) {
                double last = 1.0, value = x;
                for (int n = 2; n <= count; ++n)
                    last = std::exchange(value, ((2 * n - 1) * x * value - (n - 1) * last) / n);
                slope = count * (x * value - last) / (x * x - 1.0);
                x -= value / slope;
            }
            nodes.at(static_cast<std::size_t>(k)) = 0.5 * (1.0 + x);
            weights.at(static_cast<std::size_t>(k)) = 1.0 / ((1.0 - x * x) * slope * slope);
        }
    }
};

// The average of f(largest share) over the directions of motion in a plane: by the trapezoidal rule
// over the angle, which converges fast for what is periodic in it.
template <typename Function>
double average_in_plane(double along_x, double along_y, Function&& f) {
    constexpr int directions = 64;
    double own = 0.0;
    for (int k = 0; k < directions; ++k) {
        const double c = std::cos((k + 0.5) * 0.5 * std::numbers::pi / directions);
        own += f(along_y + (along_x - along_y) * c * c) / directions;
    }
    return own;
}

// The same in space, where two axes have one share: all cosines with the third axis have the same
// probability.
template <typename Function>
double average_in_space(double along_one, double along_two, Function&& f) {
    static const Quadrature cosines;
    double own = 0.0;
    for (std::size_t k = 0; k < Quadrature::count; ++k) {
        const double c = cosines.nodes[k];
        own += cosines.weights[k] * f(along_two + (along_one - along_two) * c * c);
    }
    return own;
}

// The average of f(mass, largest share) over the particles, and over the directions of motion if
// the share depends on these.
template <typename Function>
double average(const EquilibriumGas& gas, Function&& f) {
    double sum = 0.0, count = 0.0;
    for (const MassGroup& group : gas.groups) {
        const auto [x, y, z] = group.largest_share;
        const auto own = [&](double share) { return f(group.mass, share); };
        const int dimension = gas.dimension();
        double mean = 0.0;
        if (dimension == 1 || (x == y && (dimension == 2 || y == z)))
            mean = own(x);
        else if (dimension == 2)
            mean = average_in_plane(x, y, own);
        else if (x == y)
            mean = average_in_space(z, x, own);
        else  // momentum is conserved along an axis or not: two of the shares are equal
            mean = y == z ? average_in_space(x, y, own) : average_in_space(y, x, own);
        sum += group.count * mean;
        count += group.count;
    }
    return count > 0.0 ? sum / count : 0.0;
}

// The average of f(mass, largest share) over the particles, and over the axes unless one is given.
template <typename Function>
double average_along(const EquilibriumGas& gas, std::optional<int> axis, Function&& f) {
    double sum = 0.0, count = 0.0;
    if (!axis) {
        for (int each = 0; each < gas.dimension(); ++each) sum += average_along(gas, each, f);
        return sum / gas.dimension();
    }
    const auto a = static_cast<std::size_t>(*axis);
    for (const MassGroup& group : gas.groups) {
        sum += group.count * f(group.mass, group.largest_share.at(a));
        count += group.count;
    }
    return count > 0.0 ? sum / count : 0.0;
}

}  // namespace

EquilibriumGas motion_along(const EquilibriumGas& gas, const std::vector<int>& axes) {
    EquilibriumGas part = gas;
    part.alpha = 0.5 * static_cast<double>(axes.size());
    part.beta = gas.alpha + gas.beta - part.alpha;
    for (MassGroup& group : part.groups) {
        const auto all = group.largest_share;
        group.largest_share = {1.0, 1.0, 1.0};
        for (std::size_t k = 0; k < axes.size(); ++k)
            group.largest_share.at(k) = all.at(static_cast<std::size_t>(axes[k]));
    }
    return part;
}

double energy_density(const EquilibriumGas& gas, double e) {
    if (e < 0.0) return 0.0;
    return average(gas, [&](double, double share) {
        const double most = share * gas.energy;
        if (!(most > 0.0) || e > most) return 0.0;
        if (e == 0.0)
            return gas.alpha < 1.0   ? std::numeric_limits<double>::infinity()
                   : gas.alpha > 1.0 ? 0.0
                                     : gas.beta / most;
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

double squared_mean_length(int dimension) {
    using std::numbers::pi;
    return dimension == 1 ? 2.0 / pi : dimension == 2 ? 0.5 * pi : 8.0 / pi;
}

}  // namespace carom
