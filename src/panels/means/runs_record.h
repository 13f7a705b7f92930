// What a panel records of a run, of the mean of several runs that differ only in their seeds, or of
// several runs that are compared; and how means and comparisons are made of these.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "util/language.h"

namespace carom {

/// The record of a run, of the mean of several, or of several compared ones. `Run` is what is
/// recorded of one, with its `name` among compared runs.
template <class Run>
struct RunsRecord {
    std::vector<Run> runs = {{}};  ///< one, or the compared runs
    int runs_in_mean = 1;

    bool compares() const { return runs.size() > 1; }

    /// The names of compared runs.
    std::vector<std::string> names() const {
        std::vector<std::string> all;
        for (const Run& run : runs) all.push_back(run.name);
        return all;
    }
    void archive(auto& archive) { archive(runs, runs_in_mean); }
};

template <class Record>
concept OfRuns = requires(Record record) {
    record.runs.front().name = std::string();
    record.runs_in_mean = 1;
};

/// The record of several compared runs, each under its name. Requires records of one run each.
template <OfRuns Record>
Record compare(std::vector<Record> records, const std::vector<std::string>& names) {
    Record all = records.front();
    all.runs.clear();
    for (std::size_t k = 0; k < records.size(); ++k) {
        all.runs.push_back(std::move(records[k].runs.front()));
        all.runs.back().name = names[k];
    }
    return all;
}

/// The first record as that of a mean of all, whose numbers are still to be averaged.
template <OfRuns Record>
Record begun_mean(const std::vector<Record>& records) {
    Record mean = records.front();
    mean.runs_in_mean = static_cast<int>(records.size());
    return mean;
}

/// "mean of 5 runs"; empty for one run.
std::string words_of_mean(Language language, int runs);

}  // namespace carom
