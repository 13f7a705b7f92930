// Measurements as values: readings that grow, and means over runs against sums by hand.
#include "stats/means/measured.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>

using namespace carom;

TEST_CASE("readings of lines grow moment by moment") {
    Measured all;
    all.add(0.0, {1.0, 2.0});
    all.add(0.5, {3.0, NAN});
    CHECK(all.x == std::vector{0.0, 0.5});
    CHECK(all.y.at(0) == std::vector{1.0, 3.0});
    CHECK(all.y.at(1).front() == 2.0);
    CHECK(std::isnan(all.y.at(1).back()));
    CHECK(all.bytes() == 6 * sizeof(double));
}

// Of 1, 2 and 6 the mean is 3, the variance ((-2)^2 + (-1)^2 + 3^2) / 2 = 7, and the standard error
// of the mean the root of 7 / 3.
TEST_CASE("the mean of measurements has the scatter of the runs as its error") {
    std::array<Measured, 3> runs;
    const std::array values{1.0, 2.0, 6.0};
    for (std::size_t k = 0; k < runs.size(); ++k)
        runs[k] = {.x = {0.0, 1.0},
                   .y = {{values[k], k == 0 ? NAN : values[k]}},
                   .numbers = {{{-values[k], NAN}}}};
    const std::array<const Measured*, 3> all{&runs[0], &runs[1], &runs[2]};
    const Measured mean = mean_of(all);
    CHECK(mean.x == runs[0].x);
    CHECK(mean.y[0][0] == doctest::Approx(3.0).epsilon(1e-15));
    CHECK(mean.error[0][0] == doctest::Approx(std::sqrt(7.0 / 3.0)).epsilon(1e-15));
    // Of 2 and 6, where the first run has no number.
    CHECK(mean.y[0][1] == doctest::Approx(4.0).epsilon(1e-15));
    CHECK(mean.error[0][1] == doctest::Approx(2.0).epsilon(1e-15));
    CHECK(mean.numbers[0][0].mean == doctest::Approx(-3.0).epsilon(1e-15));
    CHECK(mean.numbers[0][0].error == doctest::Approx(std::sqrt(7.0 / 3.0)).epsilon(1e-15));
}
