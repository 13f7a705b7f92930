// How a histogram is drawn: bars, curves, means and what lies beyond its axes.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "panels/chosen.h"
#include "panels/plots/comparison.h"
#include "panels/plots/histogram_panel.h"
#include "panels/plots/histogram_state.h"
#include "util/text.h"

namespace carom {
namespace {

constexpr double casing = 0.07;     // of the page on each side of lines over bars, in units
constexpr double cased_bar = 0.7;   // units, the height of bars over which curves have casings
constexpr double cased_from = 0.3;  // units over the axis
constexpr double curve_width = 0.16, mark_width = 0.12;  // in units
constexpr double error_width = 0.08;                     // in units
constexpr double tint_alpha = 0.3;                       // of bars that others overlap
constexpr double gap_below_rows = 0.4;  // in units, for the counts of bars that are cut
constexpr double told_beyond = 0.01;    // of a mean number: less beyond the axis is not told

}  // namespace

std::string count_words(double count) {
    return count == std::round(count) && count < 1e9 ? grouped(std::llround(count))
                                                     : three_digits(count);
}

HistogramPanel::Scales HistogramPanel::scales(const DrawContext& dc) const {
    Rect area = plot_area(dc);
    const int above = rows_above(dc);
    const double rows = (note_height * above + (above > 0 ? gap_below_rows : 0.0)) * dc.unit;
    area.y += rows;
    area.height = std::max(dc.unit, area.height - rows);
    return {area,
            {axes_.bins.low, axes_.bins.high, area.x, area.right()},
            {0.0, axes_.top, area.bottom(), area.y}};
}

// One choice of particles has the colours of all histograms, several have their own.
HistogramPanel::Ink HistogramPanel::ink(std::size_t series, const DrawContext& dc) const {
    const Theme& theme = dc.theme;
    if (compares()) {
        const Color color = compared_color(series, theme);
        return {color, color, color};
    }
    if (count() == 1) return {theme.bar, theme.accent, theme.highlight};
    const Color color = choice_color(context_, choices_[series].chosen, series, theme);
    std::vector<Color> tints{theme.page};
    for (std::size_t k = 0; k < count(); ++k)
        tints.push_back(
            mix(theme.page, choice_color(context_, choices_[k].chosen, k, theme), tint_alpha));
    const auto line = [&](double share) {
        return toward_ink(mix(color, theme.ink, share), theme, tints, least_contrast_of_marks);
    };
    return {color, line(0.4), line(0.7)};
}

void HistogramPanel::draw_ground(Canvas& canvas, const DrawContext& dc) const {
    draw_panel_title(canvas, dc, compares() ? title_of_runs(dc) : title(dc));
    const Scales s = scales(dc);
    if (compares()) draw_key_of_runs(canvas, dc, {dc.area.x, row_above(dc, 0).y}, names());
    draw_x_axis(canvas, s.area, s.x, subject_.quantity, axis_style(dc));
    AxisStyle counts = axis_style(dc);
    counts.whole = window() == 0.0 && axes_.runs == 1 &&
                   !axes_.counts_per_cent();  // means over a while may be any number
    draw_y_axis(canvas, s.area, s.y, "", counts);
}

void HistogramPanel::draw(Canvas& canvas, const DrawContext& dc, const PanelState& state) const {
    const std::vector<MeanHistogram>& now = histograms(state);
    if (compares()) return draw_runs(canvas, dc, now);
    for (std::size_t k = 0; k < count(); ++k) {
        draw_bars(canvas, dc, k, now[k]);
        if (count() > 1) draw_outline(canvas, dc, k, now[k]);
    }
    draw_cuts(canvas, dc, now);
    draw_beyond(canvas, dc, now);
    if (count() == 1) draw_casings(canvas, dc, now.front());
    for (std::size_t k = 0; k < count(); ++k) draw_errors(canvas, dc, k, state);
    for (std::size_t k = 0; k < count(); ++k) {
        canvas.stroke_path(path_of(dc, axes_.curves[k]), curve_width * dc.unit, ink(k, dc).curve,
                           line_dashes(k, count(), dc));
        if (spec_.fit) draw_fit(canvas, dc, k, now[k]);
    }
    draw_means(canvas, dc, now);
}

void HistogramPanel::draw_bars(Canvas& canvas, const DrawContext& dc, std::size_t series,
                               const MeanHistogram& now) const {
    const Scales s = scales(dc);
    const Color color = ink(series, dc).bar;
    const double alpha = count() > 1 ? tint_alpha : 1.0;
    // One shape: bars of their own would show seams between them wherever a vector picture is seen
    // at another size. On whole pixels sideways, so that bars side by side are equally sharp.
    std::vector<Point> outline;
    for (int i = 0; i < axes_.bins.count; ++i) {
        const double count = now.counts[static_cast<std::size_t>(i)];
        const double left = std::round(s.x(axes_.bins.edge(i)));
        const double right = std::round(s.x(axes_.bins.edge(i + 1)));
        const double top = count == 0.0 ? s.area.bottom() : s.y(std::min(count, axes_.top));
        if (outline.empty()) outline.push_back({left, s.area.bottom()});
        outline.push_back({left, top});
        outline.push_back({right, top});
    }
    outline.push_back({outline.back().x, s.area.bottom()});
    canvas.fill_polygon(outline, alpha < 1.0 ? with_alpha(color, alpha) : color);
}

// The upper edge of bars that others overlap.
void HistogramPanel::draw_outline(Canvas& canvas, const DrawContext& dc, std::size_t series,
                                  const MeanHistogram& now) const {
    const Scales s = scales(dc);
    std::vector<Point> path;
    for (int i = 0; i < axes_.bins.count; ++i) {
        const double y = s.y(std::min(now.counts[static_cast<std::size_t>(i)], axes_.top));
        path.push_back({s.x(axes_.bins.edge(i)), y});
        path.push_back({s.x(axes_.bins.edge(i + 1)), y});
    }
    if (compares())
        return canvas.stroke_path(path, curve_width * dc.unit, ink(series, dc).bar,
                                  compared_dashes(series, dc));
    canvas.stroke_path(path, 0.1 * dc.unit, edge_of(ink(series, dc).bar, dc.theme),
                       line_dashes(series, count(), dc));
}

// A standard error to either side of each mean, as far as the axis goes.
void HistogramPanel::draw_errors(Canvas& canvas, const DrawContext& dc, std::size_t series,
                                 const PanelState& state) const {
    if (errors(state).empty()) return;
    const Scales s = scales(dc);
    const double u = dc.unit;
    const Color color = count() > 1 ? ink(series, dc).curve : dc.theme.ink;
    const double half =
        std::min(0.25 * u, 0.3 * (s.x(axes_.bins.edge(1)) - s.x(axes_.bins.edge(0))));
    for (int i = 0; i < axes_.bins.count; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const double mean = histograms(state)[series].counts[k], error = errors(state)[series][k];
        if (!(error > 0.0) || mean - error > axes_.top) continue;
        const double x = 0.5 * (s.x(axes_.bins.edge(i)) + s.x(axes_.bins.edge(i + 1)));
        const double low = s.y(std::max(0.0, mean - error));
        const double high = s.y(std::min(axes_.top, mean + error));
        canvas.stroke_line({x, low}, {x, high}, error_width * u, color);
        if (mean - error >= 0.0)
            canvas.stroke_line({x - half, low}, {x + half, low}, error_width * u, color);
        if (mean + error <= axes_.top)
            canvas.stroke_line({x - half, high}, {x + half, high}, error_width * u, color);
    }
}

// What the axes cannot hold is said: a bar that is cut, with its count.
void HistogramPanel::draw_cuts(Canvas& canvas, const DrawContext& dc,
                               const std::vector<MeanHistogram>& now) const {
    const Scales s = scales(dc);
    const double u = dc.unit;
    double free_from = s.area.x;  // counts of neighbours must not lie on each other
    for (int i = 0; i < axes_.bins.count; ++i) {
        std::string words;  // of all choices whose bars are cut here
        for (std::size_t k = 0; k < now.size(); ++k) {
            const double count = now[k].counts[static_cast<std::size_t>(i)];
            if (count > axes_.top)
                words += (words.empty() ? "" : ", ") +
                         colored(count_words(count), ink(k, dc).bar, dc.theme);
        }
        if (words.empty()) continue;
        const double left = s.x(axes_.bins.edge(i));
        const double right = s.x(axes_.bins.edge(i + 1));
        for (double y : {0.9 * u, 1.3 * u})
            canvas.stroke_line({left - 0.15 * u, s.area.y + y + 0.25 * u},
                               {right + 0.15 * u, s.area.y + y - 0.25 * u}, 0.14 * u,
                               dc.theme.page);
        const TextStyle style = label_style(dc);
        if (left < free_from) continue;
        free_from =
            left + 0.4 * u + draw_text(canvas, {left, s.area.y - 0.25 * u}, words, style).width;
    }
}

// How many lie beyond the ends of the axis. A mean over a while may be a small part of one.
void HistogramPanel::draw_beyond(Canvas& canvas, const DrawContext& dc,
                                 const std::vector<MeanHistogram>& now) const {
    double below = 0.0, above = 0.0;
    for (const MeanHistogram& one : now) {
        below += one.below;
        above += one.above;
    }
    double values_at_a_time = 0.0;
    for (const HistogramSeries& one : axes_.series) values_at_a_time += one.values();
    const double least = window() == 0.0 ? 0.0 : told_beyond * values_at_a_time;
    if (below < least) below = 0.0;
    if (above < least) above = 0.0;
    const Scales s = scales(dc);
    const double top = s.area.y + 0.8 * dc.unit;
    if (names_place(dc) == NamesPlace::above) {  // each at its own end
        const std::string higher = count_words(above) + " →";
        const double width = measure_text(higher, label_style(dc)).width;
        if (below > 0.0)
            draw_name(canvas, dc, {s.area.x + 0.6 * dc.unit, top}, "← " + count_words(below),
                      dc.theme.muted);
        if (above > 0.0)
            draw_name(canvas, dc, {s.area.right() - width, top}, higher, dc.theme.muted);
        return;
    }
    std::string words = below > 0.0 ? "← " + count_words(below) + "  " : "";
    if (above > 0.0) words += fmt::format("{} {} →", count_words(above), subject_.beyond);
    if (words.empty()) return;
    const double row = now.size() > 1 ? 1.4 * static_cast<double>(now.size()) : 2.8;
    draw_name(canvas, dc, {names_x(dc) + 0.6 * dc.unit, top + row * dc.unit}, words,
              dc.theme.muted);
}

std::vector<Point> HistogramPanel::path_of(const DrawContext& dc,
                                           const std::vector<Point>& curve) const {
    const Scales s = scales(dc);
    std::vector<Point> path;
    for (const Point& point : curve)
        path.push_back({s.x(point.x), s.y(std::min(point.y, axes_.top))});
    return path;
}

std::optional<double> HistogramPanel::mark_place(const DrawContext& dc, double value) const {
    const Scales s = scales(dc);
    const double x = s.x(value);
    if (!(x >= s.area.x && x <= s.area.right())) return {};
    return x;
}

// Solid bars have hardly another lightness than curves and marks: a line of the page on each side
// keeps those apart. Under all of them, and not over the axes. It would hide low bars and
// the feet of others, on which a curve lies like a lid: there the curve has none.
void HistogramPanel::draw_casings(Canvas& canvas, const DrawContext& dc,
                                  const MeanHistogram& now) const {
    const Scales s = scales(dc);
    const double u = dc.unit, axis = axis_style(dc).line_width;
    canvas.clip_to({s.area.x + axis, s.area.y, s.area.width - axis, s.area.height - axis});
    const auto stroke = [&](const std::vector<Point>& points) {
        canvas.stroke_path(path_of(dc, points), (curve_width + 2.0 * casing) * u, dc.theme.page);
    };
    const auto is_tall = [&](int bin) {
        return s.area.bottom() - s.y(now.counts[static_cast<std::size_t>(bin)]) >= cased_bar * u;
    };
    const auto mark = [&](double value) {
        if (const std::optional<double> x = mark_place(dc, value))
            canvas.stroke_line({*x, s.area.bottom()}, {*x, s.area.y},
                               (mark_width + 2.0 * casing) * u, dc.theme.page);
    };
    if (marks_mean_start()) mark(axes_.series.front().mean_start);
    if (marks_mean_now()) mark(now.mean);
    canvas.release_clip();
    for (int from = 0; from < axes_.bins.count; ++from) {
        int to = from;
        while (to < axes_.bins.count && is_tall(to)) ++to;
        if (to == from) continue;
        const double left = std::max(std::round(s.x(axes_.bins.edge(from))), s.area.x + axis);
        const double right = std::round(s.x(axes_.bins.edge(to)));
        canvas.clip_to({left, s.area.y, right - left, s.area.height - cased_from * u});
        stroke(axes_.curves.front());
        if (spec_.fit) stroke(fit_curve(0, now));
        canvas.release_clip();
        from = to;
    }
}

// The normal curve with the mean and the deviation of what the bars show.
std::vector<Point> HistogramPanel::fit_curve(std::size_t series, const MeanHistogram& now) const {
    std::vector<Point> curve;
    if (!(now.deviation > 0.0)) return curve;
    constexpr int points = 120;
    const double numbers = axes_.series[series].unit * axes_.series[series].values();
    for (int i = 0; i <= points; ++i) {
        const double value = axes_.bins.low + (axes_.bins.high - axes_.bins.low) * i / points;
        const double z = (value - now.mean) / now.deviation;
        const double density =
            std::exp(-0.5 * z * z) / (now.deviation * std::sqrt(2.0 * std::numbers::pi));
        curve.push_back({value, numbers * axes_.bins.width() * density});
    }
    return curve;
}

// Dashed beside the equilibrium curve, which has no other colour in print.
void HistogramPanel::draw_fit(Canvas& canvas, const DrawContext& dc, std::size_t series,
                              const MeanHistogram& now) const {
    const Color color = ink(series, dc).fit;
    const bool dashed = !axes_.curves[series].empty();
    std::vector<double> dashes;
    if (dashed) dashes = {0.8 * dc.unit};
    if (dc.theme.kind == ThemeKind::print && count() > 1)  // other than the bars' own
        dashes = line_dashes(count() + series, 2 * count(), dc);
    canvas.stroke_path(path_of(dc, fit_curve(series, now)), curve_width * dc.unit, color, dashes);
    if (series >= most_fit_rows) return;
    const Point row =
        row_above(dc, static_cast<int>(series) + (compares() ? key_rows(dc, names()) : 0));
    if (!dashes.empty())  // a sample of it, left of the words
        canvas.stroke_path(std::array{Point{row.x - 2.9 * dc.unit, row.y - 0.35 * dc.unit},
                                      Point{row.x - 0.5 * dc.unit, row.y - 0.35 * dc.unit}},
                           curve_width * dc.unit, color, dashes);
    TextStyle style = label_style(dc);
    style.color = legible(color, dc.theme);
    style.max_width = plot_area(dc).width;
    const std::string whose =
        count() == 1 ? "normal curve" : escape_markup(axes_.series[series].name);
    const std::string numbers_of_it =
        fmt::format("mean {}, deviation {}", three_digits(now.mean), three_digits(now.deviation));
    const std::string whole = whose + ": " + numbers_of_it;  // without the name the colour tells
    const bool fits = measure_text(whole + "00", label_style(dc)).width <= style.max_width;
    draw_text(canvas, row, fits ? whole : numbers_of_it, style);
}

void HistogramPanel::draw_mark(Canvas& canvas, const DrawContext& dc, double value, bool solid,
                               Color color) const {
    const std::optional<double> x = mark_place(dc, value);
    if (!x) return;
    const Scales s = scales(dc);
    const double u = dc.unit;
    if (solid) canvas.stroke_line({*x, s.area.bottom()}, {*x, s.area.y}, mark_width * u, color);
    if (!solid)
        canvas.stroke_dashed({*x, s.area.bottom()}, {*x, s.area.y}, mark_width * u, 0.25 * u,
                             color);
}

}  // namespace carom
