#include "stats/running_histogram.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "support/relative.h"
#include "util/random.h"

using namespace carom;
using test::relative;

namespace {

using Samples = std::vector<std::pair<double, Eigen::ArrayXd>>;

// By the trapezoidal rule, each sample with half of the time to its neighbours; of pieces of time
// that end later than `from`.
MeanHistogram slowly(const Samples& samples, const Bins& bins, double from) {
    std::vector<double> weights(samples.size(), 0.0);
    double all = 0.0;
    for (std::size_t s = 1; s < samples.size(); ++s) {
        if (samples[s].first <= from) continue;
        const double span = samples[s].first - samples[s - 1].first;
        weights[s - 1] += 0.5 * span;
        weights[s] += 0.5 * span;
        all += span;
    }
    MeanHistogram mean{.bins = bins, .counts = std::vector<double>(std::size_t(bins.count))};
    double count = 0.0, sum = 0.0, squares = 0.0;
    for (std::size_t s = 0; s < samples.size(); ++s) {
        const Histogram one = histogram(samples[s].second, bins);
        for (std::size_t k = 0; k < mean.counts.size(); ++k)
            mean.counts[k] += weights[s] / all * double(one.counts[k]);
        mean.above += weights[s] / all * double(one.above);
        mean.below += weights[s] / all * double(one.below);
        count += weights[s] * double(samples[s].second.size());
        sum += weights[s] * samples[s].second.sum();
    }
    mean.mean = sum / count;
    for (std::size_t s = 0; s < samples.size(); ++s)
        squares += weights[s] * (samples[s].second - mean.mean).square().sum();
    mean.deviation = std::sqrt(squares / count);
    return mean;
}

// Round-off of some hundred additions of numbers of this size.
void check_same(const MeanHistogram& mean, const MeanHistogram& expected, double size) {
    const double near = 1e-13 * size;
    for (std::size_t k = 0; k < mean.counts.size(); ++k)
        REQUIRE(std::abs(mean.counts[k] - expected.counts[k]) < 1e-12);
    REQUIRE(std::abs(mean.below - expected.below) < 1e-12);
    REQUIRE(std::abs(mean.above - expected.above) < 1e-12);
    if (std::isnan(expected.mean)) return;
    REQUIRE(std::abs(mean.mean - expected.mean) < near);
    REQUIRE(std::abs(mean.deviation - expected.deviation) < std::sqrt(size) * 1e-9);
}

}  // namespace

TEST_CASE("mean and deviation since the start are those over time") {
    Random random(7, "running histogram");
    const Bins bins{0.0, 1.0, 10};
    RunningHistogram running(bins, std::nullopt);
    Samples samples;
    double time = 3.0;
    for (int s = 0; s < 20; ++s) {
        Eigen::ArrayXd values(50);
        for (double& value : values) value = (s % 2 == 0 ? 1e6 : 0.0) + random.uniform() * (s + 1);
        samples.emplace_back(time, values);
        running.add(time, values);
        time += random.uniform();
    }
    check_same(running.mean(), slowly(samples, bins, -1.0), 1e6);
}

TEST_CASE("more samples in a part of the time do not change a mean") {
    RunningHistogram running({0.0, 2.0, 2}, std::nullopt);
    // At 0.5 up to time 1, and at 1.5 up to time 3.
    for (int i = 0; i <= 1000; ++i) running.add(1e-3 * i, Eigen::ArrayXd::Constant(1, 0.5));
    running.add(1.0, Eigen::ArrayXd::Constant(1, 1.5));
    running.add(3.0, Eigen::ArrayXd::Constant(1, 1.5));
    CHECK(running.mean().counts[0] == relative(1.0 / 3.0, 1e-12));
    CHECK(running.mean().counts[1] == relative(2.0 / 3.0, 1e-12));
    CHECK(running.mean().mean == relative(3.5 / 3.0, 1e-12));
}

TEST_CASE("a window holds the time before the last sample, and the sample where it is shorter") {
    for (const double window : {2.0, 0.5, 0.0}) {
        CAPTURE(window);
        RunningHistogram running({0.0, 10.0, 10}, window);
        for (int t = 0; t < 6; ++t) running.add(t, Eigen::ArrayXd::Constant(3, t + 0.5));
        const MeanHistogram mean = running.mean();
        CHECK(mean.counts[2] == 0.0);
        CHECK(mean.counts[3] == (window == 2.0 ? 0.75 : 0.0));
        CHECK(mean.counts[4] == (window == 2.0 ? 1.5 : 0.0));
        CHECK(mean.counts[5] == (window == 2.0 ? 0.75 : 3.0));
        CHECK(mean.mean == relative(window == 2.0 ? 4.5 : 5.5, 1e-14));
        if (window == 2.0) CHECK(mean.deviation == relative(std::sqrt(0.5), 1e-14));
    }
}

TEST_CASE("a long window that slides is that of its samples in one") {
    Random random(11, "running histogram");
    const Bins bins{-1.0, 3.0, 16};
    constexpr double window = 30.0;
    RunningHistogram running(bins, window);
    Samples samples;
    double time = 0.0;
    for (int s = 0; s < 400; ++s) {
        time += s == 200 ? 100.0 : random.uniform();  // once all at once are too old
        Eigen::ArrayXd values(s % 5);                 // of some samples none
        for (double& value : values) value = random.uniform() * 4.0 - 1.2;
        samples.emplace_back(time, values);
        running.add(time, values);
        if (s == 0 || s == 200) samples = {samples.back()};
        if (samples.size() == 1) continue;
        check_same(running.mean(), slowly(samples, bins, time - window), 1.0);
    }
}

TEST_CASE("what is not finite is counted and has no part in the moments") {
    RunningHistogram running({0.0, 10.0, 10}, 0.0);
    const double infinite = std::numeric_limits<double>::infinity();
    running.add(0.0, Eigen::Array3d(1.5, 2.5, infinite));
    CHECK(running.mean().above == 1.0);
    CHECK(running.mean().mean == 2.0);
    running.add(1.0, Eigen::Array2d(infinite, -infinite));
    CHECK(running.mean().below == 1.0);
    CHECK(std::isnan(running.mean().mean));
    CHECK(running.mean().deviation == 0.0);
}
