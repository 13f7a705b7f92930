// What a histogram shows: its bins, heights, curves and states. How it is drawn is in
// histogram_drawing.cpp, how it shows several runs in histogram_runs.cpp, how well it fits in
// histogram_test.cpp.
#include "panels/plots/histogram_panel.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "panels/chosen.h"
#include "panels/plots/comparison.h"
#include "panels/plots/histogram_state.h"
#include "stats/histogram.h"

namespace carom {
namespace {

constexpr std::size_t pool_size = 200'000;  // values kept of the whole run, for ranges and bins
constexpr int probe_frames = 40;            // frames whose bars decide the height of the axis
constexpr int fewest_bins = 12, most_bins_by_rule = 60;

double finite_mean(const Eigen::ArrayXd& values) {
    const auto finite = values.isFinite();
    return finite.any() ? finite.select(values, 0.0).sum() / static_cast<double>(finite.count())
                        : 0.0;
}

}  // namespace

HistogramPanel::HistogramPanel(const PanelContext& context, const PanelSpec& spec,
                               HistogramSubject subject)
    : context_(context), spec_(spec), subject_(std::move(subject)) {
    for (const Chosen& chosen : choices(spec)) {
        Series series{.chosen = chosen, .members = members(context, chosen)};
        const bool all = !chosen.species && !chosen.particle;
        if (context.equilibrium)
            series.equilibrium =
                all ? context.equilibrium
                    : among(*context.equilibrium, context.particles, series.members);
        series_.push_back(std::move(series));
    }
    own_ = series_.size();
}

const std::vector<MeanHistogram>& HistogramPanel::histograms(const PanelState& state) {
    return static_cast<const HistogramState&>(state).histograms;
}

const std::vector<std::vector<double>>& HistogramPanel::errors(const PanelState& state) {
    return static_cast<const HistogramState&>(state).errors;
}

Eigen::ArrayXd HistogramPanel::values_of(const Series& series, const Eigen::ArrayXXd& all) const {
    const Eigen::ArrayXXd rows = all(series.members, Eigen::all);
    return rows.reshaped();
}

// Nothing: over all samples since the start.
std::optional<double> HistogramPanel::window() const {
    const Over over = spec_.over.value_or(Over{});
    if (over.since == Over::Since::start) return std::nullopt;
    return over.window;
}

double HistogramPanel::numbers_at_a_time() const {
    double sum = 0.0;
    for (const Series& one : series_) sum += static_cast<double>(one.members.size());
    return sum * numbers_each_;
}

// How many independent numbers the bars of a choice will show at the end of the film, roughly:
// frames that follow one another show nearly the same.
double HistogramPanel::numbers_in_bars() const {
    const std::optional<double> back = window();
    const double share = !back ? 1.0 : span_ > 0.0 ? std::min(1.0, *back / span_) : 0.0;
    return numbers_at_a_time() / static_cast<double>(series_.size()) *
           std::max(1.0, share * context_.frames / 10.0);
}

void HistogramPanel::survey(const FrameInput& input) {
    const Eigen::ArrayXXd all = subject_.values(input);
    numbers_each_ = static_cast<double>(all.cols());
    span_ = input.tick.time;
    const double numbers = numbers_at_a_time();
    const auto stride = std::max<Eigen::Index>(
        1, static_cast<Eigen::Index>(numbers * context_.frames / static_cast<double>(pool_size)));
    // Bars of a few particles over a while are as rough as their probes are few.
    const int probes = window() == 0.0
                           ? probe_frames
                           : static_cast<int>(std::clamp(pool_size / numbers, double(probe_frames),
                                                         std::max(40.0, double(context_.frames))));
    const bool probe = surveyed_ % std::max(1, context_.frames / probes) == 0;
    for (Series& one : series_) {
        const Eigen::ArrayXd values = values_of(one, all);
        const double mean = finite_mean(values);
        if (surveyed_ == 0) one.mean_start = one.lowest_mean = one.highest_mean = mean;
        one.lowest_mean = std::min(one.lowest_mean, mean);
        one.highest_mean = std::max(one.highest_mean, mean);
        for (Eigen::Index i = surveyed_ % stride; i < values.size(); i += stride)
            if (std::isfinite(values[i])) pool_.push_back(values[i]);  // moving infinite masses
        if (probe) one.probes.push_back({input.tick.time, values});
    }
    ++surveyed_;
}

void HistogramPanel::fix_axes() {
    choose_bins(reach(), numbers_in_bars());
    choose_curves();
    finish();
    for (const Series& one : series_)
        if (spec_.test) require_testable(one);
}

void HistogramPanel::finish() {
    choose_height();
    pool_ = {};
    for (Series& one : series_) {
        one.probes = {};
        one.running.emplace_back(bins_, window());
    }
}

void HistogramPanel::choose_curves() {
    if (!spec_.theory || !subject_.density) return;
    constexpr int points = 240;  // so that no corners are seen where a curve turns
    const double first = bins_.low + (subject_.probability ? 0.5 * bins_.width() : 0.0);
    for (Series& one : series_) {
        if (!one.equilibrium) continue;
        double sharing = 0.0;  // infinite masses at rest have no part in the energy
        for (const MassGroup& group : one.equilibrium->groups) sharing += group.count;
        for (int i = 0; i <= points; ++i) {
            double part = static_cast<double>(i) / points;
            if (subject_.probability) part *= part;  // steep at first
            const double value = first + (bins_.high - first) * part;
            one.curve.push_back(
                {value, one.unit * numbers_each_ * sharing * expected_share(one, value)});
        }
    }
}

// Of a bar around `value`: where a density is infinite at the first edge its bars are not, and a
// curve through their middles says what they will be.
double HistogramPanel::expected_share(const Series& series, double value) const {
    const EquilibriumGas& gas = *series.equilibrium;
    if (!subject_.probability) return bins_.width() * subject_.density(gas, value);
    return subject_.probability(gas, value - 0.5 * bins_.width(), value + 0.5 * bins_.width());
}

double HistogramPanel::curve_top() const {
    double top = 0.0;
    for (const Series& one : series_)
        for (const Point& point : one.curve)
            if (std::isfinite(point.y)) top = std::max(top, point.y);
    return top;
}

// The axis holds a quarter more than 97 of a hundred values of the whole run: 99 of a hundred of a
// gas in equilibrium, whatever the start. Those beyond are counted.
double HistogramPanel::reach() const {
    std::vector<double> sizes = pool_;
    for (double& size : sizes) size = std::abs(size);
    return sizes.empty() ? 0.0 : 1.25 * quantile(sizes, 0.97);
}

void HistogramPanel::choose_bins(double reach, double numbers) {
    if (pool_.empty()) pool_.push_back(0.0);
    double high = 1.0;
    double low = 0.0;
    if (spec_.range) {
        std::tie(low, high) = *spec_.range;
    } else if (subject_.extent) {
        std::tie(low, high) = *subject_.extent;
    } else {
        high = reach > 0.0 ? round_up_for_axis(reach) : 1.0;
        if (subject_.symmetric) low = -high;
    }
    bins_ = {low, high, 1};
    if (spec_.bins) {
        bins_.count = *spec_.bins;
        return;
    }
    bins_.count = freedman_diaconis(pool_, numbers, low, high, fewest_bins, most_bins_by_rule);
    // Equal values at the start must not lie on an edge, where round-off would deal them out to two
    // bins; nor may 0, where particles at rest are, between two of an even number.
    if (subject_.symmetric && bins_.count % 2 == 0) ++bins_.count;
    const double place = (series_.front().mean_start - low) / bins_.width();
    if (std::abs(place - std::round(place)) < 1e-6) bins_.count += subject_.symmetric ? 2 : 1;
}

// Room for the bars of most frames and for the whole curve; a start far from equilibrium, all in
// one bin, would flatten everything that follows: such bars are cut with a mark.
void HistogramPanel::choose_height() {
    double bars = 0.0;
    const double curve = curve_top();
    const bool settles = curve > 0.0 || window() != 0.0;  // means are rough at first only
    for (const Series& one : series_) {
        std::vector<double> tops;
        RunningHistogram running(bins_, window());
        for (const Probe& probe : one.probes) {
            running.add(probe.time, probe.values);
            tops.push_back(one.unit * std::ranges::max(running.mean().counts));
        }
        if (!tops.empty()) bars = std::max(bars, quantile(tops, settles ? 0.5 : 0.9));
    }
    const double top = curve > 0.0 ? std::clamp(1.1 * bars, 1.2 * curve, 1.4 * curve) : 1.1 * bars;
    const double least = window() == 0.0 ? 1.0 : 1e-3;  // a mean number may be far below 1
    tallest_ = round_up_for_axis(std::max(least, top));
}

std::shared_ptr<const PanelState> HistogramPanel::state(const FrameInput& input) {
    auto state = std::make_shared<HistogramState>();
    const Eigen::ArrayXXd all = subject_.values(input);
    // A held frame is no new sample of a mean; at a reversal the present changes while time stands.
    const bool counts = window() == 0.0 || input.tick.time > seen_until_;
    seen_until_ = input.tick.time;
    for (Series& one : std::span(series_).first(own_)) {
        if (counts) one.running.front().add(input.tick.time, values_of(one, all));
        state->histograms.push_back(one.running.front().mean());
    }
    return state;
}

Table HistogramPanel::table(const PanelState& state, const Theme&) const {
    if (!compares()) return table_of(state, 0, series_.size());
    Table all;
    for (std::size_t k = 0; k < series_.size(); ++k)
        add_table_of_run(all, names_[k], table_of(state, k, k + 1));
    return all;
}

// Of the series `from` to `to` - 1.
Table HistogramPanel::table_of(const PanelState& state, std::size_t from, std::size_t to) const {
    const std::vector<std::vector<double>>& errors = HistogramPanel::errors(state);
    Table table{{"part", "of", column_name(subject_.quantity + " from", subject_.unit),
                 column_name(subject_.quantity + " to", subject_.unit),
                 percent_ ? "value (per cent)" : "value (count)"}};
    if (!errors.empty()) table.columns.push_back("standard error (count)");
    for (std::size_t k = from; k < to; ++k) {
        const Series& one = series_[k];
        const MeanHistogram& now = histograms(state)[k];
        const auto add = [&, of = name_of(context_, one.chosen)](const char* part, Cell low,
                                                                 Cell high, Cell value) {
            table.rows.push_back({part, of, std::move(low), std::move(high), std::move(value)});
        };
        for (int i = 0; i < bins_.count; ++i) {
            add("bar", bins_.edge(i), bins_.edge(i + 1), now.counts[static_cast<std::size_t>(i)]);
            if (!errors.empty())
                table.rows.back().emplace_back(errors[k][static_cast<std::size_t>(i)]);
        }
        add("below", {}, bins_.low, now.below);
        add("above", bins_.high, {}, now.above);
        for (const Point& point : one.curve) add("curve", point.x, {}, point.y);
        if (spec_.fit)
            for (const Point& point : fit_curve(k, now)) add("fit", point.x, {}, point.y);
        if (marks_mean_now()) add("mean", now.mean, {}, {});
        if (marks_mean_start()) add("mean at start", one.mean_start, {}, {});
    }
    for (std::vector<Cell>& row : table.rows) row.resize(table.columns.size());
    return table;
}

}  // namespace carom
