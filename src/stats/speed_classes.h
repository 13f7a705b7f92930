// Slow, medium and fast: below 0.5, up to 1.5, and above 1.5 of a mean speed.
#pragma once

#include <Eigen/Core>
#include <array>

namespace carom {

/// 0 slow, 1 medium, 2 fast, beside a mean speed (the bounds themselves are medium).
inline int speed_class(double speed, double mean) {
    return speed < 0.5 * mean ? 0 : speed > 1.5 * mean ? 2 : 1;
}

/// The shares of slow, medium and fast among `speeds`, at least one; they add up to 1.
inline std::array<double, 3> class_shares(const Eigen::ArrayXd& speeds, double mean) {
    std::array<double, 3> counts{};
    for (const double speed : speeds)
        counts[static_cast<std::size_t>(speed_class(speed, mean))] += 1.0;
    for (double& count : counts) count /= static_cast<double>(speeds.size());
    return counts;
}

}  // namespace carom
