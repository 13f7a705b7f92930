#include "stats/growing_histogram.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "stats/histogram.h"

namespace carom {
namespace {

constexpr std::int64_t most_fine_bins = 100'000;

double largest_finite(const Eigen::ArrayXd& values) {
    double largest = 0.0;
    for (const double value : values)
        if (std::isfinite(value)) largest = std::max(largest, value);
    return largest;
}

}  // namespace

void GrowingHistogram::add(const Eigen::ArrayXd& values) {
    const double largest = largest_finite(values);
    if (fine_.empty() && largest > 0.0) look_first(largest);
    if (!fine_.empty())
        while (largest / width_ >= double(most_fine_bins - 1)) coarsen();
    for (const double value : values) {
        if (!std::isfinite(value)) continue;
        ++total_;
        if (fine_.empty()) {
            ++zeros_;
            continue;
        }
        const auto bin = static_cast<std::size_t>(bin_of(value));
        if (bin >= fine_.size()) fine_.resize(bin + 1);
        ++fine_[bin];
    }
}

// At least a thousand bins up to the largest value of the first look, at most ten thousand.
void GrowingHistogram::look_first(double largest) {
    constexpr int least_exponent = -300;  // below, powers of ten lose their digits
    set_exponent(std::max(least_exponent, static_cast<int>(std::floor(std::log10(largest))) - 3));
    fine_.assign(1, zeros_);
}

void GrowingHistogram::coarsen() {
    std::vector<std::int64_t> coarse((fine_.size() + 9) / 10);
    for (std::size_t bin = 0; bin < fine_.size(); ++bin) coarse[bin / 10] += fine_[bin];
    fine_.swap(coarse);
    set_exponent(exponent_ + 1);
}

void GrowingHistogram::set_exponent(int exponent) {
    exponent_ = exponent;
    width_ = std::pow(10.0, exponent);
    bins_per_unit_ = std::pow(10.0, -exponent);
}

// A decimal number to the last digit: 3 bins of 0.1 end at 0.3.
double GrowingHistogram::edge(std::int64_t bin) const {
    const auto count = static_cast<double>(bin);
    return exponent_ < 0 ? count / bins_per_unit_ : count * width_;
}

std::int64_t GrowingHistogram::bin_of(double value) const {
    auto bin = static_cast<std::int64_t>(value / width_);
    while (bin > 0 && value < edge(bin)) --bin;
    while (value >= edge(bin + 1)) ++bin;
    return bin;
}

// To within a fine bin.
double GrowingHistogram::quantile(double share) const {
    const double wanted = share * static_cast<double>(total_);
    double seen = 0.0;
    std::size_t bin = 0;
    while (bin + 1 < fine_.size() && seen + static_cast<double>(fine_[bin]) < wanted)
        seen += static_cast<double>(fine_[bin++]);
    const auto here = static_cast<double>(fine_[bin]);
    const double within = here > 0.0 ? (wanted - seen) / here : 0.0;
    return edge(static_cast<std::int64_t>(bin)) + within * width_;
}

// The least of 1, 2, 5, 10, 20, ... fine bins that is as wide.
std::int64_t GrowingHistogram::bins_together(double width) const {
    const double fine = width / width_;
    for (std::int64_t decade = 1;; decade *= 10)
        for (const std::int64_t step : {1, 2, 5})
            if (static_cast<double>(step * decade) >= fine) return step * decade;
}

BinnedCounts GrowingHistogram::counts() const {
    if (fine_.empty()) return {{0.0, 1.0}, {zeros_}};
    const double rule =
        freedman_diaconis_width(quantile(0.75) - quantile(0.25), static_cast<double>(total_));
    const double top = edge(static_cast<std::int64_t>(fine_.size()));
    const std::int64_t together = bins_together(std::clamp(rule, top / 200.0, top / 20.0));
    BinnedCounts result;
    result.counts.resize((fine_.size() + static_cast<std::size_t>(together) - 1) /
                         static_cast<std::size_t>(together));
    for (std::size_t bin = 0; bin < fine_.size(); ++bin)
        result.counts[bin / static_cast<std::size_t>(together)] += fine_[bin];
    for (std::size_t k = 0; k <= result.counts.size(); ++k)
        result.edges.push_back(edge(static_cast<std::int64_t>(k) * together));
    return result;
}

}  // namespace carom
