// The standard error of a mean from its pieces: by hand, and for pieces drawn independently or not.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "stats/means/mean_error.h"
#include "util/random.h"

using namespace carom;

namespace {

PieceSums pieces_of(const std::vector<double>& values) {
    const auto count = static_cast<Eigen::Index>(values.size());
    PieceSums pieces{Eigen::ArrayXXd(count, 1), Eigen::ArrayXXd::Ones(count, 1)};
    for (Eigen::Index k = 0; k < count; ++k) pieces.sum(k, 0) = values[static_cast<std::size_t>(k)];
    return pieces;
}

// 16 pieces in eight cells, each beginning with `memory` times the one before.
PieceSums pieces_with(double memory, Random& random) {
    PieceSums pieces{Eigen::ArrayXXd(16, 8), Eigen::ArrayXXd::Ones(16, 8)};
    for (Eigen::Index cell = 0; cell < 8; ++cell) {
        double value = random.normal();
        for (Eigen::Index k = 0; k < 16; ++k) {
            pieces.sum(k, cell) = 10.0 + value;
            value = memory * value + std::sqrt(1.0 - memory * memory) * random.normal();
        }
    }
    return pieces;
}

int share_with_errors(double memory) {
    Random random(7, "pieces");
    int found = 0;
    for (int k = 0; k < 1000; ++k) found += standard_errors(pieces_with(memory, random)) ? 1 : 0;
    return found;
}

}  // namespace

TEST_CASE("neighbouring pieces in any order have a correlation of 0 on average") {
    std::array<int, 5> order{0, 1, 2, 3, 4};
    const std::array<double, 5> values{1.0, 2.0, 4.0, 9.0, -3.0};
    double sum = 0.0, count = 0.0;
    do {
        std::vector<double> ordered;
        for (const int k : order) ordered.push_back(values.at(static_cast<std::size_t>(k)));
        sum += correlation_of_neighbours(pieces_of(ordered));
        count += 1.0;
    } while (std::ranges::next_permutation(order).found);
    CHECK(count == 120.0);
    CHECK(std::abs(sum / count) < 1e-14);
}

TEST_CASE("the error of a mean is that of the mean of its pieces in pairs") {
    const std::vector<double> values{3, 2, 1, 6, 4, 3, 6, 6, 3, 6, 4, 5, 1, 6, 6, 6};
    std::vector<double> pairs;
    for (std::size_t k = 0; k < values.size(); k += 2)
        pairs.push_back(0.5 * (values[k] + values[k + 1]));
    const auto errors = standard_errors(pieces_of(values));
    REQUIRE(errors);
    CHECK((*errors)[0] == doctest::Approx(mean_error(pairs).error));

    // A cell that is empty for a pair of pieces has no error, one where all is constant none either
    // way.
    PieceSums three = pieces_of(values);
    three.sum.conservativeResize(16, 3);
    three.weight = Eigen::ArrayXXd::Ones(16, 3);
    three.sum.col(1) = three.sum.col(0);
    three.sum(4, 1) = three.sum(5, 1) = 0.0;
    three.sum.col(2) = 2.0;
    const auto others = standard_errors(three);
    REQUIRE(others);
    CHECK(std::isnan((*others)[1]));
    CHECK((*others)[2] == 0.0);
    CHECK(!standard_errors(pieces_of(std::vector<double>(16, 2.0))));
}

TEST_CASE("weights count: a temperature is energy over freedoms, not a mean of ratios") {
    PieceSums pieces{Eigen::ArrayXXd(16, 1), Eigen::ArrayXXd(16, 1)};
    for (Eigen::Index k = 0; k < 16; ++k) {
        pieces.weight(k, 0) = 1.0 + static_cast<double>(k * k % 5);
        pieces.sum(k, 0) = 3.0 * pieces.weight(k, 0);  // the same ratio in all
    }
    CHECK(std::isnan(correlation_of_neighbours(pieces)));
    pieces.sum(3, 0) += 1.0;
    CHECK(std::isfinite(correlation_of_neighbours(pieces)));
}

TEST_CASE("pieces have errors if they are independent") {
    CHECK(share_with_errors(0.0) > 950);
    CHECK(share_with_errors(0.5) < 150);
    CHECK(share_with_errors(0.8) < 3);
    CHECK(share_with_errors(-0.6) < 20);
}

TEST_CASE("a drift and a wave have no errors, whatever the period of the wave") {
    Random random(8, "pieces");
    const auto has_errors = [&](const auto& slow) {
        PieceSums pieces = pieces_with(0.0, random);
        for (Eigen::Index cell = 0; cell < 8; ++cell)
            for (Eigen::Index k = 0; k < 16; ++k)
                pieces.sum(k, cell) += slow(static_cast<double>(cell), static_cast<double>(k));
        return standard_errors(pieces).has_value();
    };
    CHECK(!has_errors([](double cell, double k) { return 0.4 * (cell - 3.5) * (k - 7.5) / 3.5; }));
    for (const double period : {2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 12.0, 20.0, 32.0}) {
        CAPTURE(period);
        CHECK(!has_errors([&](double cell, double k) {
            return 8.0 * std::cos(std::numbers::pi * cell / 7.0) *
                   std::cos(2.0 * std::numbers::pi * (k + 0.3) / period);
        }));
    }
}

TEST_CASE("the error of an average over time is the scatter of other such times") {
    Random random(11, "times");
    constexpr int runs = 200, moments = 800;
    constexpr double step = 0.25, level = 3.0;
    double square_error = 0.0, variance = 0.0;
    int known = 0;
    for (int run = 0; run < runs; ++run) {
        std::vector<double> times{2.0}, integrals{0.0};
        for (int k = 0; k < moments; ++k) {
            times.push_back(times.back() + step);
            integrals.push_back(integrals.back() + step * (level + random.normal()));
        }
        const double mean = integrals.back() / (times.back() - times.front());
        variance += (mean - level) * (mean - level) / runs;
        const double error = error_of_time_average(times, integrals);
        if (!std::isfinite(error)) continue;
        square_error += error * error;
        ++known;
    }
    REQUIRE(known > runs / 2);
    square_error /= known;
    // Of white noise; each of more than 100 squares, of 20 pieces at least, scatters by
    // sqrt(2 / 19), their mean by 0.032, of which three are allowed.
    CHECK(square_error == doctest::Approx(1.0 / moments).epsilon(0.1));
    CHECK(std::abs(variance / square_error - 1.0) < 4.0 * std::sqrt(2.0 / runs));
}

TEST_CASE("an average over time has no error while it drifts, nor with few moments") {
    std::vector<double> times, integrals;
    for (int k = 0; k <= 400; ++k) {
        times.push_back(k);
        integrals.push_back(0.5 * k * k);
    }
    CHECK(std::isnan(error_of_time_average(times, integrals)));
    CHECK(std::isnan(error_of_time_average({0.0, 1.0}, {0.0, 2.0})));
    CHECK(std::isnan(error_of_time_average({}, {})));
}
