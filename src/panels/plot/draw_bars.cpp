#include "panels/plot/draw_bars.h"

#include <algorithm>
#include <cmath>

#include "util/text.h"

namespace carom::plot {
namespace {

constexpr double casing = 0.07;     // of the page on each side of lines over bars, in units
constexpr double cased_bar = 0.7;   // units, the height of bars over which lines have casings
constexpr double cased_from = 0.3;  // units over the axis

double left_of(const Frame& frame, const Bars& bars, std::size_t i) {
    return std::round(frame.x(bars.from[i]));
}

double right_of(const Frame& frame, const Bars& bars, std::size_t i) {
    return std::round(frame.x(bars.to[i]));
}

// One shape: bars of their own would show seams between them wherever a vector picture is seen at
// another size. On whole pixels sideways, so that bars side by side are equally sharp.
void fill_bars(Canvas& canvas, const Frame& frame, const Bars& bars) {
    std::vector<Point> outline{{left_of(frame, bars, 0), frame.area.bottom()}};
    for (std::size_t i = 0; i < bars.value.size(); ++i) {
        const double top = frame.y(bars.value[i], Beyond::clamped);
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
        const double y = frame.y(bars.value[i], Beyond::clamped);
        path.push_back({frame.x(bars.from[i]), y});
        path.push_back({frame.x(bars.to[i]), y});
    }
    draw_stroke(canvas, frame.dc, path, *bars.edge);
}

bool is_cut(const Frame& frame, double value) { return value > frame.y_scale.high; }

// What the axes cannot hold is said: a bar that is cut, with its count.
void draw_cuts(Canvas& canvas, const Frame& frame, const std::vector<const Bars*>& all) {
    const double u = frame.dc.unit;
    const Rect& area = frame.area;
    double free_from = area.x;  // counts of neighbours must not lie on each other
    for (std::size_t i = 0; i < all.front()->value.size(); ++i) {
        Text words;  // of all whose bars are cut here
        for (const Bars* bars : all) {
            if (!is_cut(frame, bars->value[i])) continue;
            if (!words.empty()) words += ", ";
            words += named(count_words(bars->value[i]), bars->role);
        }
        if (words.empty()) continue;
        const double left = frame.x(all.front()->from[i]);
        const double right = frame.x(all.front()->to[i]);
        for (const double y : {area.y + 0.9 * u, area.y + 1.3 * u})
            canvas.stroke_line({left - 0.15 * u, y + 0.25 * u}, {right + 0.15 * u, y - 0.25 * u},
                               0.14 * u, frame.dc.theme.page);
        if (left < free_from) continue;
        const TextExtent drawn = draw_text(canvas, {left, area.y - 0.25 * u},
                                           markup_of(words, frame.dc.theme), label_style(frame.dc));
        free_from = left + 0.4 * u + drawn.width;
    }
}

// A standard error to either side of each mean, as far as the axis goes.
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

// Solid bars have hardly another lightness than curves and marks: a line of the page on each side
// keeps those apart. Under all of them, and not over the axes. It would hide low bars and the feet
// of others, on which a curve lies like a lid: there the curve has none.
void draw_casings(Canvas& canvas, const Frame& frame, const Plot& plot, const Bars& bars) {
    const Rect& area = frame.area;
    const double axis = axis_style(frame.dc).line_width;
    canvas.clip_to({area.x + axis, area.y, area.width - axis, area.height - axis});
    for (const AnyLayer& layer : plot.layers) {
        const auto* marker = std::get_if<Marker>(&layer);
        if (marker == nullptr) continue;
        const double x = frame.x(marker->value);
        if (x >= area.x && x <= area.right())
            canvas.stroke_line({x, area.bottom()}, {x, area.y},
                               frame.pixels(marker->stroke.width + 2.0 * casing),
                               frame.dc.theme.page);
    }
    canvas.release_clip();
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

std::string count_words(double count) {
    return count == std::round(count) && count < 1e9 ? grouped(std::llround(count))
                                                     : three_digits(count);
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
    draw_cuts(canvas, frame, all);
    if (all.size() == 1 && all.front()->alpha == 1.0)
        draw_casings(canvas, frame, plot, *all.front());
    for (const Bars* bars : all) draw_errors(canvas, frame, *bars);
}

}  // namespace carom::plot
