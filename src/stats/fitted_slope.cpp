#include "stats/fitted_slope.h"

#include <cmath>

namespace carom {

std::optional<SlopeProblem> problem_of(const FittedSlope& fit) {
    constexpr double fewest_pieces = 4.0, straight = 0.1, known = 2.0;
    if (!(fit.pieces >= fewest_pieces)) return SlopeProblem::few_pieces;
    // About the 0.3 % quantile of Student's t: errors from few values are uncertain themselves.
    const double significant = 3.0 * (1.0 + 20.0 / std::pow(fit.values - 1.0, 2));
    const double bend = std::abs(fit.bend.mean);
    if (bend > significant * fit.bend.error && bend > straight * std::abs(fit.slope.mean))
        return SlopeProblem::bends;
    if (!(fit.slope.mean > known * fit.slope.error)) return SlopeProblem::few_pieces;
    return std::nullopt;
}

std::string to_text(Language language, SlopeProblem problem) {
    return problem == SlopeProblem::bends
               ? say(language, "the slope is not constant yet")
               : say(language, "too few measurements are independent of each other");
}

}  // namespace carom
