// The words of a histogram: its title, and the names and numbers of its means, where they keep
// clear of bars, curves and marks.
#include <fmt/format.h>

#include <algorithm>

#include "panels/chosen.h"
#include "panels/plots/comparison.h"
#include "panels/plots/histogram_panel.h"
#include "panels/plots/histogram_state.h"
#include "util/text.h"

namespace carom {
namespace {

constexpr double usual_names_width = 10.6;  // of the means' names and numbers, in units

}  // namespace

double HistogramPanel::names_width(const DrawContext& dc) const {
    const double usual = usual_names_width * dc.unit;
    return count() > 1 ? usual : std::max(usual, width_of_name(dc, "mean at start"));
}

// Of a mean's mark, name and number.
double HistogramPanel::width_of_name(const DrawContext& dc, const std::string& name) const {
    const std::string longest = name + " " + three_digits(axes_.series.front().mean_start);
    return measure_text(longest, label_style(dc)).width + 0.7 * dc.unit;
}

// A picture of one time shows no other that were the present.
std::string HistogramPanel::name_of_mean(bool is_short) const {
    if (window() != 0.0 || spec_.at) return "mean";
    return is_short ? "now" : "mean now";
}

// "now" and "start" in a row that has no room for more.
bool HistogramPanel::has_short_names(const DrawContext& dc) const {
    if (names_place(dc) != NamesPlace::above || count() > 1) return false;
    return width_of_name(dc, name_of_mean(false)) + width_of_name(dc, "mean at start") + dc.unit >
           plot_area(dc).right() - dc.area.x;
}

// Whether the equilibrium curve, and so the bars in the long run, leave room under the names.
bool HistogramPanel::is_low_right_of(const Rect& area, double x, const DrawContext& dc) const {
    constexpr double height_of_names = 2.8;  // units
    const double room = height_of_names * dc.unit / area.height * axes_.top;
    const double from =
        axes_.bins.low + (axes_.bins.high - axes_.bins.low) * (x - area.x) / area.width;
    for (const std::vector<Point>& curve : axes_.curves)
        for (const Point& point : curve)
            if (point.x >= from && point.y > axes_.top - room) return false;
    return true;
}

// Where the means' names stand: at the top right, where a tail leaves room, or at the left if the
// means are far right, or over the bars where neither keeps clear of the marks.
HistogramPanel::NamesPlace HistogramPanel::names_place(const DrawContext& dc) const {
    if (fills_the_middle() || compares()) return NamesPlace::above;
    if (window() != 0.0) return NamesPlace::right;  // the mean over a while settles soon
    const Rect area = plot_area(dc);
    const Scale x{axes_.bins.low, axes_.bins.high, area.x, area.right()};
    double lowest = area.right(), highest = area.x;
    for (const HistogramSeries& one : axes_.series) {
        lowest = std::min(lowest, x(one.lowest_mean));
        highest = std::max(highest, x(one.highest_mean));
    }
    const double clear = 0.8 * dc.unit, width = names_width(dc);
    if (highest < area.right() - width - clear && is_low_right_of(area, area.right() - width, dc))
        return NamesPlace::right;
    return lowest > area.x + dc.unit + width + clear ? NamesPlace::left : NamesPlace::above;
}

// Fits are written over the bars, and so are the means where they find no room beside them; a fit
// says the mean too.
int HistogramPanel::rows_above(const DrawContext& dc) const {
    const int fits = spec_.fit ? std::min<int>(most_fit_rows, static_cast<int>(count())) : 0;
    if (compares()) return fits + key_rows(dc, names());
    const bool marks = marks_mean_now() || marks_mean_start();
    return fits + (fits == 0 && marks && names_place(dc) == NamesPlace::above ? 1 : 0);
}

Point HistogramPanel::row_above(const DrawContext& dc, int row) const {
    const Rect area = plot_area(dc);
    return {area.x, area.y + (0.3 + note_height * row) * dc.unit};
}

std::string HistogramPanel::title(const DrawContext& dc) const {
    std::vector<Chosen> chosen;
    for (const Choice& one : choices_) chosen.push_back(one.chosen);
    const std::string names = colored_names(context_, chosen, dc.theme);
    std::string words = spec_.of.empty() ? escape_markup(subject_.title)
                                         : capitalised(subject_.quantity) + " of " + names;
    if (spec_.title) words = escape_markup(*spec_.title);
    const bool several = count() > 1;
    const std::string runs = axes_.runs > 1 ? fmt::format(", mean of {} runs", axes_.runs) : "";
    const std::string time =
        several ? axes_.time + runs : colored(axes_.time + runs, dc.theme.bar, dc.theme);
    words += ": " + time;
    std::string shortest = capitalised(subject_.quantity) + ": " + time;
    if (several)
        shortest = capitalised(subject_.quantity) + ": " +
                   colored_names(context_, chosen, dc.theme, ", ") + ", " + time;
    if (!axes_.has_curves()) return fitting_title(dc, {words, shortest});
    const std::string curve = colored("equilibrium", dc.theme.accent, dc.theme);
    const std::vector<std::string> endings =
        several ? std::vector<std::string>{", lines: in equilibrium", ", lines: equilibrium",
                                           ", lines: theory"}
                : std::vector{" and " + colored("in equilibrium", dc.theme.accent, dc.theme),
                              ", " + curve};
    for (const std::string& ending : endings)
        if (measure_text(words + ending, title_style(dc)).width <= dc.area.width)
            return words + ending;
    if (several) return fitting_title(dc, {words, shortest});
    return fitting_title(dc, {words + ", " + curve, shortest + ", " + curve, shortest});
}

double HistogramPanel::names_x(const DrawContext& dc) const {
    const Rect area = plot_area(dc);
    if (names_place(dc) == NamesPlace::left) return area.x + dc.unit;
    return area.right() - names_width(dc);
}

Point HistogramPanel::name_place(const DrawContext& dc, int index) const {
    const Rect area = scales(dc).area;
    if (names_place(dc) != NamesPlace::above)
        return {names_x(dc), area.y + (0.8 + 1.4 * index) * dc.unit};
    const Point row = row_above(dc, std::max(0, rows_above(dc) - 1));
    if (count() == 1) {  // that of the present at the left, that of the start at the right
        const bool is_short = has_short_names(dc);
        const double second =
            area.right() - (is_short ? width_of_name(dc, "start") : names_width(dc));
        const double width = width_of_name(dc, name_of_mean(is_short));
        const double first = std::min(row.x, second - width - dc.unit);
        return {index == 0 ? std::max(dc.area.x, first) + 0.2 * dc.unit : second, row.y};
    }
    const auto shown = std::max<double>(2.0, static_cast<double>(count()));
    return {row.x + 0.2 * dc.unit + index * area.width / shown, row.y};
}

// On a plate of the page's colour, so that bars behind it do not cut it up.
void HistogramPanel::draw_name(Canvas& canvas, const DrawContext& dc, Point at,
                               const std::string& words, Color color) const {
    TextStyle style = label_style(dc);
    style.color = legible(color, dc.theme);
    style.max_width = names_width(dc);
    const double right = at.x + measure_text(words, style).width + 0.3 * dc.unit;
    const Rect area = scales(dc).area;
    const double left = std::max(at.x - 0.9 * dc.unit, area.x + 0.1 * dc.unit);  // off the axis
    if (at.y > area.y)
        canvas.fill({left, at.y - 1.05 * dc.unit, right - left, 1.4 * dc.unit},
                    with_alpha(dc.theme.page, plate_alpha));
    draw_text(canvas, at, words, style);
}

// The marks move; their names and numbers stand still.
void HistogramPanel::draw_means(Canvas& canvas, const DrawContext& dc,
                                const std::vector<MeanHistogram>& now) const {
    const double u = dc.unit;
    const auto name = [&](int index, const std::string& words, double mean, bool solid,
                          Color color) {
        if (names_place(dc) == NamesPlace::above && spec_.fit) return;
        const Point at = name_place(dc, index);
        draw_name(canvas, dc, {at.x + 0.6 * u, at.y}, words + " " + three_digits(mean), color);
        const Point low{at.x, at.y + 0.1 * u}, high{at.x, at.y - 0.85 * u};
        if (solid) canvas.stroke_line(low, high, 0.12 * u, color);
        if (!solid) canvas.stroke_dashed(low, high, 0.12 * u, 0.25 * u, color);
    };
    const bool several = count() > 1;
    const bool is_short = has_short_names(dc);
    const std::string present = name_of_mean(is_short);
    for (std::size_t k = count(); k-- > 0;) {
        const Color start_color = several ? ink(k, dc).bar : dc.theme.muted;
        if (marks_mean_start()) {
            draw_mark(canvas, dc, axes_.series[k].mean_start, false, start_color);
            if (!several)
                name(1, is_short ? "start" : "mean at start", axes_.series[k].mean_start, false,
                     start_color);
        }
        if (!marks_mean_now()) continue;
        const Color color = several ? ink(k, dc).curve : dc.theme.ink;
        draw_mark(canvas, dc, now[k].mean, true, color);
        name(several ? static_cast<int>(k) : 0,
             several ? escape_markup(axes_.series[k].name) : present, now[k].mean, true, color);
    }
}

}  // namespace carom
