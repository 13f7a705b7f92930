#include "stats/histogram.h"

#include <algorithm>
#include <cmath>

#include "util/bin_number.h"

namespace carom {

Histogram histogram(const Eigen::ArrayXd& values, const Bins& bins) {
    Histogram result{bins, std::vector<std::int64_t>(static_cast<std::size_t>(bins.count)), 0, 0};
    const double scale = bins.count / (bins.high - bins.low);
    // If the bins are so narrow that the scale overflows to infinity, the quotient is still finite.
    const auto place = [&](double value) {
        return std::isfinite(scale) ? (value - bins.low) * scale
                                    : (value - bins.low) / (bins.high - bins.low) * bins.count;
    };
    for (const double value : values) {
        const int index = bin_among(place(value), bins.count);
        if (index < 0)
            ++result.below;
        else if (index < bins.count)
            ++result.counts[static_cast<std::size_t>(index)];
        else
            ++result.above;
    }
    return result;
}

double freedman_diaconis_width(double spread, double n) { return 2.0 * spread / std::cbrt(n); }

int freedman_diaconis(const std::vector<double>& values, double n, double low, double high,
                      int fewest, int most) {
    std::vector<double> copy = values;
    const double spread = quantile(copy, 0.75) - quantile(copy, 0.25);
    const double width = freedman_diaconis_width(spread, n);
    if (!(width > 0.0)) return fewest;
    const double bins = std::ceil((high - low) / width);
    return static_cast<int>(std::clamp(bins, double(fewest), double(most)));
}

double quantile(std::vector<double>& values, double share) {
    const double place = share * static_cast<double>(values.size() - 1);
    const auto below = values.begin() + static_cast<std::ptrdiff_t>(place);
    std::nth_element(values.begin(), below, values.end());
    const double fraction = place - std::floor(place);
    if (fraction == 0.0) return *below;
    const double next = *std::min_element(below + 1, values.end());
    return *below + fraction * (next - *below);
}

}  // namespace carom
