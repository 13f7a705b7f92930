// Speed classes: slow is below 0.5, medium from 0.5 to 1.5, and fast above 1.5 times a mean speed.
#pragma once

#include <Eigen/Core>
#include <array>

namespace carom {

/// The class of a speed relative to a mean speed: 0 slow, 1 medium, 2 fast (the bounds themselves
/// are medium, within rounding).
inline int speed_class(double speed, double mean) {
    constexpr double rounding = 1e-9;
    return speed < (0.5 - rounding) * mean ? 0 : speed > (1.5 + rounding) * mean ? 2 : 1;
}

/// The shares of slow, medium and fast among `speeds`, which must not be empty; they add up to 1.
inline std::array<double, 3> class_shares(const Eigen::ArrayXd& speeds, double mean) {
    std::array<double, 3> counts{};
    for (const double speed : speeds)
        counts[static_cast<std::size_t>(speed_class(speed, mean))] += 1.0;
    for (double& count : counts) count /= static_cast<double>(speeds.size());
    return counts;
}

}  // namespace carom
