#include "stats/growing_histogram.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "util/random.h"

using namespace carom;

namespace {

Eigen::ArrayXd array(std::initializer_list<double> values) {
    return Eigen::Map<const Eigen::ArrayXd>(values.begin(),
                                            static_cast<Eigen::Index>(values.size()));
}

std::int64_t total(const BinnedCounts& bins) {
    return std::accumulate(bins.counts.begin(), bins.counts.end(), std::int64_t{0});
}

// Counts a sample.
void add(GrowingHistogram& histogram, const Eigen::ArrayXd& values) {
    double largest = 0.0;
    for (const double value : values)
        if (std::isfinite(value)) largest = std::max(largest, value);
    histogram.make_room(largest);
    histogram.add(values);
}

// How many of all values lie in the bins, by looking at each.
void check_counts(const BinnedCounts& bins, const std::vector<double>& values) {
    REQUIRE(bins.edges.size() == bins.counts.size() + 1);
    for (std::size_t k = 0; k < bins.counts.size(); ++k) {
        CAPTURE(bins.edges[k]);
        CHECK(bins.counts[k] == std::count_if(values.begin(), values.end(), [&](double value) {
                  return value >= bins.edges[k] && value < bins.edges[k + 1];
              }));
    }
    CHECK(total(bins) == static_cast<std::int64_t>(values.size()));
}

}  // namespace

TEST_CASE("no value at all, and nothing but zeros, give one bin from 0 to 1") {
    GrowingHistogram none;
    CHECK(none.counts().edges == std::vector<double>{0.0, 1.0});
    CHECK(none.counts().counts == std::vector<std::int64_t>{0});
    GrowingHistogram zeros;
    add(zeros, array({0.0, 0.0}));
    add(zeros, array({0.0}));
    CHECK(zeros.counts().edges == std::vector<double>{0.0, 1.0});
    CHECK(zeros.counts().counts == std::vector<std::int64_t>{3});
}

TEST_CASE("zeros seen before the first larger value are counted with the smallest") {
    GrowingHistogram histogram;
    add(histogram, array({0.0, 0.0}));
    add(histogram, array({0.0, 2.0}));
    const BinnedCounts bins = histogram.counts();
    CHECK(bins.counts.front() == 3);
    CHECK(bins.counts.back() == 1);
    check_counts(bins, {0.0, 0.0, 0.0, 2.0});
}

TEST_CASE("values that are no number or infinite are left out") {
    GrowingHistogram histogram;
    add(histogram, array({std::numeric_limits<double>::quiet_NaN(), 1.0,
                          std::numeric_limits<double>::infinity()}));
    check_counts(histogram.counts(), {1.0});
}

TEST_CASE("every value is counted in its bin, however far the range grows") {
    GrowingHistogram histogram;
    std::vector<double> all;
    Random random(1, "values");
    for (int round = 0; round < 60; ++round) {  // up to 10^6 times the values of the first look
        Eigen::ArrayXd values(50);
        for (double& value : values) {
            value = std::pow(10.0, 0.1 * round) * random.uniform();
            all.push_back(value);
        }
        add(histogram, values);
    }
    check_counts(histogram.counts(), all);
}

TEST_CASE("edges are decimal numbers, and a value on an edge begins a bin") {
    GrowingHistogram histogram;
    std::vector<double> all;
    for (int i = 0; i <= 30; ++i) all.push_back(i / 10.0);
    add(histogram, Eigen::Map<const Eigen::ArrayXd>(all.data(), 31));
    const BinnedCounts bins = histogram.counts();
    check_counts(bins, all);
    // 31 values from 0 to 3: 2 IQR n^(-1/3) = 0.95, kept at 1/20 of the range, 0.15: 0.2
    REQUIRE(bins.edges.size() == 17);
    CHECK(bins.edges[3] == 0.6);
    CHECK(bins.edges[7] == 1.4);
    CHECK(bins.counts[3] == 2);
}

TEST_CASE("bins are as wide as Freedman and Diaconis say, rounded up to 1, 2 or 5") {
    GrowingHistogram histogram;
    Eigen::ArrayXd values(64'000);
    for (Eigen::Index i = 0; i < values.size(); ++i)  // uniform in [0, 100): IQR 50, width 2.5
        values[i] = 100.0 * (static_cast<double>(i) + 0.5) / 64'000.0;
    add(histogram, values);
    const BinnedCounts bins = histogram.counts();
    CHECK(bins.edges[1] == 5.0);
    CHECK(bins.counts == std::vector<std::int64_t>(20, 3200));
}

TEST_CASE("tiny and huge values have bins of their size") {
    for (const double scale : {1e-200, 1e-30, 1e30, 1e200}) {
        CAPTURE(scale);
        GrowingHistogram histogram;
        add(histogram, scale * array({1.0, 2.0, 3.0}));
        const BinnedCounts bins = histogram.counts();
        check_counts(bins, {scale * 1.0, scale * 2.0, scale * 3.0});
        CHECK(bins.edges.back() < 4.0 * scale);
    }
}

TEST_CASE("one speed with rounding errors is in one bin, also after bins have been joined") {
    for (const double speed : {1.0, 0.3, 0.07, 5.0, 1e-5}) {
        CAPTURE(speed);
        GrowingHistogram histogram;
        const Eigen::ArrayXd equal{
            {speed, speed * (1.0 + 5e-16), speed * (1.0 - 5e-16), speed * (1.0 - 2e-14)}};
        histogram.make_room(speed);
        histogram.hold(equal);
        histogram.count_held();
        const auto bars = [&] {
            std::vector<std::int64_t> counts = histogram.counts().counts;
            std::erase(counts, 0);
            return counts;
        };
        CHECK(bars() == std::vector<std::int64_t>{4});
        histogram.make_room(1e4 * speed);
        histogram.replace(equal, Eigen::ArrayXd::Constant(4, 1e4 * speed));
        histogram.count_held();
        CHECK(bars() == std::vector<std::int64_t>{4, 4});
    }
}
