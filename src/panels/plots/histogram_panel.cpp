// What a histogram shows: its bins, heights, curves and states. How it is drawn is in
// histogram_drawing.cpp, how it shows several runs in histogram_runs.cpp, how well it fits in
// histogram_test.cpp.
#include "panels/plots/histogram_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "panels/chosen.h"
#include "panels/plots/comparison.h"
#include "panels/plots/histogram_state.h"
#include "util/text.h"

namespace carom {
namespace {

constexpr std::size_t pool_size = 200'000;  // values kept of the whole run, for ranges and bins
constexpr int probe_frames = 40;            // frames whose bars decide the height of the axis

double finite_mean(const Eigen::ArrayXd& values) {
    const auto finite = values.isFinite();
    return finite.any() ? finite.select(values, 0.0).sum() / static_cast<double>(finite.count())
                        : 0.0;
}

Eigen::ArrayXd values_of(const std::vector<Eigen::Index>& members, const Eigen::ArrayXXd& all) {
    const Eigen::ArrayXXd rows = all(members, Eigen::all);
    return rows.reshaped();
}

// Nothing: over all samples since the start.
std::optional<double> window_of(const PanelSpec& spec) {
    const Over over = spec.over.value_or(Over{});
    if (over.since == Over::Since::start) return std::nullopt;
    return over.window;
}

// "now", "at time 20", "time 18 to 20".
std::string time_words(const PanelSpec& spec) {
    const std::optional<double> back = window_of(spec);
    if (!spec.at) {
        if (!back) return "so far";
        return *back > 0.0 ? fmt::format("last {:g}", *back) : "now";
    }
    const std::string at = plain_number(*spec.at);
    if (!back) return "until time " + at;
    if (*back == 0.0) return "at time " + at;
    return fmt::format("time {} to {}", plain_number(*spec.at - *back), at);
}

}  // namespace

HistogramPanel::HistogramPanel(const PanelContext& context, const PanelSpec& spec,
                               HistogramSubject subject)
    : context_(context), spec_(spec), subject_(std::move(subject)) {
    record_.time = time_words(spec);
    record_.pools.resize(1);
    for (const Chosen& chosen : choices(spec)) {
        const Choice& choice = choices_.emplace_back(Choice{chosen, members(context, chosen)});
        HistogramSeries series{.name = name_of(context, chosen),
                               .particles = static_cast<double>(choice.members.size())};
        const bool all = !chosen.species && !chosen.particle;
        if (context.equilibrium)
            if (const auto gas =
                    all ? context.equilibrium
                        : among(*context.equilibrium, context.particles, choice.members))
                series.equilibria.push_back(*gas);
        record_.series.push_back(std::move(series));
    }
    record_.probes.resize(choices_.size());
}

const std::vector<MeanHistogram>& HistogramPanel::histograms(const PanelState& state) {
    return static_cast<const HistogramState&>(state).counts.series;
}

const std::vector<std::vector<double>>& HistogramPanel::errors(const PanelState& state) {
    return static_cast<const HistogramState&>(state).counts.errors;
}

std::optional<double> HistogramPanel::window() const { return window_of(spec_); }

void HistogramPanel::survey(const FrameInput& input) {
    const Eigen::ArrayXXd all = subject_.values(input);
    for (HistogramSeries& one : record_.series) one.values_each = static_cast<double>(all.cols());
    span_ = input.tick.time;
    const double numbers = record_.values();
    const auto stride = std::max<Eigen::Index>(
        1, static_cast<Eigen::Index>(numbers * context_.frames / static_cast<double>(pool_size)));
    // Bars of a few particles over a while are as rough as their probes are few.
    const int probes = window() == 0.0
                           ? probe_frames
                           : static_cast<int>(std::clamp(pool_size / numbers, double(probe_frames),
                                                         std::max(40.0, double(context_.frames))));
    const bool probe = surveyed_ % std::max(1, context_.frames / probes) == 0;
    for (std::size_t k = 0; k < choices_.size(); ++k) {
        HistogramSeries& one = record_.series[k];
        const Eigen::ArrayXd values = values_of(choices_[k].members, all);
        const double mean = finite_mean(values);
        if (surveyed_ == 0) one.mean_start = one.lowest_mean = one.highest_mean = mean;
        one.lowest_mean = std::min(one.lowest_mean, mean);
        one.highest_mean = std::max(one.highest_mean, mean);
        for (Eigen::Index i = surveyed_ % stride; i < values.size(); i += stride)
            if (std::isfinite(values[i]))  // of moving infinite masses some are not
                record_.pools.front().push_back(values[i]);
        if (probe) record_.probes[k].push_back({input.tick.time, values});
    }
    ++surveyed_;
}

// Frames that follow one another show nearly the same.
HistogramRecord HistogramPanel::record() const {
    HistogramRecord record = record_;
    const std::optional<double> back = window();
    const double share = !back ? 1.0 : span_ > 0.0 ? std::min(1.0, *back / span_) : 0.0;
    record.independent = record.values() / static_cast<double>(record.series.size()) *
                         std::max(1.0, share * context_.frames / 10.0);
    return record;
}

HistogramRules HistogramPanel::rules() const {
    HistogramRules rules{.range = spec_.range,
                         .bins = spec_.bins,
                         .symmetric = subject_.symmetric,
                         .window = window()};
    if (!rules.range) rules.range = subject_.extent;
    if (!spec_.theory) return rules;
    rules.density = subject_.density;
    rules.probability = subject_.probability;
    return rules;
}

void HistogramPanel::begin(HistogramAxes axes) {
    axes_ = std::move(axes);
    record_ = {};
    running_.assign(choices_.size(), RunningHistogram(axes_.bins, window()));
}

void HistogramPanel::fix_axes() {
    begin(axes_of(record(), rules()));
    if (spec_.test)
        for (const HistogramSeries& one : axes_.series) require_testable(one);
}

std::shared_ptr<const PanelState> HistogramPanel::state(const FrameInput& input) {
    auto state = std::make_shared<HistogramState>();
    const Eigen::ArrayXXd all = subject_.values(input);
    // A held frame is no new sample of a mean; at a reversal the present changes while time stands.
    const bool counts = window() == 0.0 || input.tick.time > seen_until_;
    seen_until_ = input.tick.time;
    for (std::size_t k = 0; k < choices_.size(); ++k) {
        if (counts) running_[k].add(input.tick.time, values_of(choices_[k].members, all));
        state->counts.series.push_back(running_[k].mean());
    }
    return state;
}

Table HistogramPanel::table(const PanelState& state, const Theme&) const {
    if (!compares()) return table_of(state, 0, count());
    Table all;
    for (std::size_t k = 0; k < count(); ++k)
        add_table_of_run(all, axes_.series[k].name, table_of(state, k, k + 1));
    return all;
}

// Of the series `from` to `to` - 1.
Table HistogramPanel::table_of(const PanelState& state, std::size_t from, std::size_t to) const {
    const std::vector<std::vector<double>>& errors = HistogramPanel::errors(state);
    const Bins& bins = axes_.bins;
    Table table{{"part", "of", column_name(subject_.quantity + " from", subject_.unit),
                 column_name(subject_.quantity + " to", subject_.unit),
                 axes_.counts_per_cent() ? "value (per cent)" : "value (count)"}};
    if (!errors.empty()) table.columns.push_back("standard error (count)");
    for (std::size_t k = from; k < to; ++k) {
        const MeanHistogram& now = histograms(state)[k];
        const std::string of =
            compares() ? name_of(context_, choices_.front().chosen) : axes_.series[k].name;
        const auto add = [&](const char* part, Cell low, Cell high, Cell value) {
            table.rows.push_back({part, of, std::move(low), std::move(high), std::move(value)});
        };
        for (int i = 0; i < bins.count; ++i) {
            add("bar", bins.edge(i), bins.edge(i + 1), now.counts[static_cast<std::size_t>(i)]);
            if (!errors.empty())
                table.rows.back().emplace_back(errors[k][static_cast<std::size_t>(i)]);
        }
        add("below", {}, bins.low, now.below);
        add("above", bins.high, {}, now.above);
        for (const Point& point : axes_.curves[k]) add("curve", point.x, {}, point.y);
        if (spec_.fit)
            for (const Point& point : fit_curve(k, now)) add("fit", point.x, {}, point.y);
        if (marks_mean_now()) add("mean", now.mean, {}, {});
        if (marks_mean_start()) add("mean at start", axes_.series[k].mean_start, {}, {});
    }
    for (std::vector<Cell>& row : table.rows) row.resize(table.columns.size());
    return table;
}

}  // namespace carom
