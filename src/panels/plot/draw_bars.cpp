#include "panels/plot/draw_bars.h"

#include <algorithm>
#include <cmath>

#include "util/text.h"

namespace carom::plot {
namespace {

constexpr double casing_of_marks = 0.6;  // share of the page's colour: all of it would split a bar
constexpr double casing = 0.07;          // of the page on each side of lines over bars, in units
constexpr double cased_bar = 0.7;        // units, the height of bars over which lines have casings
constexpr double cased_from = 0.3;       // units over the axis

double left_of(const Frame& frame, const Bars& bars, std::size_t i) {
    return std::round(frame.x(bars.from[i]));
}

double right_of(const Frame& frame, const Bars& bars, std::size_t i) {
    return std::round(frame.x(bars.to[i]));
}

bool is_broken(const Bars& bars, std::size_t i) {
    return i < bars.broken.size() && !bars.broken[i].empty();
}

double top_of(const Frame& frame, const Bars& bars, std::size_t i) {
    return is_broken(bars, i) ? frame.area.y : frame.y(bars.value[i], Beyond::clamped);
}

// Fills all bars as one polygon: separate bars would show seams in a vector picture that is scaled.
// Horizontal positions are whole pixels, so that all bars are equally sharp.
void fill_bars(Canvas& canvas, const Frame& frame, const Bars& bars) {
    std::vector<Point> outline{{left_of(frame, bars, 0), frame.area.bottom()}};
    for (std::size_t i = 0; i < bars.value.size(); ++i) {
        const double top = top_of(frame, bars, i);
        outline.push_back({left_of(frame, bars, i), top});
        outline.push_back({right_of(frame, bars, i), top});
    }
    outline.push_back({outline.back().x, frame.area.bottom()});
    const Color color = color_of(bars.role, frame.dc.theme);
    canvas.fill_polygon(outline, bars.alpha < 1.0 ? with_alpha(color, bars.alpha) : color);
}

void draw_edge(Canvas& canvas, const Frame& frame, const Bars& bars) {
    std::vector<Point> path;
    for (std::size_t i = 0; i < bars.value.size(); ++i) {
        const double y = top_of(frame, bars, i);
        path.push_back({frame.x(bars.from[i]), y});
        path.push_back({frame.x(bars.to[i]), y});
    }
    draw_stroke(canvas, frame.dc, path, *bars.edge);
}

bool is_cut(const Frame& frame, double value) { return value > frame.y_scale.high; }

// On a plate of the page's colour, so that bars behind it do not cut it up.
void draw_on_plate(Canvas& canvas, const Frame& frame, Point at, const std::string& markup) {
    const double u = frame.dc.unit;
    const double width = measure_text(markup, label_style(frame.dc)).width;
    canvas.fill({at.x - 0.2 * u, at.y - 0.95 * u, width + 0.4 * u, 1.25 * u},
                with_alpha(frame.dc.theme.page, plate_alpha));
    draw_text(canvas, at, markup, label_style(frame.dc));
}

bool is_any_broken(const std::vector<const Bars*>& all, std::size_t bin) {
    return std::ranges::any_of(all, [&](const Bars* bars) { return is_broken(*bars, bin); });
}

// Draws two strokes across each bar that is taller than the axis; adjacent ones share their
// strokes.
void draw_breaks(Canvas& canvas, const Frame& frame, const std::vector<const Bars*>& all) {
    const double u = frame.dc.unit;
    const Bars& first = *all.front();
    const std::size_t count = first.value.size();
    for (std::size_t from = 0; from < count; ++from) {
        std::size_t to = from;
        while (to < count && is_any_broken(all, to)) ++to;
        if (to == from) continue;
        const double left = frame.x(first.from[from]), right = frame.x(first.to[to - 1]);
        for (const double y : {frame.area.y + 0.9 * u, frame.area.y + 1.3 * u})
            canvas.stroke_line({left - 0.15 * u, y + 0.25 * u}, {right + 0.15 * u, y - 0.25 * u},
                               0.14 * u, frame.dc.theme.page);
        from = to;
    }
}

// Draws error bars of one standard error to either side of each mean, cut at the end of the axis.
void draw_errors(Canvas& canvas, const Frame& frame, const Bars& bars) {
    const double u = frame.dc.unit, width = bars.error_stroke.width * u;
    const Color color = color_of(bars.error_stroke, frame.dc.theme);
    for (std::size_t i = 0; i < bars.error.size(); ++i) {
        const double least = bars.value[i] - bars.error[i], most = bars.value[i] + bars.error[i];
        if (!(bars.error[i] > 0.0) || is_cut(frame, least)) continue;
        const double left = frame.x(bars.from[i]), right = frame.x(bars.to[i]);
        const double x = 0.5 * (left + right), half = std::min(0.25 * u, 0.3 * (right - left));
        const double low = frame.y(least, Beyond::clamped), high = frame.y(most, Beyond::clamped);
        canvas.stroke_line({x, low}, {x, high}, width, color);
        if (least >= 0.0) canvas.stroke_line({x - half, low}, {x + half, low}, width, color);
        if (!is_cut(frame, most))
            canvas.stroke_line({x - half, high}, {x + half, high}, width, color);
    }
}

void draw_casing(Canvas& canvas, const Frame& frame, const Line& line) {
    std::vector<Point> path;
    for (std::size_t i = 0; i < line.x.size(); ++i)
        path.push_back({frame.x(line.x[i]), frame.y(line.y[i], Beyond::clamped)});
    canvas.stroke_path(path, frame.pixels(line.stroke.width + 2.0 * casing), frame.dc.theme.page);
}

// The casing of a marker is as high as the bars that it crosses, and only tints them, so that they
// do not look split.
void draw_casing(Canvas& canvas, const Frame& frame, const Marker& marker, const Bars& bars) {
    const double axis = axis_style(frame.dc).line_width;
    const double half = frame.pixels(0.5 * marker.stroke.width + casing);
    const double x = frame.x(marker.value), bottom = frame.area.bottom() - axis;
    const Color color =
        mix(color_of(bars.role, frame.dc.theme), frame.dc.theme.page, casing_of_marks);
    for (std::size_t i = 0; i < bars.value.size(); ++i) {
        const double from = std::max({x - half, frame.x(bars.from[i]), frame.area.x + axis});
        const double to = std::min(x + half, frame.x(bars.to[i])), top = top_of(frame, bars, i);
        if (from < to && top < bottom) canvas.fill({from, top, to - from, bottom - top}, color);
    }
}

// Solid bars have nearly the same lightness as curves and marks, so these get a casing: a line in
// the page's colour on each side. Casings are below all curves and marks, and not over the axes.
// Over low bars and the feet of others, which it would hide, a curve has no casing.
void draw_casings(Canvas& canvas, const Frame& frame, const Plot& plot, const Bars& bars) {
    const Rect& area = frame.area;
    const double axis = axis_style(frame.dc).line_width;
    for (const AnyLayer& layer : plot.layers)
        if (const auto* marker = std::get_if<Marker>(&layer))
            draw_casing(canvas, frame, *marker, bars);
    const auto is_tall = [&](std::size_t i) {
        return area.bottom() - frame.y(bars.value[i]) >= frame.pixels(cased_bar);
    };
    const std::size_t count = bars.value.size();
    for (std::size_t from = 0; from < count; ++from) {
        std::size_t to = from;
        while (to < count && is_tall(to)) ++to;
        if (to == from) continue;
        const double left = std::max(left_of(frame, bars, from), area.x + axis);
        const double right = right_of(frame, bars, to - 1);
        canvas.clip_to({left, area.y, right - left, area.height - frame.pixels(cased_from)});
        for (const AnyLayer& layer : plot.layers)
            if (const auto* line = std::get_if<Line>(&layer)) draw_casing(canvas, frame, *line);
        canvas.release_clip();
        from = to;
    }
}

}  // namespace

std::string count_words(Language language, double count) {
    return count == std::round(count) && count < 1e9 ? grouped(std::llround(count))
                                                     : three_digits(language, count);
}

std::vector<const Bars*> bars_of(const Plot& plot) {
    std::vector<const Bars*> all;
    for (const AnyLayer& layer : plot.layers)
        if (const auto* bars = std::get_if<Bars>(&layer)) all.push_back(bars);
    return all;
}

void draw_layer(Canvas& canvas, const Frame& frame, const Bars& bars) {
    if (bars.alpha > 0.0) fill_bars(canvas, frame, bars);
    if (bars.edge) draw_edge(canvas, frame, bars);
}

void draw_over_bars(Canvas& canvas, const Frame& frame, const Plot& plot) {
    const std::vector<const Bars*> all = bars_of(plot);
    if (all.empty()) return;
    draw_breaks(canvas, frame, all);
    if (all.size() == 1 && all.front()->alpha == 1.0)
        draw_casings(canvas, frame, plot, *all.front());
    for (const Bars* bars : all) draw_errors(canvas, frame, *bars);
}

void draw_counts_of_broken_bars(Canvas& canvas, const Frame& frame, const Plot& plot) {
    const std::vector<const Bars*> all = bars_of(plot);
    if (all.empty()) return;
    const double u = frame.dc.unit;
    const Rect& area = frame.area;
    const Bars& first = *all.front();
    Text words;
    double free_from = area.x;
    for (std::size_t i = 0; i < first.value.size(); ++i) {
        for (const Bars* bars : all) {
            if (!is_broken(*bars, i)) continue;
            if (!words.empty()) words += std::string(between_numbers(plot.language));
            words += named(bars->broken[i], bars->role);
        }
        const bool is_next_broken = i + 1 < first.value.size() && is_any_broken(all, i + 1);
        if (words.empty() || is_next_broken) continue;
        const double left = frame.x(first.from[i]), right = frame.x(first.to[i]);
        const std::string markup = markup_of(words, frame.dc.theme);
        words = {};
        const double width = measure_text(markup, label_style(frame.dc)).width;
        // Beside the bar, off the names of marks and off the count before.
        double most_left = free_from, most_right = frame.dc.area.right();
        if (frame.notes.side == PlaceOfNotes::Side::right && plot.bar_notes &&
            !plot.bar_notes->names.empty())
            most_right = area.right() - frame.notes.width - u;
        if (frame.notes.side == PlaceOfNotes::Side::left)
            most_left = std::max(most_left, area.x + u + frame.notes.width);
        const double after = right + 0.4 * u, before = left - 0.4 * u - width;
        const bool is_after = after > most_left && after + width < most_right;
        if (!is_after && (before < most_left || before + width > most_right)) continue;
        free_from = (is_after ? after : before) + width + 0.5 * u;
        draw_on_plate(canvas, frame, {is_after ? after : before, area.y + 1.05 * u}, markup);
    }
}

}  // namespace carom::plot
