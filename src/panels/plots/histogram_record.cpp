#include "panels/plots/histogram_record.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>

#include "draw/axis.h"
#include "stats/means/measured.h"

namespace carom {
namespace {

constexpr int fewest_bins = 12, most_bins_by_rule = 60;

// Indices of the numbers of a series beside its bars; the mean square is that about the mean.
enum HistogramNumber : std::size_t { of_mean, of_mean_square, of_below, of_above };

Measured measured_of(const HistogramCounts& counts) {
    Measured all;
    for (const MeanHistogram& one : counts.series) {
        all.y.push_back(one.counts);
        all.numbers.push_back({{one.mean, NAN},
                               {one.deviation * one.deviation, NAN},
                               {one.below, NAN},
                               {one.above, NAN}});
    }
    return all;
}

// 1.25 times the 97 % quantile of the magnitudes in the whole run. This holds 99 % of the values of
// a gas in equilibrium, whatever its start; the values beyond are counted.
double reach_of(const std::vector<double>& pool) {
    std::vector<double> sizes = pool;
    for (double& size : sizes) size = std::abs(size);
    return sizes.empty() ? 0.0 : 1.25 * quantile(sizes, 0.97);
}

// The distinct values of all series at the start if there are only a few, as for beams or a gas at
// rest; otherwise empty.
std::vector<double> equal_starts(const HistogramRecord& record) {
    constexpr std::size_t most = 3;
    std::vector<double> values;
    for (const auto& probes : record.probes) {
        if (probes.empty()) continue;
        for (const double value : probes.front().values) {
            const auto is_near = [&](double other) { return std::abs(value - other) < 1e-9; };
            if (!std::isfinite(value) || std::ranges::any_of(values, is_near)) continue;
            values.push_back(value);
            if (values.size() > most) return {};
        }
    }
    return values;
}

bool is_whole(double number) { return std::abs(number - std::round(number)) < 1e-6; }

// The requirements for bins of a round width.
struct WantedBins {
    double low, high, width;
    bool is_fixed, is_symmetric;  // a fixed range is filled by whole bins
    std::vector<double> starts;
    double tick_step;
};

// Bins of this width with an edge (offset 0) or the middle of a bin (0.5) at 0; none if they do not
// fit.
std::optional<Bins> bins_of_width(const WantedBins& wanted, double width, double offset) {
    Bins bins{.low = wanted.low, .high = wanted.high};
    if (wanted.is_fixed) {
        if (!is_whole(bins.low / width - offset) || !is_whole(bins.high / width - offset))
            return {};
    } else {
        bins.high = (std::ceil(wanted.high / width - offset - 1e-6) + offset) * width;
        if (wanted.is_symmetric) bins.low = -bins.high;
    }
    bins.count = static_cast<int>(std::lround((bins.high - bins.low) / width));
    if (bins.count < fewest_bins || bins.count > most_bins_by_rule) return {};
    return bins;
}

// The penalty of bins relative to the requirements; none if equal values at the start are on an
// edge, where round-off would distribute them over two bins.
std::optional<double> misfit(const WantedBins& wanted, const Bins& bins, double offset) {
    constexpr double ticks_off_edges = 1.0, start_off_middle = 1.2, ticks_at_middles = 0.2;
    double sum = std::abs(std::log2(bins.width() / wanted.width));
    if (!is_whole(wanted.tick_step / bins.width())) sum += ticks_off_edges;
    if (offset != 0.0) sum += ticks_at_middles;
    bool is_off_middle = false;
    for (const double start : wanted.starts) {
        const double place = (start - bins.low) / bins.width();
        if (place < 1e-6 || start > bins.high) continue;
        if (is_whole(place)) return {};
        is_off_middle |= !is_whole(place - 0.5);
    }
    return is_off_middle ? sum + start_off_middle : sum;
}

// Bins of a round width, preferably with edges or middles on the ticks of the axis and with the
// values of equal starts in the middle of a bin.
std::optional<Bins> round_bins(const WantedBins& wanted) {
    std::optional<Bins> best;
    double least = 1e9;
    const int exponent = static_cast<int>(std::floor(std::log10(wanted.width)));
    for (int power = exponent - 1; power <= exponent + 1; ++power)
        for (const auto& [digits, is_less_round] : {std::pair{1.0, 0.0},
                                                    {2.0, 0.0},
                                                    {5.0, 0.0},
                                                    {2.5, 0.1},
                                                    {4.0, 0.1},
                                                    {8.0, 0.2},
                                                    {1.6, 0.3}})
            for (const double offset : {0.0, 0.5}) {
                if (offset != 0.0 && !wanted.is_symmetric) continue;
                const auto bins = bins_of_width(wanted, digits * std::pow(10.0, power), offset);
                if (!bins) continue;
                const std::optional<double> its = misfit(wanted, *bins, offset);
                if (!its || *its + is_less_round >= least) continue;
                least = *its + is_less_round;
                best = bins;
            }
    return best;
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
        bins.high = round_up_for_axis(reach);
        if (rules.symmetric) bins.low = -bins.high;
    }
    if (rules.bins) {
        bins.count = *rules.bins;
        return bins;
    }
    bins.count = freedman_diaconis(values, record.independent, bins.low, bins.high, fewest_bins,
                                   most_bins_by_rule);
    const std::vector<TickMark> marks = ticks(bins.low, bins.high);
    const WantedBins wanted{
        .low = bins.low,
        .high = bins.high,
        .width = bins.width(),
        .is_fixed = rules.range.has_value(),
        .is_symmetric = rules.symmetric,
        .starts = equal_starts(record),
        .tick_step = marks.size() > 1 ? marks[1].value - marks[0].value : bins.high};
    if (const std::optional<Bins> round = round_bins(wanted)) return *round;
    // A range that no round width fills: 0, the value of particles at rest, must not be on an edge.
    if (rules.symmetric && bins.count % 2 == 0) ++bins.count;
    const double place = (record.series.front().mean_start - bins.low) / bins.width();
    if (is_whole(place)) bins.count += rules.symmetric ? 2 : 1;
    return bins;
}

// The expected share of a bar around `value`. If the density is infinite at the first edge, bars
// are still finite, and the curve through their middles shows their expected height.
double expected_share(const HistogramRules& rules, const EquilibriumGas& gas, double value,
                      double width) {
    if (!rules.probability) return width * rules.density(gas, value);
    return rules.probability(gas, value - 0.5 * width, value + 0.5 * width);
}

// The mean of the equilibrium curves of all runs.
HistogramCurve curve_of(const HistogramSeries& series, const HistogramRules& rules,
                        const Bins& bins) {
    HistogramCurve curve;
    for (const auto& [value, share] : rules.shares) {
        const double distance = rules.shares[1].first - rules.shares[0].first;
        curve.value.push_back(value);
        curve.count.push_back(series.unit * series.values() * share * bins.width() / distance);
    }
    if (!rules.density || series.equilibria.empty()) return curve;
    constexpr int points = 240;  // so that no corners are seen where a curve turns
    const double first = bins.low + (rules.probability ? 0.5 * bins.width() : 0.0);
    for (int i = 0; i <= points; ++i) {
        double part = static_cast<double>(i) / points;
        if (rules.probability) part *= part;  // steep at first
        const double value = first + (bins.high - first) * part;
        double heights = 0.0;
        for (const EquilibriumGas& gas : series.equilibria) {
            double sharing = 0.0;  // infinite masses at rest do not share the energy
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

struct TallestBars {
    std::vector<double> by_time;  // for each probe, in order of time
    std::vector<double> by_bar;
    std::vector<HistogramCurve> by_series;  // of each bar
};

// The tallest bars of all series; with only_last, only those of the last probes.
TallestBars tallest_bars(const HistogramRecord& record, const HistogramRules& rules,
                         const HistogramAxes& axes) {
    std::vector<double> tallest, highest(std::size_t(axes.bins.count), 0.0);
    double of_last = 0.0;
    std::vector<HistogramCurve> outlines(record.series.size());
    for (HistogramCurve& outline : outlines)
        for (int i = 0; i < axes.bins.count; ++i) {
            outline.value.push_back(0.5 * (axes.bins.edge(i) + axes.bins.edge(i + 1)));
            outline.count.push_back(0.0);
        }
    const auto raise = [&](std::size_t k, const std::vector<double>& counts, double unit) {
        for (std::size_t i = 0; i < highest.size(); ++i) {
            highest[i] = std::max(highest[i], unit * counts[i]);
            outlines[k].count[i] = std::max(outlines[k].count[i], unit * counts[i]);
        }
    };
    for (std::size_t k = 0; k < record.series.size(); ++k) {
        RunningHistogram running(axes.bins, rules.window);
        double bar = 0.0;
        for (std::size_t i = 0; i < record.probes[k].size(); ++i) {
            const HistogramProbe& probe = record.probes[k][i];
            const double last = record.probes[k].back().time;
            if (rules.only_last && rules.window && probe.time < last - *rules.window)
                continue;  // the first one, before the time of the mean
            running.add(probe.time, probe.values);
            const double unit = record.series[k].unit * probe.stands_for;
            const std::vector<double> counts = running.mean().counts;
            bar = unit * std::ranges::max(counts);
            if (!rules.only_last || i + 1 == record.probes[k].size()) raise(k, counts, unit);
            tallest.resize(std::max(tallest.size(), i + 1));
            tallest[i] = std::max(tallest[i], bar);
        }
        of_last = std::max(of_last, bar);
    }
    return {rules.only_last ? std::vector{of_last} : std::move(tallest), std::move(highest),
            std::move(outlines)};
}

// The height of the axis holds the whole curve and the bars of the second half of the run with
// their fluctuations; earlier bars too if they are not much taller. A start far from equilibrium
// with all values in one bin, or a return to it, would flatten everything else: such bars
// fade out.
double height_of(const std::vector<double>& tallest, const HistogramRules& rules,
                 const HistogramAxes& axes) {
    constexpr double over_bars = 1.1, over_curve = 1.2, most_of_settled = 1.6;
    const auto half = tallest.begin() + std::ssize(tallest) / 2;
    std::vector<double> later(half, tallest.end());
    const double usual = later.empty() ? 0.0 : quantile(later, 0.5);
    double settled = over_curve * top_of(axes.curves), all = settled;
    for (const double bar : tallest) all = std::max(all, over_bars * bar);
    for (const double bar : later)
        if (bar <= 2.0 * usual) settled = std::max(settled, over_bars * bar);
    const double least = rules.window == 0.0 ? 1.0 : 1e-3;  // a mean number may be far below 1
    return round_up_for_axis(std::max(least, all <= most_of_settled * settled ? all : settled));
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
        std::vector<double> starts;
        for (const HistogramRecord& run : records) starts.push_back(run.series[k].mean_start);
        all.mean_start = mean_error(starts).mean;
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
    TallestBars tallest = tallest_bars(record, rules, axes);
    axes.top = height_of(tallest.by_time, rules, axes);
    axes.highest = std::move(tallest.by_bar);
    axes.outlines = std::move(tallest.by_series);
    return axes;
}

bool HistogramAxes::has_curves() const { return top_of(curves) > 0.0; }

bool HistogramAxes::counts_per_cent() const {
    return std::ranges::any_of(series, [](const auto& one) { return one.unit != 1.0; });
}

HistogramCounts mean_of(const std::vector<HistogramCounts>& runs) {
    std::vector<Measured> of_runs;
    std::vector<const Measured*> pointers;
    for (const HistogramCounts& run : runs) of_runs.push_back(measured_of(run));
    for (const Measured& run : of_runs) pointers.push_back(&run);
    const Measured all = mean_of(pointers);
    HistogramCounts mean = runs.front();
    mean.errors = all.error;
    mean.mean_errors.clear();
    for (std::size_t k = 0; k < mean.series.size(); ++k) {
        MeanHistogram& bars = mean.series[k];
        bars.counts = all.y[k];
        bars.below = all.numbers[k][of_below].mean;
        bars.above = all.numbers[k][of_above].mean;
        bars.mean = all.numbers[k][of_mean].mean;
        mean.mean_errors.push_back(all.numbers[k][of_mean].error);
        // The mean square about the mean of all: within the runs, and of their means.
        const auto with_values = static_cast<double>(std::ranges::count_if(
            runs, [k](const auto& run) { return std::isfinite(run.series[k].mean); }));
        const double error = with_values > 1.0 ? all.numbers[k][of_mean].error : 0.0;
        bars.deviation =
            std::sqrt(all.numbers[k][of_mean_square].mean + (with_values - 1.0) * error * error);
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
