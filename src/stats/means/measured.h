// What an instrument has measured of a run, as a value: numbers of its lines at the same places,
// and further numbers of each line. Means over runs are made of such values. Units are those of
// what is measured.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "stats/means/mean_error.h"

namespace carom {

/// Rows of numbers, such as a row for each line of a plot.
using NumberRows = std::vector<std::vector<double>>;

/// The numbers of some lines: readings at moments of a run, a curve at distances or time lags, or
/// bins between edges.
struct Measured {
    std::vector<double> x = {};  ///< the places, or one more edge than bins; empty: without places
    NumberRows y = {};           ///< of each line, at each place or in each bin; NaN: none
    NumberRows error = {};       ///< standard errors of `y`; empty, or an empty row: unknown
    std::vector<std::vector<MeanError>> numbers = {};  ///< of each line: what its meter gives
                                                       ///< beside them

    /// Adds readings of all lines at one more moment.
    void add(double moment, const std::vector<double>& readings);

    std::size_t bytes() const;  ///< that the numbers take

    void archive(auto& archive) { archive(x, y, error, numbers); }
};

/// The means of what was measured at the same places of runs that differ only in their seeds, with
/// standard errors: at each place over those runs that have a number there. Requires at least one
/// run, and the same lines and places in all.
Measured mean_of(std::span<const Measured* const> runs);

}  // namespace carom
