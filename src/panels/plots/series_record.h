// What a panel of numbers against time records of a run: a value, of which means over runs and
// comparisons of runs are made.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "stats/mean_error.h"
#include "util/archive.h"

namespace carom {

/// A level that lines are compared with.
struct ReferenceLevel {
    std::string name;  ///< in English
    double value = 0.0;
    double deviation = 0.0;  ///< that lines should have from it; 0: not known, or none
    void archive(Archive& archive) { archive(name, value, deviation); }
};

/// Several; of runs side by side each shows its last.
using ReferenceLevels = std::vector<ReferenceLevel>;

/// The numbers of one run.
struct SeriesRun {
    std::vector<double> time;                      ///< of each frame, elapsed
    std::vector<std::vector<double>> lines;        ///< line x frame; NaN: none
    std::vector<std::vector<double>> errors = {};  ///< standard errors of means over runs, or none
    ReferenceLevels levels = {};
    std::vector<double> turns = {};  ///< times of reversals
    std::vector<std::pair<double, std::string>> events =
        {};  ///< what happens to surfaces, and heat: times and a word each
    std::vector<std::vector<MeanError>> numbers = {};  ///< of each line, beyond its points
    std::string name = {};                             ///< beside others

    void archive(Archive& archive) {
        archive(time, lines, errors, levels, turns, events, numbers, name);
    }
};

struct SeriesRecord {
    std::vector<SeriesRun> runs = {{}};  ///< one, or those side by side, a line of each
    int runs_in_mean = 1;
    std::size_t compared = 0;  ///< the line that stands for a run beside others

    bool compares() const { return runs.size() > 1; }

    /// The levels of all runs, or none where they differ in what a reader sees of them.
    ReferenceLevels common_levels() const;

    /// The reversals of all runs, or none where they differ.
    std::vector<double> common_turns() const;

    /// The events of all runs, in order of time, those of one time together; none where they
    /// differ.
    std::vector<std::pair<double, std::vector<std::string>>> common_events() const;

    void archive(Archive& archive) { archive(runs, runs_in_mean, compared); }
};

/// Of runs with the same frames: their means with standard errors.
SeriesRecord mean_of(std::vector<SeriesRecord> records);

/// A line of each, named.
SeriesRecord compare(std::vector<SeriesRecord> records, const std::vector<std::string>& names);

}  // namespace carom
