// Exact sums against whole numbers, which have no rounding, and against cases worked out by hand.
#include "util/exact_sum.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <vector>

#include "util/random.h"

using namespace carom;

namespace {

ExactSum sum_of(const std::vector<double>& terms) {
    ExactSum sum;
    for (const double term : terms) sum.add(term);
    return sum;
}

double value_of(std::initializer_list<double> terms) { return sum_of(terms).value(); }

constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = std::numeric_limits<double>::denorm_min();
constexpr double infinite = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("an exact sum keeps what a sum of doubles loses") {
    CHECK(ExactSum().value() == 0.0);
    CHECK(value_of({1e300, 1.0, -1e300}) == 1.0);
    CHECK(value_of({largest, smallest, -largest}) == smallest);
    CHECK(value_of({largest, largest, -largest}) == largest);
    CHECK(value_of({-3.0, 1.0}) == -2.0);
    CHECK(value_of({smallest, smallest, -smallest}) == smallest);
    CHECK(value_of({-1e-310, 3e-310}) == 3e-310 - 1e-310);  // below 2^-1022 doubles add exactly
}

TEST_CASE("an exact sum is rounded once, to the nearest double and to even between two") {
    const double two_53 = std::ldexp(1.0, 53);
    CHECK(value_of({two_53, 1.0}) == two_53);
    CHECK(value_of({two_53, 2.0, 1.0}) == two_53 + 4.0);
    CHECK(value_of({two_53, 1.0, smallest}) == two_53 + 2.0);
    CHECK(value_of({two_53, 1.0, -smallest}) == two_53);
    CHECK(value_of({-two_53, -1.0, -smallest}) == -two_53 - 2.0);
    CHECK(value_of({largest, largest}) == infinite);
}

TEST_CASE("an exact sum of infinite terms and of none is what doubles give") {
    const double none = std::numeric_limits<double>::quiet_NaN();
    CHECK(value_of({1.0, infinite}) == infinite);
    CHECK(value_of({1.0, -infinite}) == -infinite);
    CHECK(std::isnan(value_of({infinite, -infinite})));
    CHECK(std::isnan(value_of({1.0, none})));
    ExactSum sum = sum_of({2.0, infinite, none, -infinite});
    CHECK(sum.finite_value() == 2.0);
    sum.subtract(none);
    sum.subtract(infinite);
    CHECK(sum.value() == -infinite);
    sum.subtract(-infinite);
    CHECK(sum.value() == 2.0);
}

TEST_CASE("whole numbers of many sizes add up exactly, in any order and in parts") {
    Random random(1, "terms");
    std::vector<double> terms;
    std::int64_t expected = 0;
    for (int k = 0; k < 20'000; ++k) {  // several times as many as are added without a carry
        const int bits = static_cast<int>(random.uniform(0.0, 44.0));
        const auto whole =
            static_cast<std::int64_t>(random.uniform(-1.0, 1.0) * std::ldexp(1.0, bits));
        expected += whole;
        // In units of 2^-200, so that digits below 1 are used, too.
        terms.push_back(std::ldexp(static_cast<double>(whole), -200));
    }
    REQUIRE(std::abs(expected) < (std::int64_t{1} << 53));
    const double value = std::ldexp(static_cast<double>(expected), -200);
    CHECK(sum_of(terms).value() == value);
    std::ranges::reverse(terms);
    CHECK(sum_of(terms).value() == value);
    ExactSum parts = sum_of({terms.begin(), terms.begin() + 777});
    parts.add(sum_of({terms.begin() + 777, terms.end()}));
    CHECK(parts.value() == value);
    for (const double term : terms) parts.subtract(term);
    CHECK(parts.value() == 0.0);
}
