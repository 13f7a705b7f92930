// Smooth functions keep the means of their cells.
#include "panels/field/smooth_cells.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "util/random.h"

using namespace carom;

namespace {

// The mean of each cell's parts.
Eigen::ArrayXd means_of(const Eigen::ArrayXd& fine, Eigen::Index columns, Eigen::Index rows,
                        Eigen::Index parts, Eigen::Index parts_up) {
    Eigen::ArrayXd means = Eigen::ArrayXd::Zero(columns * rows);
    for (Eigen::Index y = 0; y < rows * parts_up; ++y)
        for (Eigen::Index x = 0; x < columns * parts; ++x)
            means[y / parts_up * columns + x / parts] +=
                fine[y * columns * parts + x] / static_cast<double>(parts * parts_up);
    return means;
}

}  // namespace

TEST_CASE("the mean of each cell is kept to 1e-9, and cells without a value have none") {
    Random random(5, "cells of a test");
    for (const int parts : {1, 2, 7, 16})
        for (const bool is_periodic : {false, true})
            for (const Eigen::Index rows : {1, 5}) {
                Eigen::ArrayXd cells(6 * rows);
                for (double& cell : cells) cell = random.uniform(0.0, 9.0);
                cells[2] = std::numeric_limits<double>::quiet_NaN();
                const Eigen::ArrayXd fine = smooth_cells(cells, 6, {parts, rows == 1 ? 1 : parts},
                                                         {is_periodic, is_periodic});
                const Eigen::Index up = rows == 1 ? 1 : parts;
                REQUIRE(fine.size() == cells.size() * parts * up);
                const Eigen::ArrayXd means = means_of(fine, 6, rows, parts, up);
                for (Eigen::Index i = 0; i < cells.size(); ++i) {
                    if (i == 2)
                        CHECK(std::isnan(means[i]));
                    else
                        CHECK(std::abs(means[i] - cells[i]) < 1e-9);
                }
            }
}

TEST_CASE("there is no step between cells, around a periodic box neither") {
    Random random(6, "cells of a test");
    constexpr int columns = 6, rows = 5, parts = 64;
    Eigen::ArrayXd cells(columns * rows);
    for (double& cell : cells) cell = random.uniform(0.0, 9.0);
    const Eigen::ArrayXd fine = smooth_cells(cells, columns, {parts, parts}, {true, true});
    const Eigen::Index wide = columns * parts, high = rows * parts;
    double most = 0.0;
    for (Eigen::Index y = 0; y < high; ++y)
        for (Eigen::Index x = 0; x < wide; ++x) {
            const double here = fine[y * wide + x];
            most = std::max(most, std::abs(fine[y * wide + (x + 1) % wide] - here));
            most = std::max(most, std::abs(fine[(y + 1) % high * wide + x] - here));
        }
    // The steepest slope is a few times the largest difference, in steps of 1/64.
    CHECK(most < 2.0);
}

TEST_CASE("equal cells stay equal, and an even slope stays even away from walls") {
    const Eigen::ArrayXd even = Eigen::ArrayXd::Constant(12, 3.5);
    CHECK((smooth_cells(even, 4, {5, 5}, {false, true}) - 3.5).abs().maxCoeff() < 1e-12);
    const Eigen::ArrayXd slope = Eigen::ArrayXd::LinSpaced(7, 0.0, 6.0);
    const Eigen::ArrayXd fine = smooth_cells(slope, 7, {10, 1}, {false, false});
    for (Eigen::Index i = 10; i < 60; ++i)
        CHECK(fine[i] == doctest::Approx((static_cast<double>(i) + 0.5) / 10.0 - 0.5));
}
