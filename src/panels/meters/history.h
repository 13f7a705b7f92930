// What a meter has read in the course of a run: a value, from which means over runs and comparisons
// of runs are made.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "panels/means/runs_record.h"
#include "stats/means/measured.h"
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

/// The readings of one run at its samples, and what is known besides. The places are elapsed times.
struct History : Measured {
    std::string name = {};  ///< among compared runs
    Measured frames = {};   ///< readings at the frames that show it: the present of each
    ReferenceLevels levels = {};
    std::vector<double> turns = {};  ///< times of reversals
    std::vector<std::pair<double, std::string>> events =
        {};                          ///< changes of surfaces, and heating: the time and a word
    std::vector<LineLaw> laws = {};  ///< of each line; none of a mean of runs

    /// Adds readings of a moment that is a sample of the run, a frame, or both.
    void add(double moment, const std::vector<double>& readings, bool is_sample, bool is_frame);

    /// The number of samples up to the last of so many frames.
    std::size_t samples_until(std::size_t shown_frames) const;

    /// The readings at these samples and, if it is later, at that frame.
    Measured until(std::size_t shown_frames) const;

    void archive(Archive& archive) {
        Measured::archive(archive);
        archive(name, frames, levels, turns, events, laws);
    }
};

struct HistoryRecord : RunsRecord<History> {
    std::optional<std::size_t> compared =
        {};  ///< index of the only line that represents a run in a comparison; none: all do

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
HistoryRecord mean_of(std::vector<HistoryRecord> records);

/// The record of several compared runs, each under its name.
HistoryRecord compare(std::vector<HistoryRecord> records, const std::vector<std::string>& names);

}  // namespace carom
