// What a panel of dials records of a run: numbers of each frame and sample, from which means over
// runs and comparisons of runs are made.
#pragma once

#include <string>
#include <vector>

#include "panels/means/runs_record.h"
#include "util/archive.h"

namespace carom {

/// The numbers of one run.
struct DialRun {
    std::string name = {};                        ///< among compared runs
    std::vector<std::vector<double>> lines = {};  ///< reading x frame; NaN: none
    /// Standard errors of the lines, if they are means over runs; otherwise empty.
    std::vector<std::vector<double>> errors = {};
    /// The readings at the samples of the run, which determine the scale, and their errors.
    std::vector<std::vector<double>> sampled = {}, sampled_errors = {};

    void archive(Archive& archive) { archive(name, lines, errors, sampled, sampled_errors); }
};

using DialRecord = RunsRecord<DialRun>;

/// Returns the mean of runs with the same frames; at each frame, of the runs that have a number
/// there.
DialRecord mean_of(const std::vector<DialRecord>& records);

}  // namespace carom
