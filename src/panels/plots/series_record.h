// What a panel of quantities against time records of a run: a value, from which means over runs and
// comparisons of runs are made.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "panels/means/runs_record.h"
#include "stats/mean_error.h"
#include "util/archive.h"

namespace carom {

/// A reference level for lines.
struct ReferenceLevel {
    std::string name;  ///< in English
    double value = 0.0;
    double deviation = 0.0;  ///< standard deviation of lines from it; 0: unknown, or none
    std::optional<std::size_t> line = {};  ///< the only line that it is for; none: for all lines
    void archive(Archive& archive) { archive(name, value, deviation, line); }
};

/// Several reference levels; of compared runs, each shows its last.
using ReferenceLevels = std::vector<ReferenceLevel>;

/// What theory says of a line of one run, by the gas of that run.
struct LineLaw {
    std::string reason = {};        ///< why there is no law, in words; empty: there is one
    std::string short_reason = {};  ///< the same in a key, if it may pass in the run
    double value = std::numeric_limits<double>::quiet_NaN();
    void archive(auto& archive) { archive(reason, short_reason, value); }
};

/// The points of one run.
struct SeriesPoints {
    std::vector<double> time = {};                 ///< elapsed
    std::vector<std::vector<double>> lines = {};   ///< line x time; NaN: none
    std::vector<std::vector<double>> errors = {};  ///< standard errors of means over runs, or none
    void archive(auto& archive) { archive(time, lines, errors); }
};

/// The numbers of one run.
struct SeriesRun : SeriesPoints {  ///< at its samples
    SeriesPoints frames = {};      ///< at the frames that show it: the present of each
    ReferenceLevels levels = {};
    std::vector<double> turns = {};  ///< times of reversals
    std::vector<std::pair<double, std::string>> events =
        {};  ///< changes of surfaces, and heating: the time and a word for each
    std::vector<std::vector<MeanError>> numbers = {};  ///< for each line, numbers beyond its points
    std::vector<LineLaw> laws = {};                    ///< of each line; none of a mean of runs
    std::string name = {};                             ///< among compared runs

    void archive(Archive& archive) {
        SeriesPoints::archive(archive);
        archive(frames, levels, turns, events, numbers, laws, name);
    }
};

struct SeriesRecord : RunsRecord<SeriesRun> {  ///< compared runs have one line each
    std::size_t compared = 0;  ///< index of the line that represents a run in a comparison

    /// The common levels of all runs; empty if these differ visibly.
    ReferenceLevels common_levels() const;

    /// The common times of reversals of all runs; empty if these differ.
    std::vector<double> common_turns() const;

    /// The common events of all runs in order of time, with events of the same time joined; empty
    /// if these differ.
    std::vector<std::pair<double, std::vector<std::string>>> common_events() const;

    void archive(Archive& archive) { archive(runs, runs_in_mean, compared); }
};

/// The means of runs with the same frames, with standard errors.
SeriesRecord mean_of(std::vector<SeriesRecord> records);

/// The record of several compared runs: a line for each, under its name.
SeriesRecord compare(std::vector<SeriesRecord> records, const std::vector<std::string>& names);

}  // namespace carom
