// Histograms of several runs: their mean with its error, or one beside the other.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "panels/chosen.h"
#include "panels/plots/comparison.h"
#include "panels/plots/histogram_panel.h"
#include "panels/plots/histogram_state.h"
#include "stats/mean_error.h"
#include "util/text.h"

namespace carom {

// Bins for the values of all runs. Curves and means at the start are means too.
void HistogramPanel::settle_with(const std::vector<Panel*>& others) {
    const std::vector<HistogramPanel*> runs = runs_of(*this, others);
    runs_ = runs.size();
    for (const HistogramPanel* run : std::span(runs).subspan(1))
        pool_.insert(pool_.end(), run->pool_.begin(), run->pool_.end());
    choose_bins(reach(), numbers_in_bars());
    choose_curves();
    for (HistogramPanel* run : std::span(runs).subspan(1)) {
        run->bins_ = bins_;
        run->choose_curves();
    }
    take_mean_of_curves(runs);
    for (std::size_t k = 0; k < series_.size(); ++k) {
        std::vector<double> starts;
        for (const HistogramPanel* run : runs) {
            const Series& one = run->series_[k];
            starts.push_back(one.mean_start);
            series_[k].lowest_mean = std::min(series_[k].lowest_mean, one.lowest_mean);
            series_[k].highest_mean = std::max(series_[k].highest_mean, one.highest_mean);
            if (run != this && one.equilibrium) series_[k].others.push_back(*one.equilibrium);
        }
        series_[k].mean_start = mean_error(starts).mean;
    }
    for (HistogramPanel* run : runs) run->finish();
    for (const Series& one : series_)
        if (spec_.test) require_testable(one);
}

// One axis for the values of all runs, however many particles each has, in bins that suit the one
// with the fewest. Bars of runs of different counts are comparable as shares only.
void HistogramPanel::settle_beside(const std::vector<Panel*>& others,
                                   const std::vector<std::string>& names) {
    const std::vector<HistogramPanel*> runs = runs_of(*this, others);
    names_ = names;
    double farthest = 0.0, fewest = numbers_in_bars();
    for (const HistogramPanel* run : runs) {
        farthest = std::max(farthest, run->reach());
        fewest = std::min(fewest, run->numbers_in_bars());
        percent_ |= run->numbers_at_a_time() != numbers_at_a_time();
        same_time_ &= run->time_words() == time_words();
    }
    for (const HistogramPanel* run : std::span(runs).subspan(1))
        pool_.insert(pool_.end(), run->pool_.begin(), run->pool_.end());
    choose_bins(farthest, fewest);
    for (HistogramPanel* run : runs) {
        run->bins_ = bins_;
        if (percent_) run->series_.front().unit = 100.0 / run->numbers_at_a_time();
        run->choose_curves();
    }
    for (const HistogramPanel* run : std::span(runs).subspan(1))
        series_.push_back(run->series_.front());
    for (HistogramPanel* run : runs) run->finish();
}

std::shared_ptr<const PanelState> HistogramPanel::beside(
    const std::vector<std::shared_ptr<const PanelState>>& states) const {
    auto all = std::make_shared<HistogramState>();
    for (std::size_t k = 0; k < states.size(); ++k) {
        MeanHistogram one = histograms(*states[k]).front();
        const double unit = series_[k].unit;
        for (double& count : one.counts) count *= unit;
        one.below *= unit;
        one.above *= unit;
        all->histograms.push_back(std::move(one));
    }
    return all;
}

std::vector<std::string> HistogramPanel::told_of_runs(const PanelState& state) const {
    std::vector<std::string> told;
    for (const MeanHistogram& one : histograms(state))
        told.push_back(fmt::format("mean {} {}", subject_.quantity, three_digits(one.mean)) +
                       (subject_.symmetric ? ", deviation " + three_digits(one.deviation) : ""));
    return told;
}

std::string HistogramPanel::name_of_series(std::size_t series) const {
    return compares() ? names_[series] : name_of(context_, series_[series].chosen);
}

void HistogramPanel::take_mean_of_curves(const std::vector<HistogramPanel*>& runs) {
    for (std::size_t k = 0; k < series_.size(); ++k)
        for (std::size_t i = 0; i < series_[k].curve.size(); ++i) {
            std::vector<double> heights;
            for (const HistogramPanel* run : runs)
                if (!run->series_[k].curve.empty()) heights.push_back(run->series_[k].curve[i].y);
            series_[k].curve[i].y = mean_error(heights).mean;
        }
}

std::shared_ptr<const PanelState> HistogramPanel::mean_state(
    const std::vector<std::shared_ptr<const PanelState>>& states) const {
    auto mean = std::make_shared<HistogramState>();
    mean->histograms = histograms(*states.front());
    const auto over_runs = [&](std::size_t k, const auto& number) {
        std::vector<double> values;
        for (const auto& state : states) values.push_back(number(histograms(*state)[k]));
        return mean_error(values);
    };
    for (std::size_t k = 0; k < mean->histograms.size(); ++k) {
        MeanHistogram& bars = mean->histograms[k];
        std::vector<double>& errors = mean->errors.emplace_back();
        for (std::size_t i = 0; i < bars.counts.size(); ++i) {
            const MeanError one =
                over_runs(k, [i](const MeanHistogram& run) { return run.counts[i]; });
            bars.counts[i] = one.mean;
            errors.push_back(one.error);
        }
        bars.below = over_runs(k, [](const MeanHistogram& run) { return run.below; }).mean;
        bars.above = over_runs(k, [](const MeanHistogram& run) { return run.above; }).mean;
        bars.mean = over_runs(k, [](const MeanHistogram& run) { return run.mean; }).mean;
        const auto square = [&](const MeanHistogram& run) {  // about the mean of all
            return run.deviation * run.deviation + (run.mean - bars.mean) * (run.mean - bars.mean);
        };
        bars.deviation = std::sqrt(over_runs(k, square).mean);
        bars.values *= static_cast<double>(states.size());
    }
    return mean;
}

std::string HistogramPanel::title_of_runs(const DrawContext& dc) const {
    const std::string of = spec_.of.empty() ? subject_.title
                                            : capitalised(subject_.quantity) + " of " +
                                                  name_of(context_, series_.front().chosen);
    const std::string unit = percent_ ? ", per cent" : "";
    const std::string time = same_time_ ? ": " + time_words() : "";
    const std::string words = escape_markup(spec_.title.value_or(of)) + unit + time;
    const std::string shortest = capitalised(subject_.quantity) + unit + time;
    if (curve_top() == 0.0) return fitting_title(dc, {words, shortest});
    return fitting_title(dc, {words + ", thin lines: in equilibrium", words + ", thin: equilibrium",
                              shortest + ", thin: equilibrium", shortest});
}

// Several runs: only the upper edges of their bars, as areas of more than two would hide one
// another.
void HistogramPanel::draw_runs(Canvas& canvas, const DrawContext& dc,
                               const std::vector<MeanHistogram>& now) const {
    constexpr double thin = 0.07;  // units
    for (std::size_t k = 0; k < series_.size(); ++k)
        canvas.stroke_path(path_of(dc, series_[k].curve), thin * dc.unit, ink(k, dc).curve);
    for (std::size_t k = series_.size(); k-- > 0;) draw_outline(canvas, dc, k, now[k]);
    for (std::size_t k = 0; k < series_.size(); ++k) {
        if (spec_.fit) draw_fit(canvas, dc, k, now[k]);
        if (marks_mean_start())
            draw_mark(canvas, dc, series_[k].mean_start, false, ink(k, dc).curve);
        if (marks_mean_now()) draw_mark(canvas, dc, now[k].mean, true, ink(k, dc).curve);
    }
    draw_cuts(canvas, dc, now);
    draw_beyond_runs(canvas, dc, now);
}

// How many of a run lie beyond the ends of the axis: from the fewest of a run to the most.
void HistogramPanel::draw_beyond_runs(Canvas& canvas, const DrawContext& dc,
                                      const std::vector<MeanHistogram>& now) const {
    const auto words = [&](double MeanHistogram::*beyond) -> std::string {
        const auto [fewest, most] = std::ranges::minmax(now, {}, beyond);
        if (!(most.*beyond > 0.0)) return "";
        const std::string unit = percent_ ? " %" : "";
        const std::string high = count_words(most.*beyond), low = count_words(fewest.*beyond);
        return low == high ? high + unit : low + " to " + high + unit;
    };
    const std::string below = words(&MeanHistogram::below), above = words(&MeanHistogram::above);
    const Rect area = scales(dc).area;
    const double top = area.y + 0.8 * dc.unit;
    if (!below.empty())
        draw_name(canvas, dc, {area.x + 0.6 * dc.unit, top}, "← " + below, dc.theme.muted);
    if (above.empty()) return;
    const std::string higher = above + " →";
    const double width = measure_text(higher, label_style(dc)).width;
    draw_name(canvas, dc, {area.right() - width, top}, higher, dc.theme.muted);
}

}  // namespace carom
