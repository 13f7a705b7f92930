#include "panels/plots/histogram_record.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>

#include "draw/axis.h"
#include "stats/mean_error.h"

namespace carom {
namespace {

constexpr int fewest_bins = 12, most_bins_by_rule = 60;

template <class Items, class Number>
MeanError mean_over(const Items& items, const Number& number) {
    std::vector<double> values;
    for (const auto& item : items) values.push_back(number(item));
    return mean_error(values);
}

// A quarter more than 97 of a hundred values of the whole run: 99 of a hundred of a gas in
// equilibrium, whatever the start. Those beyond are counted.
double reach_of(const std::vector<double>& pool) {
    std::vector<double> sizes = pool;
    for (double& size : sizes) size = std::abs(size);
    return sizes.empty() ? 0.0 : 1.25 * quantile(sizes, 0.97);
}

Bins bins_of(const HistogramRecord& record, const HistogramRules& rules) {
    double reach = 0.0;
    std::vector<double> values;
    for (const std::vector<double>& pool : record.pools) {
        reach = std::max(reach, reach_of(pool));
        values.insert(values.end(), pool.begin(), pool.end());
    }
    if (values.empty()) values.push_back(0.0);
    Bins bins;
    if (rules.range) {
        std::tie(bins.low, bins.high) = *rules.range;
    } else {
        bins.high = reach > 0.0 ? round_up_for_axis(reach) : 1.0;
        if (rules.symmetric) bins.low = -bins.high;
    }
    if (rules.bins) {
        bins.count = *rules.bins;
        return bins;
    }
    bins.count = freedman_diaconis(values, record.independent, bins.low, bins.high, fewest_bins,
                                   most_bins_by_rule);
    // Equal values at the start must not lie on an edge, where round-off would deal them out to two
    // bins; nor may 0, where particles at rest are, between two of an even number.
    if (rules.symmetric && bins.count % 2 == 0) ++bins.count;
    const double place = (record.series.front().mean_start - bins.low) / bins.width();
    if (std::abs(place - std::round(place)) < 1e-6) bins.count += rules.symmetric ? 2 : 1;
    return bins;
}

// Of a bar around `value`: where a density is infinite at the first edge its bars are not, and a
// curve through their middles says what they will be.
double expected_share(const HistogramRules& rules, const EquilibriumGas& gas, double value,
                      double width) {
    if (!rules.probability) return width * rules.density(gas, value);
    return rules.probability(gas, value - 0.5 * width, value + 0.5 * width);
}

// The mean of the curves of all runs.
HistogramCurve curve_of(const HistogramSeries& series, const HistogramRules& rules,
                        const Bins& bins) {
    HistogramCurve curve;
    if (!rules.density || series.equilibria.empty()) return curve;
    constexpr int points = 240;  // so that no corners are seen where a curve turns
    const double first = bins.low + (rules.probability ? 0.5 * bins.width() : 0.0);
    for (int i = 0; i <= points; ++i) {
        double part = static_cast<double>(i) / points;
        if (rules.probability) part *= part;  // steep at first
        const double value = first + (bins.high - first) * part;
        double heights = 0.0;
        for (const EquilibriumGas& gas : series.equilibria) {
            double sharing = 0.0;  // infinite masses at rest have no part in the energy
            for (const MassGroup& group : gas.groups) sharing += group.count;
            heights += series.unit * series.values_each * sharing *
                       expected_share(rules, gas, value, bins.width());
        }
        curve.value.push_back(value);
        curve.count.push_back(heights / static_cast<double>(series.equilibria.size()));
    }
    return curve;
}

double top_of(const std::vector<HistogramCurve>& curves) {
    double top = 0.0;
    for (const HistogramCurve& curve : curves)
        for (const double count : curve.count)
            if (std::isfinite(count)) top = std::max(top, count);
    return top;
}

// Room for the bars of most frames and for the whole curve; a start far from equilibrium, all in
// one bin, would flatten everything that follows: such bars are cut with a mark.
double height_of(const HistogramRecord& record, const HistogramRules& rules,
                 const HistogramAxes& axes) {
    const double curve = top_of(axes.curves);
    const bool settles = curve > 0.0 || rules.window != 0.0;  // means are rough at first only
    double bars = 0.0;
    for (std::size_t k = 0; k < record.series.size(); ++k) {
        std::vector<double> tops;
        RunningHistogram running(axes.bins, rules.window);
        for (const HistogramProbe& probe : record.probes[k]) {
            running.add(probe.time, probe.values);
            tops.push_back(record.series[k].unit * std::ranges::max(running.mean().counts));
        }
        if (!tops.empty()) bars = std::max(bars, quantile(tops, settles ? 0.5 : 0.9));
    }
    const double top = curve > 0.0 ? std::clamp(1.1 * bars, 1.2 * curve, 1.4 * curve) : 1.1 * bars;
    const double least = rules.window == 0.0 ? 1.0 : 1e-3;  // a mean number may be far below 1
    return round_up_for_axis(std::max(least, top));
}

}  // namespace

double HistogramRecord::values() const {
    double sum = 0.0;
    for (const HistogramSeries& one : series) sum += one.values();
    return sum;
}

HistogramRecord mean_of(const std::vector<HistogramRecord>& records) {
    HistogramRecord mean = records.front();
    mean.runs = records.size();
    for (const HistogramRecord& one : std::span(records).subspan(1)) {
        std::vector<double>& pool = mean.pools.front();
        pool.insert(pool.end(), one.pools.front().begin(), one.pools.front().end());
    }
    for (std::size_t k = 0; k < mean.series.size(); ++k) {
        HistogramSeries& all = mean.series[k];
        all.mean_start =
            mean_over(records, [k](const auto& run) { return run.series[k].mean_start; }).mean;
        for (const HistogramRecord& run : std::span(records).subspan(1)) {
            const HistogramSeries& one = run.series[k];
            all.lowest_mean = std::min(all.lowest_mean, one.lowest_mean);
            all.highest_mean = std::max(all.highest_mean, one.highest_mean);
            all.equilibria.insert(all.equilibria.end(), one.equilibria.begin(),
                                  one.equilibria.end());
        }
    }
    return mean;
}

HistogramRecord compare(const std::vector<HistogramRecord>& records,
                        const std::vector<std::string>& names) {
    const HistogramRecord& first = records.front();
    HistogramRecord all;
    all.compares = true;
    all.time = first.time;
    all.independent = first.independent;
    bool percent = false;
    for (std::size_t k = 0; k < records.size(); ++k) {
        const HistogramRecord& one = records[k];
        percent |= one.values() != first.values();
        if (one.time != first.time) all.time.clear();
        all.independent = std::min(all.independent, one.independent);
        all.series.push_back(one.series.front());
        all.series.back().name = names[k];
        all.probes.push_back(one.probes.front());
        all.pools.push_back(one.pools.front());
    }
    if (percent)
        for (HistogramSeries& one : all.series) one.unit = 100.0 / one.values();
    return all;
}

HistogramAxes axes_of(const HistogramRecord& record, const HistogramRules& rules) {
    HistogramAxes axes{.bins = bins_of(record, rules),
                       .series = record.series,
                       .curves = {},
                       .runs = record.runs,
                       .time = record.time,
                       .compares = record.compares};
    for (const HistogramSeries& one : record.series)
        axes.curves.push_back(curve_of(one, rules, axes.bins));
    axes.top = height_of(record, rules, axes);
    return axes;
}

bool HistogramAxes::has_curves() const { return top_of(curves) > 0.0; }

bool HistogramAxes::counts_per_cent() const {
    return std::ranges::any_of(series, [](const auto& one) { return one.unit != 1.0; });
}

HistogramCounts mean_of(const std::vector<HistogramCounts>& runs) {
    HistogramCounts mean = runs.front();
    for (std::size_t k = 0; k < mean.series.size(); ++k) {
        MeanHistogram& bars = mean.series[k];
        const auto over_runs = [&](const auto& number) {
            return mean_over(runs, [&](const auto& run) { return number(run.series[k]); });
        };
        const auto mean_of_member = [&](double MeanHistogram::*member) {
            return over_runs([&](const MeanHistogram& run) { return run.*member; }).mean;
        };
        std::vector<double>& errors = mean.errors.emplace_back();
        for (std::size_t i = 0; i < bars.counts.size(); ++i) {
            const MeanError one = over_runs([i](const auto& run) { return run.counts[i]; });
            bars.counts[i] = one.mean;
            errors.push_back(one.error);
        }
        bars.below = mean_of_member(&MeanHistogram::below);
        bars.above = mean_of_member(&MeanHistogram::above);
        bars.mean = mean_of_member(&MeanHistogram::mean);
        const auto square = [&](const MeanHistogram& run) {  // about the mean of all
            return run.deviation * run.deviation + (run.mean - bars.mean) * (run.mean - bars.mean);
        };
        bars.deviation = std::sqrt(over_runs(square).mean);
        bars.values *= static_cast<double>(runs.size());
    }
    return mean;
}

HistogramCounts compare(const std::vector<HistogramCounts>& runs, const HistogramAxes& axes) {
    HistogramCounts all;
    for (std::size_t k = 0; k < runs.size(); ++k) {
        MeanHistogram& one = all.series.emplace_back(runs[k].series.front());
        const double unit = axes.series[k].unit;
        for (double& count : one.counts) count *= unit;
        one.below *= unit;
        one.above *= unit;
    }
    return all;
}

}  // namespace carom
