// The page of validation, docs/validation.md.
#pragma once

#include <numeric>
#include <string>
#include <vector>

#include "validation/study.h"

namespace carom::validation {

/// A study and what its runs gave.
struct Measured {
    Study study;
    std::vector<std::vector<double>> values;  ///< for each run, one number per truth
    std::vector<double> seconds;              ///< CPU seconds of each run
    std::vector<Row> rows = {};

    void find_rows();
    double all_seconds() const { return std::accumulate(seconds.begin(), seconds.end(), 0.0); }
};

/// The known value with its error, and the measured one, to the digits that are significant given
/// its error.
std::string known_of(const Truth& truth, const Row& row);
std::string measured_of(const Row& row);

/// The largest |z| that passes, and the cost of the measurements.
struct Effort {
    double bound = 0.0;
    double seconds = 0.0;            ///< wall time
    double processor_seconds = 0.0;  ///< CPU time of all threads together
    unsigned threads = 1;
};

/// Writes the page. `figures`: the file captions.json of the figures that the page shows, which are
/// in the folder validation/ next to it; "": no figures.
void write_page(const std::string& path, const std::string& figures,
                const std::vector<Measured>& studies, const Effort& effort);

}  // namespace carom::validation
