// Means of blocks of one run, and whether they are what is expected.
#pragma once

#include <doctest/doctest.h>

#include <Eigen/Core>
#include <cmath>
#include <vector>

namespace carom::test {

/// Mean of blocks and its standard error.
struct Estimate {
    double mean, error;
};

inline Estimate estimate(const Eigen::ArrayXd& blocks) {
    const double n = static_cast<double>(blocks.size()), mean = blocks.mean();
    return {mean, std::sqrt((blocks - mean).square().sum() / (n * (n - 1.0)))};
}

inline Estimate estimate(const std::vector<double>& blocks) {
    const auto count = static_cast<Eigen::Index>(blocks.size());
    return estimate(Eigen::ArrayXd(Eigen::ArrayXd::Map(blocks.data(), count)));
}

/// Within five standard errors, which chance fails once in two million; and these are at most a
/// share of what is expected, so that the test can tell.
inline void check_mean(const std::vector<double>& blocks, double expected, double most_error) {
    const Estimate found = estimate(blocks);
    const double mean = found.mean, error = found.error;
    CAPTURE(mean);
    CAPTURE(error);
    CAPTURE(expected);
    CHECK(std::abs(mean - expected) < 5.0 * error);
    CHECK(error < most_error * std::abs(expected));
}

}  // namespace carom::test
