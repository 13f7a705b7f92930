// Whether the slope of a line that is fitted to a measured curve is known, and the curve straight.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "stats/means/mean_error.h"
#include "util/language.h"

namespace carom {

/// The slope of a line fitted to a curve, with standard errors from independent pieces of a run or
/// from several runs.
struct FittedSlope {
    MeanError slope;
    MeanError bend;       ///< the slope in the second half of the fit less that in the first
    double pieces = 0.0;  ///< number of independent pieces, in all runs
    double values = 0.0;  ///< number of pieces or runs whose scatter gives the errors
};

enum class SlopeProblem : std::uint8_t {
    few_pieces,  ///< too few for an error, or the error is more than half of the slope
    bends        ///< by more than a tenth of the slope, and significantly
};

/// Why the slope of a curve whose limit is a positive slope must not be given; nothing if it may.
std::optional<SlopeProblem> problem_of(const FittedSlope& fit);

/// The reason in words, as the end of a sentence.
std::string to_text(Language language, SlopeProblem problem);

}  // namespace carom
