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

TEST_CASE("mean and deviation over several samples are those of all their values in one") {
    Random random(7, "running histogram");
    RunningHistogram running({0.0, 1.0, 10}, std::nullopt);
    constexpr int samples = 20, each = 50;
    Eigen::ArrayXd all(samples * each);
    for (int s = 0; s < samples; ++s) {
        Eigen::ArrayXd values(each);
        for (double& value : values) value = 1e6 + random.uniform() * (s + 1);
        all.segment(s * each, each) = values;
        running.add(s, values);
    }
    const MeanHistogram mean = running.mean();
    const double expected = all.mean();
    CHECK(mean.values == samples * each);
    CHECK(mean.mean == relative(expected, 1e-14));
    CHECK(mean.deviation == relative(std::sqrt((all - expected).square().mean()), 1e-9));
    CHECK(mean.above == each);  // a mean number, as the bars are
}

TEST_CASE("a window holds the samples later than it before the last") {
    RunningHistogram running({0.0, 10.0, 10}, 2.0);
    for (int t = 0; t < 6; ++t) running.add(t, Eigen::ArrayXd::Constant(3, t + 0.5));
    const MeanHistogram mean = running.mean();
    CHECK(mean.counts[3] == 0.0);
    CHECK(mean.counts[4] == 1.5);
    CHECK(mean.counts[5] == 1.5);
    CHECK(mean.mean == relative(5.0, 1e-14));
    CHECK(mean.deviation == relative(0.5, 1e-14));
}

TEST_CASE("a long window that slides is that of its samples in one") {
    Random random(11, "running histogram");
    const Bins bins{-1.0, 3.0, 16};
    constexpr double window = 30.0;
    RunningHistogram running(bins, window);
    std::vector<std::pair<double, Eigen::ArrayXd>> samples;
    double time = 0.0;
    for (int s = 0; s < 400; ++s) {
        time += s == 200 ? 100.0 : random.uniform();  // once all at once are too old
        Eigen::ArrayXd values(s % 5);                 // of some samples none
        for (double& value : values) value = random.uniform() * 4.0 - 1.2;
        samples.emplace_back(time, values);
        running.add(time, values);
        std::erase_if(samples, [&](const auto& one) { return one.first <= time - window; });
        std::vector<double> all;
        for (const auto& one : samples) all.insert(all.end(), one.second.begin(), one.second.end());
        const Eigen::ArrayXd joined =
            Eigen::Map<Eigen::ArrayXd>(all.data(), static_cast<Eigen::Index>(all.size()));
        const Histogram expected = histogram(joined, bins);
        const MeanHistogram mean = running.mean();
        const auto count = static_cast<double>(samples.size());
        for (std::size_t k = 0; k < mean.counts.size(); ++k)
            REQUIRE(mean.counts[k] == static_cast<double>(expected.counts[k]) / count);
        REQUIRE(mean.above == static_cast<double>(expected.above) / count);
        REQUIRE(mean.values == static_cast<double>(joined.size()));
        if (joined.size() == 0) continue;
        REQUIRE(std::abs(mean.mean - joined.mean()) < 1e-12);
        const double deviation = std::sqrt((joined - joined.mean()).square().mean());
        REQUIRE(std::abs(mean.deviation - deviation) < 1e-9);
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
