// Tests whether numbers follow a distribution. The Kolmogorov-Smirnov test is used because its
// p-value is known far into the tail, where a correction for many simultaneous tests needs it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace carom::test {

/// The p-value of the Kolmogorov-Smirnov test of `values` against the distribution function
/// `below`: the probability of a larger distance if the values are independent draws from it (with
/// the correction of Stephens 1970 for finite samples).
inline double chance(std::vector<double> values, const std::function<double(double)>& below) {
    std::sort(values.begin(), values.end());
    const double n = static_cast<double>(values.size());
    double distance = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double f = below(values[i]), k = static_cast<double>(i);
        distance = std::max({distance, f - k / n, (k + 1.0) / n - f});
    }
    const double t = distance * (std::sqrt(n) + 0.12 + 0.11 / std::sqrt(n));
    double sum = 0.0;
    for (int k = 1; k <= 100; ++k)
        sum += (k % 2 == 1 ? 2.0 : -2.0) * std::exp(-2.0 * k * k * t * t);
    return t < 0.2 ? 1.0 : std::clamp(sum, 0.0, 1.0);
}

/// Correlation of each value with the next. For n independent values it is normally distributed
/// with variance 1/n.
inline double correlation_with_next(const std::vector<double>& values) {
    double mean = 0.0, variance = 0.0, product = 0.0;
    for (const double v : values) mean += v / static_cast<double>(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        variance += (values[i] - mean) * (values[i] - mean);
        if (i > 0) product += (values[i] - mean) * (values[i - 1] - mean);
    }
    return product / variance;
}

/// Distribution function of Beta(a, b) at x for integers a and b: the probability that at least `a`
/// of a + b - 1 uniform random numbers lie below x.
inline double beta_below(int a, int b, double x) {
    double sum = 0.0, choices = 1.0;
    for (int k = 0; k < a + b; ++k) {
        if (k >= a) sum += choices * std::pow(x, k) * std::pow(1.0 - x, a + b - 1 - k);
        choices *= static_cast<double>(a + b - 1 - k) / (k + 1);
    }
    return sum;
}

}  // namespace carom::test
