#include "stats/histogram.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace carom;

TEST_CASE("every value is in one bin, below or above") {
    Eigen::ArrayXd values(8);
    values << 0.0, 0.99, 1.0, 2.5, 4.0, -0.1, 4.1, std::numeric_limits<double>::quiet_NaN();
    const Histogram h = histogram(values, {0.0, 4.0, 4});
    CHECK(h.counts == std::vector<std::int64_t>{2, 1, 1, 1});
    CHECK(h.below == 1);
    CHECK(h.above == 2);
}

TEST_CASE("values on an edge but for rounding errors are in the bin above, equal ones in one bin") {
    const Bins bins{0.0, 3.0, 60};
    for (int k = 0; k <= bins.count; ++k) {
        CAPTURE(k);
        const double edge = bins.edge(k);
        const Histogram h =
            histogram(Eigen::ArrayXd{{edge, edge * (1.0 + 4e-16), edge * (1.0 - 4e-16),
                                      edge + 1e-13, edge - 1e-13}},
                      bins);
        CHECK(h.counts[static_cast<std::size_t>(std::min(k, bins.count - 1))] == 5);
    }
    CHECK(histogram(Eigen::ArrayXd{{-1e-6, 0.05 - 1e-6, 3.0 + 1e-6}}, bins).counts[0] == 1);
}

TEST_CASE("bins as narrow as the smallest numbers hold every value") {
    const double tiny = 1e-312;  // whose reciprocal is infinite
    const Histogram counted =
        histogram(Eigen::ArrayXd{{0.0, 0.1 * tiny, 2.5 * tiny, 4.0 * tiny}}, {0.0, 4.0 * tiny, 4});
    CHECK(counted.counts == std::vector<std::int64_t>{2, 0, 1, 1});
    CHECK(counted.below + counted.above == 0);
}

TEST_CASE("quantiles interpolate between order statistics") {
    std::vector<double> values{4.0, 1.0, 3.0, 2.0};  // R: quantile(1:4, .25) is 1.75
    CHECK(quantile(values, 0.25) == 1.75);
    CHECK(quantile(values, 0.0) == 1.0);
    CHECK(quantile(values, 1.0) == 4.0);
}

TEST_CASE("the Freedman-Diaconis rule on a uniform sample has the width 2 IQR n^(-1/3)") {
    std::vector<double> values;
    for (int i = 0; i <= 1000; ++i) values.push_back(i / 1000.0);  // IQR = 0.5
    CHECK(freedman_diaconis(values, 1000.0, 0.0, 1.0, 1, 100) == 10);
    CHECK(freedman_diaconis(values, 1000.0, 0.0, 1.0, 12, 100) == 12);
    CHECK(freedman_diaconis({1.0, 1.0}, 2.0, 0.0, 1.0, 5, 100) == 5);  // no spread at all
}
