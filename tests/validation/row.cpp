#include "validation/row.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace carom::validation {

namespace {

double deviate_of(double t, double freedom) {
    const double size = (8.0 * freedom + 1.0) / (8.0 * freedom + 3.0) *
                        std::sqrt(freedom * std::log1p(t * t / freedom));
    return std::copysign(size, t);
}

}  // namespace

Row row_of(const Truth& truth, const std::vector<double>& values) {
    Row row{&truth, mean_error(values), static_cast<int>(values.size()), 0.0};
    const double off = row.measured.mean - truth.value;
    if (truth.rounding > 0.0) {
        bool holds = true;
        for (const double value : values)
            holds =
                holds && std::abs(value - truth.value) <= truth.rounding * std::abs(truth.value);
        row.z = holds ? 0.0 : std::numeric_limits<double>::infinity();
        row.measured.error = 0.0;
    } else {
        row.z = deviate_of(off / std::hypot(row.measured.error, truth.error), row.runs - 1.0);
    }
    return row;
}

double bound_of(std::size_t rows) {
    const double chance = 0.01 / static_cast<double>(rows);
    double low = 0.0, high = 40.0;
    while (high - low > 1e-9) {
        const double middle = 0.5 * (low + high);
        (std::erfc(middle / std::numbers::sqrt2) > chance ? low : high) = middle;
    }
    return high;
}

}  // namespace carom::validation
