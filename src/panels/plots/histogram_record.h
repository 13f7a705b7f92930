// What a histogram knows of a run before anything is drawn, as plain values: what the first pass
// recorded, the axes and curves that are fixed by it, and the counts of one time. Those of several
// runs are combined, as means or for a comparison, before axes are fixed and before they are drawn.
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
    double values_each = 1.0;  ///< of one particle at a time
    double unit = 1.0;         ///< what one value counts: 1, or a share in per cent
    double mean_start = 0.0;
    double lowest_mean = 0.0, highest_mean = 0.0;  ///< of the whole run, that at the start too
    std::vector<EquilibriumGas> equilibria = {};   ///< of each run that comes to one

    double values() const { return particles * values_each; }  ///< at a time

    void archive(auto& archive) {
        archive(name, particles, values_each, unit, mean_start, lowest_mean, highest_mean,
                equilibria);
    }
};

/// What is expected in equilibrium, or fitted.
struct HistogramCurve {
    std::vector<double> value;
    std::vector<double> count;  ///< expected in a bin around it
    bool empty() const { return value.empty(); }
    void archive(auto& archive) { archive(value, count); }
};

/// A sample of a series, for the height of bars: whole, or of very many values evenly thinned.
struct HistogramProbe {
    double time = 0.0;
    Eigen::ArrayXd values;
    double stands_for = 1.0;  ///< values, each of these; the same in all probes of a series
};

/// What the first pass recorded of a run, or of several.
struct HistogramRecord {
    std::vector<HistogramSeries> series;
    std::vector<std::vector<HistogramProbe>> probes;  ///< of each series, at a few frames, the
                                                      ///< first among them
    std::vector<std::vector<double>> pools;  ///< values of all frames, thinned; one for each run
                                             ///< that is compared
    double independent = 0.0;  ///< values in the bars of one series at the end of the film,
                               ///< roughly; of the run with the fewest
    std::size_t runs = 1;      ///< whose mean the bars show
    std::string time;          ///< "at time 20"; empty where runs that are compared differ in it
    bool compares = false;

    double values() const;  ///< of all series, at a time
};

/// The record of the mean of several runs that differ in their seeds. Requires one at least.
HistogramRecord mean_of(const std::vector<HistogramRecord>& records);

/// The record of several runs of one series each, side by side under these names. Bars of runs with
/// different numbers of values are comparable as shares only: they count per cent.
HistogramRecord compare(const std::vector<HistogramRecord>& records,
                        const std::vector<std::string>& names);

/// How a scene and a tested quantity fix the axes.
struct HistogramRules {
    std::optional<std::pair<double, double>> range = {};  ///< none: as the run shows
    std::optional<int> bins = {};
    bool symmetric = false;              ///< about 0; else values are never negative
    std::optional<double> window = 0.0;  ///< of the means, in time; none: from the start
    bool only_last = false;  ///< of each series what its last probe ends is all that is shown
    std::function<double(const EquilibriumGas&, double value)> density = {};  ///< none: no curves
    std::function<double(const EquilibriumGas&, double low, double high)> probability =
        {};  ///< of a value in between; wanted where the density is not finite
};

/// What is the same for a whole film, or for all runs of a figure.
struct HistogramAxes {
    Bins bins;
    double top = 1.0;  ///< of the vertical axis, which begins at 0
    std::vector<HistogramSeries> series;
    std::vector<HistogramCurve> curves;  ///< of each series; or empty ones
    std::size_t runs = 1;                ///< these three as in the record
    std::string time;
    bool compares = false;

    bool has_curves() const;
    bool counts_per_cent() const;  ///< else each bar counts values

    void archive(auto& archive) { archive(bins, top, series, curves, runs, time, compares); }
};

HistogramAxes axes_of(const HistogramRecord& record, const HistogramRules& rules);

/// What a histogram shows at one time.
struct HistogramCounts {
    std::vector<MeanHistogram> series;
    std::vector<std::vector<double>> errors = {};  ///< of the bars of each series, where they are
                                                   ///< means of several runs
    void archive(auto& archive) { archive(series, errors); }
};

/// Means over runs, with their standard errors. Requires one at least.
HistogramCounts mean_of(const std::vector<HistogramCounts>& runs);

/// The counts of several runs of one series each, in the units of `axes`.
HistogramCounts compare(const std::vector<HistogramCounts>& runs, const HistogramAxes& axes);

}  // namespace carom
