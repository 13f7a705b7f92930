// The data of a histogram as plain values, before anything is drawn: the record of the first pass,
// the axes and curves that are fixed from it, and the counts at one time. Records of several runs
// are combined, as means or for a comparison, before axes are fixed; counts are combined before
// they are drawn.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "physics/theory/theory.h"
#include "stats/running_histogram.h"

namespace carom {

/// The values of one choice of particles, or of one of several runs that are compared.
struct HistogramSeries {
    std::string name;
    double particles = 0.0;
    double values_each = 1.0;  ///< number of values per particle and time
    double unit = 1.0;         ///< what one value adds to a bar: 1, or a share in per cent
    double mean_start = 0.0;
    double lowest_mean = 0.0, highest_mean = 0.0;  ///< in the whole run, its start included
    std::vector<EquilibriumGas> equilibria = {};   ///< of each run that has one

    double values() const { return particles * values_each; }  ///< at a time

    void archive(auto& archive) {
        archive(name, particles, values_each, unit, mean_start, lowest_mean, highest_mean,
                equilibria);
    }
};

/// A curve that is expected in equilibrium, or fitted.
struct HistogramCurve {
    std::vector<double> value;
    std::vector<double> count;  ///< expected count in a bin around the value
    bool empty() const { return value.empty(); }
    void archive(auto& archive) { archive(value, count); }
};

/// The values of a series at one time, from which the height of bars is estimated; very many values
/// are thinned evenly.
struct HistogramProbe {
    double time = 0.0;
    Eigen::ArrayXd values;
    double stands_for = 1.0;  ///< number of values that each kept one represents; the same in all
                              ///< probes of a series
};

/// What the first pass recorded of a run, or of several.
struct HistogramRecord {
    std::vector<HistogramSeries> series;
    /// For each series, at a few frames including the first.
    std::vector<std::vector<HistogramProbe>> probes;
    /// Thinned values of all frames; one pool for each compared run.
    std::vector<std::vector<double>> pools;
    double independent = 0.0;  ///< rough number of independent values in the bars of one series at
                               ///< the end of the film; of the run with the fewest
    std::size_t runs = 1;      ///< number of runs whose mean the bars show
    std::string time;          ///< "at time 20"; empty if compared runs differ in it
    bool compares = false;

    double values() const;  ///< number of values of all series at one time
};

/// The record of the mean of runs that differ only in their seeds. Requires at least one.
HistogramRecord mean_of(const std::vector<HistogramRecord>& records);

/// The record of several compared runs of one series each, under these names. Runs with different
/// numbers of values are comparable as shares only: their bars count per cent.
HistogramRecord compare(const std::vector<HistogramRecord>& records,
                        const std::vector<std::string>& names);

/// What the scene and the quantity prescribe for the axes.
struct HistogramRules {
    std::optional<std::pair<double, double>> range = {};  ///< none: determined from the run
    std::optional<int> bins = {};
    bool symmetric = false;              ///< about 0; else values are never negative
    std::optional<double> window = 0.0;  ///< averaging time; none: from the start
    bool only_last = false;  ///< only the mean that ends with each series' last probe is shown
    std::function<double(const EquilibriumGas&, double value)> density = {};  ///< none: no curves
    std::function<double(const EquilibriumGas&, double low, double high)> probability =
        {};  ///< of a value between `low` and `high`; needed if the density is not finite
             ///< everywhere
    /// Instead: values at equal distances and their shares.
    std::vector<std::pair<double, double>> shares = {};
};

/// What is the same for a whole film, or for all runs of a figure.
struct HistogramAxes {
    Bins bins;
    double top = 1.0;                  ///< of the vertical axis, which begins at 0
    std::vector<double> highest = {};  ///< of each bar, of all series, in the whole film
    std::vector<HistogramSeries> series;
    std::vector<HistogramCurve> curves;  ///< for each series; may be empty
    /// Where each series has its highest bars: the height that each bar has reached, at its middle.
    std::vector<HistogramCurve> outlines = {};
    std::size_t runs = 1;  ///< this and the next two as in the record
    std::string time;
    bool compares = false;

    bool has_curves() const;
    bool counts_per_cent() const;  ///< otherwise each bar counts values

    void archive(auto& archive) {
        archive(bins, top, highest, series, curves, outlines, runs, time, compares);
    }
};

HistogramAxes axes_of(const HistogramRecord& record, const HistogramRules& rules);

/// What a histogram shows at one time.
struct HistogramCounts {
    std::vector<MeanHistogram> series;
    /// Standard errors of the bars of each series, if they are means of several runs.
    std::vector<std::vector<double>> errors = {};
    std::vector<double> mean_errors = {};  ///< of the mean of the values of each series
    void archive(auto& archive) { archive(series, errors, mean_errors); }
};

/// Means over runs, with their standard errors. Requires at least one run.
HistogramCounts mean_of(const std::vector<HistogramCounts>& runs);

/// The counts of several runs of one series each, in the units of `axes`.
HistogramCounts compare(const std::vector<HistogramCounts>& runs, const HistogramAxes& axes);

}  // namespace carom
