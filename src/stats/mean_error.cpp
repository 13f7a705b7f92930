#include "stats/mean_error.h"

#include <cmath>
#include <limits>

namespace carom {

MeanError mean_error(const std::vector<double>& values) {
    double count = 0.0, sum = 0.0, squares = 0.0;
    for (const double value : values) {
        if (!std::isfinite(value)) continue;
        count += 1.0;
        sum += value;
    }
    const double nan = std::numeric_limits<double>::quiet_NaN();
    if (count == 0.0) return {nan, nan};
    const double mean = sum / count;
    for (const double value : values)
        if (std::isfinite(value)) squares += (value - mean) * (value - mean);
    return {mean, count > 1.0 ? std::sqrt(squares / (count - 1.0) / count) : nan};
}

}  // namespace carom
