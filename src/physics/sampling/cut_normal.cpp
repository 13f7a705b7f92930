#include "physics/sampling/cut_normal.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace carom {
namespace {

// Of the standard normal distribution.
double density(double z) { return std::exp(-0.5 * z * z) / std::sqrt(2.0 * std::numbers::pi); }
double share_below(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }

}  // namespace

CutNormal truncated_at_zero(const NormalDistribution& normal) {
    const auto [mean, deviation] = normal;
    if (!(deviation > 0.0)) return {0.0, mean, 0.0};
    const double zero = -mean / deviation, cut = share_below(zero);
    const double hazard = density(zero) / (1.0 - cut);
    return {cut, mean + deviation * hazard,
            deviation * std::sqrt(1.0 + zero * hazard - hazard * hazard)};
}

CutNormal folded_at_zero(const NormalDistribution& normal) {
    const auto [mean, deviation] = normal;
    if (!(deviation > 0.0)) return {0.0, mean, 0.0};
    const double zero = -mean / deviation, cut = share_below(zero);
    const double folded = 2.0 * deviation * density(zero) + mean * (1.0 - 2.0 * cut);
    const double square = mean * mean + deviation * deviation;
    return {cut, folded, std::sqrt(std::max(0.0, square - folded * folded))};
}

}  // namespace carom
