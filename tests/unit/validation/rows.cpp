// Whether rows of the table of validation are judged as statistics has it.
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "validation/hard_fluids.h"
#include "validation/row.h"

using namespace carom;
using validation::Row;
using validation::row_of;
using validation::Truth;

namespace {

Truth truth_of(double value, double error = 0.0, double rounding = 0.0) {
    return {"", value, error, rounding, ""};
}

}  // namespace

TEST_CASE("z is the distance in standard errors, those of both sides") {
    const std::vector<double> values(1000, 5.0);
    std::vector<double> scattered = values;
    for (std::size_t i = 0; i < scattered.size(); ++i) scattered[i] += i % 2 == 0 ? 1.0 : -1.0;
    const double error = 1.0 / std::sqrt(999.0);  // of a mean of 1000 values of deviation 1
    CHECK(row_of(truth_of(5.0), scattered).z == 0.0);
    CHECK(row_of(truth_of(5.0 - 3.0 * error), scattered).z == doctest::Approx(3.0).epsilon(0.01));
    CHECK(row_of(truth_of(5.0 + 2.0 * std::hypot(error, 0.1), 0.1), scattered).z ==
          doctest::Approx(-2.0).epsilon(0.01));
}

// Two-sided chances of Student's t of four degrees of freedom and of the normal deviate: 5 % at
// 2.776 and 1.960, 0.1 % at 8.610 and 3.291.
TEST_CASE("few runs are judged by Student's t") {
    const auto z_of = [](double t, int runs) {
        std::vector<double> values(static_cast<std::size_t>(runs), 0.0);
        values.front() = 1.0;
        values.back() = -1.0;
        const double error = std::sqrt(2.0 / (runs * (runs - 1.0)));
        return row_of(truth_of(-t * error), values).z;
    };
    CHECK(z_of(2.776, 5) == doctest::Approx(1.960).epsilon(0.01));
    CHECK(z_of(8.610, 5) == doctest::Approx(3.291).epsilon(0.01));
}

TEST_CASE("where there is no chance every run must agree") {
    const Truth truth = truth_of(31.0, 0.0, 1e-12);
    CHECK(row_of(truth, {31.0, 31.0}).z == 0.0);
    CHECK(std::isinf(row_of(truth, {31.0, 32.0}).z));
}

TEST_CASE("the bound grows with the number of rows") {
    CHECK(validation::bound_of(1) == doctest::Approx(2.5758).epsilon(1e-4));
    CHECK(validation::bound_of(100) == doctest::Approx(3.8906).epsilon(1e-4));
}

// Z = 1 + 2^(d - 1) packing (1 - 1/N) of N particles in d dimensions to first order: each meets
// only the N - 1 others.
TEST_CASE("a fixed number of particles presses less, as the second virial coefficient has it") {
    const double packing = 1e-3, count = 100.0;
    for (const int dimension : {2, 3})
        CHECK(validation::finite_number(dimension, packing, count) ==
              doctest::Approx(-std::pow(2.0, dimension - 1) * packing / count).epsilon(0.02));
}
