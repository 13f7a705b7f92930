// A row of the table of validation: the known value of a quantity, what independent runs measured,
// and how likely the difference is.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "stats/means/mean_error.h"

namespace carom::validation {

/// A published or exact value, which makes one row of the table.
struct Truth {
    std::string what;  ///< Markdown, for a table
    double value = 0.0;
    double error = 0.0;     ///< the published standard error; 0: exact
    double rounding = 0.0;  ///< where there is no chance: how far off the value may be, in units
                            ///< of it; 0 where there is chance
    std::string source;     ///< Markdown: where the value comes from
};

/// What the runs have measured for a truth.
struct Row {
    const Truth* truth = nullptr;
    MeanError measured;
    int runs = 0;
    /// The deviation in standard errors: the normal deviate that is as unlikely as Student's t for
    /// this number of runs (Wallace, Ann. Math. Stat. 30, 1124, 1959). For a deterministic quantity
    /// it is 0 within its rounding error, otherwise infinite.
    double z = 0.0;
};

Row row_of(const Truth& truth, const std::vector<double>& values);

/// The |z| that the largest of `rows` rows exceeds by chance with a probability of 1 %.
double bound_of(std::size_t rows);

}  // namespace carom::validation
