// The mean of a quantity over independent runs, and its standard error.
#pragma once

#include <vector>

namespace carom {

struct MeanError {
    double mean = 0.0;   ///< NaN if there are no values
    double error = 0.0;  ///< standard error of the mean; NaN for fewer than two values
    void archive(auto& archive) { archive(mean, error); }
};

/// The mean of all finite values, and its standard error: the square root of (1 / n) times their
/// variance (with divisor n - 1).
MeanError mean_error(const std::vector<double>& values);

}  // namespace carom
