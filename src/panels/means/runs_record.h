// What a panel records of a run, of the mean of several runs that differ only in their seeds, or of
// several runs that are compared; and how means and comparisons are made of these.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "stats/mean_error.h"
#include "util/language.h"

namespace carom {

/// The record of a run, of the mean of several, or of several compared ones. `Run` is what is
/// recorded of one, with its `name` among compared runs.
template <class Run>
struct RunsRecord {
    std::vector<Run> runs = {{}};  ///< one, or the compared runs
    int runs_in_mean = 1;

    bool compares() const { return runs.size() > 1; }
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

/// Rows of numbers, such as a row for each line of a plot.
using NumberRows = std::vector<std::vector<double>>;

/// Takes the means of rows of numbers over runs, and their standard errors: over those runs that
/// have a number, which is not NaN. `rows_of(record)`: the rows of a run, of the same sizes in all.
template <class Record, class RowsOf>
void take_means(const std::vector<Record>& records, const RowsOf& rows_of, NumberRows& means,
                NumberRows& errors) {
    NumberRows mean = rows_of(records.front()), error = mean;
    std::vector<double> of_each(records.size());
    for (std::size_t row = 0; row < mean.size(); ++row)
        for (std::size_t k = 0; k < mean[row].size(); ++k) {
            for (std::size_t run = 0; run < records.size(); ++run)
                of_each[run] = rows_of(records[run]).at(row).at(k);
            const MeanError all = mean_error(of_each);
            mean[row][k] = all.mean;
            error[row][k] = all.error;
        }
    means = std::move(mean);
    errors = std::move(error);
}

/// "mean of 5 runs"; empty for one run.
std::string words_of_mean(Language language, int runs);

}  // namespace carom
