// What a panel of readings records of a run: numbers of each frame, of which means over runs and
// comparisons of runs are made.
#pragma once

#include <string>
#include <vector>

#include "util/archive.h"

namespace carom {

/// The numbers of one run.
struct DialRun {
    std::string name = {};                        ///< beside others
    std::vector<std::vector<double>> lines = {};  ///< reading x frame; NaN: none
    /// Of means: the standard errors of the lines; else empty.
    std::vector<std::vector<double>> errors = {};

    void archive(Archive& archive) { archive(name, lines, errors); }
};

struct DialRecord {
    std::vector<DialRun> runs = {{}};  ///< one, or those side by side
    int runs_in_mean = 1;

    bool compares() const { return runs.size() > 1; }
    void archive(Archive& archive) { archive(runs, runs_in_mean); }
};

/// Of runs with the same frames; of those that have a number at a frame.
DialRecord mean_of(const std::vector<DialRecord>& records);

/// All readings of each, named.
DialRecord compare(std::vector<DialRecord> records, const std::vector<std::string>& names);

}  // namespace carom
