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

namespace {

std::vector<HistogramCounts> counts_of(
    const std::vector<std::shared_ptr<const PanelState>>& states) {
    std::vector<HistogramCounts> counts;
    for (const auto& state : states)
        counts.push_back(static_cast<const HistogramState&>(*state).counts);
    return counts;
}

std::shared_ptr<const PanelState> state_of(HistogramCounts counts) {
    auto state = std::make_shared<HistogramState>();
    state->counts = std::move(counts);
    return state;
}

}  // namespace

void HistogramPanel::settle_with(const std::vector<Panel*>& others) {
    const std::vector<HistogramPanel*> runs = runs_of(*this, others);
    std::vector<HistogramRecord> records;
    for (const HistogramPanel* run : runs) records.push_back(run->record());
    const HistogramAxes axes = axes_of(carom::mean_of(records), rules());
    for (HistogramPanel* run : runs) run->begin(axes);
    if (spec_.test)
        for (const HistogramSeries& one : axes_.series) require_testable(one);
}

void HistogramPanel::settle_beside(const std::vector<Panel*>& others,
                                   const std::vector<std::string>& names) {
    const std::vector<HistogramPanel*> runs = runs_of(*this, others);
    std::vector<HistogramRecord> records;
    for (const HistogramPanel* run : runs) records.push_back(run->record());
    const HistogramAxes axes = axes_of(compare(records, names), rules());
    for (HistogramPanel* run : runs) run->begin(axes);
}

std::shared_ptr<const PanelState> HistogramPanel::mean_state(
    const std::vector<std::shared_ptr<const PanelState>>& states) const {
    return state_of(carom::mean_of(counts_of(states)));
}

std::shared_ptr<const PanelState> HistogramPanel::beside(
    const std::vector<std::shared_ptr<const PanelState>>& states) const {
    return state_of(compare(counts_of(states), axes_));
}

std::vector<std::string> HistogramPanel::told_of_runs(const PanelState& state) const {
    std::vector<std::string> told;
    for (const MeanHistogram& one : histograms(state))
        told.push_back(fmt::format("mean {} {}", subject_.quantity, three_digits(one.mean)) +
                       (subject_.symmetric ? ", deviation " + three_digits(one.deviation) : ""));
    return told;
}

std::vector<std::string> HistogramPanel::names() const {
    std::vector<std::string> names;
    for (const HistogramSeries& one : axes_.series) names.push_back(one.name);
    return names;
}

std::string HistogramPanel::title_of_runs(const DrawContext& dc) const {
    const std::string of = spec_.of.empty() ? subject_.title
                                            : capitalised(subject_.quantity) + " of " +
                                                  name_of(context_, choices_.front().chosen);
    const std::string unit = axes_.counts_per_cent() ? ", per cent" : "";
    const std::string time = axes_.time.empty() ? "" : ": " + axes_.time;
    const std::string words = escape_markup(spec_.title.value_or(of)) + unit + time;
    const std::string shortest = capitalised(subject_.quantity) + unit + time;
    if (!axes_.has_curves()) return fitting_title(dc, {words, shortest});
    return fitting_title(dc, {words + ", thin lines: in equilibrium", words + ", thin: equilibrium",
                              shortest + ", thin: equilibrium", shortest});
}

// Several runs: only the upper edges of their bars, as areas of more than two would hide one
// another.
void HistogramPanel::draw_runs(Canvas& canvas, const DrawContext& dc,
                               const std::vector<MeanHistogram>& now) const {
    constexpr double thin = 0.07;  // units
    for (std::size_t k = 0; k < count(); ++k)
        canvas.stroke_path(path_of(dc, axes_.curves[k]), thin * dc.unit, ink(k, dc).curve);
    for (std::size_t k = count(); k-- > 0;) draw_outline(canvas, dc, k, now[k]);
    for (std::size_t k = 0; k < count(); ++k) {
        if (spec_.fit) draw_fit(canvas, dc, k, now[k]);
        if (marks_mean_start())
            draw_mark(canvas, dc, axes_.series[k].mean_start, false, ink(k, dc).curve);
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
        const std::string unit = axes_.counts_per_cent() ? " %" : "";
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
