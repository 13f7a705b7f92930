#include "stats/fitted_slope.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace carom;

TEST_CASE("a slope is given where it is known, and the same in both halves of its fit") {
    CHECK_FALSE(problem_of({{2.0, 0.1}, {0.1, 0.1}, 20.0, 20.0}).has_value());
    CHECK_FALSE(problem_of({{2.0, 0.1}, {0.15, 0.01}, 20.0, 20.0}).has_value());  // 7.5 %
    CHECK_FALSE(problem_of({{2.0, 0.1}, {0.4, 0.2}, 20.0, 20.0}).has_value());    // two errors
    CHECK(problem_of({{2.0, 0.1}, {0.4, 0.1}, 20.0, 20.0}) == SlopeProblem::bends);
    CHECK_FALSE(problem_of({{2.0, 0.1}, {0.4, 0.1}, 40.0, 2.0}).has_value());  // of two runs
    CHECK(problem_of({{2.0, 0.1}, {-0.4, 0.1}, 20.0, 20.0}) == SlopeProblem::bends);
    CHECK(problem_of({{2.0, 0.1}, {0.0, 0.1}, 3.0, 3.0}) == SlopeProblem::few_pieces);
    CHECK(problem_of({{2.0, 1.5}, {0.0, 0.1}, 20.0, 20.0}) == SlopeProblem::few_pieces);
    CHECK(problem_of({{-0.5, 0.1}, {0.0, 0.1}, 20.0, 20.0}) == SlopeProblem::few_pieces);
    CHECK(problem_of({{NAN, NAN}, {NAN, NAN}, 20.0, 20.0}) == SlopeProblem::few_pieces);
}
