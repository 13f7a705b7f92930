// A row of the table of validation: what is known of a number, what independent runs measured, and
// how likely the difference is.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "stats/mean_error.h"

namespace carom::validation {

/// One row: a published or exact value.
struct Truth {
    std::string what;  ///< Markdown, for a table
    double value = 0.0;
    double error = 0.0;     ///< the standard error that was published with it; 0: exact
    double rounding = 0.0;  ///< where there is no chance: how far off the value may be, in units
                            ///< of it; 0 where there is chance
    std::string source;     ///< Markdown: where the value comes from
};

/// What runs have measured of a truth.
struct Row {
    const Truth* truth = nullptr;
    MeanError measured;
    int runs = 0;
    /// How many standard errors it is off: the normal deviate that is as unlikely as Student's t of
    /// so few runs (Wallace, Ann. Math. Stat. 30, 1124, 1959). Where there is no chance 0, or
    /// infinite.
    double z = 0.0;
};

Row row_of(const Truth& truth, const std::vector<double>& values);

/// The |z| that the largest of so many rows exceeds by chance with a probability of 1 %.
double bound_of(std::size_t rows);

}  // namespace carom::validation
