#include "stats/growing_histogram.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "stats/histogram.h"

namespace carom {
namespace {

constexpr std::int64_t most_fine_bins = 100'000;

}  // namespace

// The largest value of the first sample spans at least a thousand and at most ten thousand bins.
void GrowingHistogram::make_room(double largest) {
    if (!(largest > 0.0) || !std::isfinite(largest)) return;
    constexpr int least_exponent = -300;  // smaller powers of ten lose digits
    if (!has_scale_)
        set_exponent(
            std::max(least_exponent, static_cast<int>(std::floor(std::log10(largest))) - 3));
    has_scale_ = true;
    while (largest / width_ >= double(most_fine_bins - 1)) coarsen();
}

void GrowingHistogram::count(const Values& values, std::int64_t held, std::int64_t offset) {
    for (const double value : values) {
        if (!std::isfinite(value)) continue;
        const auto k = static_cast<std::size_t>(bin_of(value));
        if (k >= fine_.size()) fine_.resize(k + 1);
        fine_[k].held += held;
        fine_[k].offset += offset;
    }
}

void GrowingHistogram::hold_none() {
    for (Bin& bin : fine_) bin = {0, bin.offset + samples_ * bin.held};
}

void GrowingHistogram::coarsen() {
    std::vector<Bin> coarse((fine_.size() + 9) / 10);
    for (std::size_t k = 0; k < fine_.size(); ++k) {
        coarse[k / 10].held += fine_[k].held;
        coarse[k / 10].offset += fine_[k].offset;
    }
    fine_.swap(coarse);
    set_exponent(exponent_ + 1);
}

void GrowingHistogram::set_exponent(int exponent) {
    exponent_ = exponent;
    width_ = std::pow(10.0, exponent);
    bins_per_unit_ = std::pow(10.0, -exponent);
}

// Accurate to the last digit of the decimal number: 3 bins of 0.1 end at 0.3.
double GrowingHistogram::edge(std::int64_t bin) const {
    const auto count = static_cast<double>(bin);
    return exponent_ < 0 ? count / bins_per_unit_ : count * width_;
}

std::int64_t GrowingHistogram::bin_of(double value) const {
    // Relative to the value, so that it stays in the same bin when bins are joined. With at most
    // 10^5 bins, rounding errors of the edges are less than `clear`.
    constexpr double clear = 1e-9, rounding = 1e-12;
    value += rounding * value;
    const double place = value * bins_per_unit_;
    auto bin = static_cast<std::int64_t>(place);
    const double within = place - static_cast<double>(bin);
    if (within > clear && within < 1.0 - clear) return bin;
    while (bin > 0 && value < edge(bin)) --bin;
    while (value >= edge(bin + 1)) ++bin;
    return bin;
}

std::vector<std::int64_t> GrowingHistogram::fine_counts() const {
    std::vector<std::int64_t> counts;
    for (const Bin& bin : fine_) counts.push_back(bin.offset + samples_ * bin.held);
    return counts;
}

// Accurate to the width of a fine bin.
double GrowingHistogram::quantile(const std::vector<std::int64_t>& fine, double total,
                                  double share) const {
    const double wanted = share * total;
    double seen = 0.0;
    std::size_t bin = 0;
    while (bin + 1 < fine.size() && seen + static_cast<double>(fine[bin]) < wanted)
        seen += static_cast<double>(fine[bin++]);
    const auto here = static_cast<double>(fine[bin]);
    const double within = here > 0.0 ? (wanted - seen) / here : 0.0;
    return edge(static_cast<std::int64_t>(bin)) + within * width_;
}

// The smallest of 1, 2, 5, 10, 20, ... fine bins that together are at least `width` wide.
std::int64_t GrowingHistogram::bins_together(double width) const {
    const double fine = width / width_;
    for (std::int64_t decade = 1;; decade *= 10)
        for (const std::int64_t step : {1, 2, 5})
            if (static_cast<double>(step * decade) >= fine) return step * decade;
}

BinnedCounts GrowingHistogram::counts() const {
    const std::vector<std::int64_t> fine = fine_counts();
    if (!has_scale_) return {{0.0, 1.0}, fine};
    const auto total =
        static_cast<double>(std::accumulate(fine.begin(), fine.end(), std::int64_t{0}));
    const double spread = quantile(fine, total, 0.75) - quantile(fine, total, 0.25);
    const double rule = freedman_diaconis_width(spread, total);
    const double top = edge(static_cast<std::int64_t>(fine.size()));
    const std::int64_t together = bins_together(std::clamp(rule, top / 200.0, top / 20.0));
    BinnedCounts result;
    result.counts.resize((fine.size() + static_cast<std::size_t>(together) - 1) /
                         static_cast<std::size_t>(together));
    for (std::size_t bin = 0; bin < fine.size(); ++bin)
        result.counts[bin / static_cast<std::size_t>(together)] += fine[bin];
    for (std::size_t k = 0; k <= result.counts.size(); ++k)
        result.edges.push_back(edge(static_cast<std::int64_t>(k) * together));
    return result;
}

}  // namespace carom
