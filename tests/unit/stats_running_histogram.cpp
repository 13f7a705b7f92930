#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "stats/running_histogram.h"
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
