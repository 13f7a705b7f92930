// Block averages over one simulation run, and a check of their mean against an expected value.
#pragma once

#include <doctest/doctest.h>

#include <Eigen/Core>
#include <cmath>
#include <vector>

namespace carom::test {

/// The mean of the block averages and its standard error.
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

/// Checks that the mean of the blocks lies within five standard errors of `expected`, which fails
/// by chance once in two million. Also checks that the standard error is below the share
/// `most_error` of `expected`, since a larger error would let any result pass.
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
