// The mean of a number over independent runs, and how sure it is.
#pragma once

#include <vector>

namespace carom {

struct MeanError {
    double mean = 0.0;   ///< NaN of no values
    double error = 0.0;  ///< standard error of the mean; NaN of fewer than two values
    void archive(auto& archive) { archive(mean, error); }
};

/// Of those values that are finite: their mean, and the root of their variance (with n - 1) over n.
MeanError mean_error(const std::vector<double>& values);

}  // namespace carom
