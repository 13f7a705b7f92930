#include "panels/plot/draw_bars.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "panels/plot/bar_notes.h"
#include "util/text.h"

namespace carom::plot {
namespace {

constexpr double casing = 0.07;         // of the page on each side of lines over bars, in units
constexpr double cased_bar = 0.7;       // units, the height of bars over which lines have casings
constexpr double cased_from = 0.3;      // units over the axis
constexpr double gap_of_bars = 0.1;     // units, between bars in the colours of disks
constexpr double alpha_of_bars = 0.92;  // of these

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
    const double top = is_broken(bars, i) ? frame.area.y : frame.y(bars.value[i], Beyond::clamped);
    return std::lerp(frame.area.bottom(), top, frame.dc.growth);
}

// The middle of a bar, in data.
double middle_of(const Bars& bars, std::size_t i) { return 0.5 * (bars.from[i] + bars.to[i]); }

// Each bar by itself, with a gap to the next, in the colour of its middle.
void fill_in_colors(Canvas& canvas, const Frame& frame, const Bars& bars) {
    const double gap = std::max(1.0, std::round(gap_of_bars * frame.dc.unit));
    for (std::size_t i = 0; i < bars.value.size(); ++i) {
        const double left = left_of(frame, bars, i), right = right_of(frame, bars, i);
        const double top = top_of(frame, bars, i), width = std::max(1.0, right - left - gap);
        if (top >= frame.area.bottom()) continue;
        canvas.fill(
            {left + std::round(0.5 * (right - left - width)), top, width,
             frame.area.bottom() - top},
            with_alpha(bars.ramp->color(middle_of(bars, i), frame.dc.theme), alpha_of_bars));
    }
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

// Solid bars have nearly the same lightness as curves, so these get a casing: a line in the page's
// colour on each side. Casings are below all curves, and not over the axes. Marks lie under the
// axis.
// Over low bars and the feet of others, which it would hide, a curve has no casing.
void draw_casings(Canvas& canvas, const Frame& frame, const Plot& plot, const Bars& bars) {
    const Rect& area = frame.area;
    const double axis = axis_style(frame.dc).line_width;
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
    if (bars.ramp)
        fill_in_colors(canvas, frame, bars);
    else if (bars.alpha > 0.0)
        fill_bars(canvas, frame, bars);
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

namespace {

// Where the count of broken bars from `left` to `right` may stand: beside them, behind the marks
// there, or over them.
std::vector<Point> places_of_count(const Frame& frame, double left, double right, double width) {
    constexpr double farthest = 2.4;  // units
    const double u = frame.dc.unit, air = 0.4 * u, top = frame.area.y;
    const double over = std::clamp(0.5 * (left + right - width), frame.area.x,
                                   std::max(frame.area.x, frame.dc.area.right() - width));
    std::vector<Point> places;
    for (double off = air; off < farthest * u; off += air)
        places.push_back({right + off, top + 1.05 * u});
    places.push_back({left - air - width, top + 1.05 * u});
    places.push_back({over, top - 0.35 * u});
    return places;
}

}  // namespace

void draw_counts_of_broken_bars(Canvas& canvas, const Frame& frame, const Plot& plot) {
    const std::vector<const Bars*> all = bars_of(plot);
    if (all.empty()) return;
    const double u = frame.dc.unit;
    const Bars& first = *all.front();
    const double room_over = frame.area.y - 1.3 * u;
    LabelPlacer placer({frame.area.x, room_over, frame.dc.area.right() - frame.area.x,
                        frame.area.bottom() - room_over});
    const Frame seen{frame.dc, frame.area, frame.x_scale, frame.y_scale, frame.y_kind, placer};
    for (const AnyLayer& layer : plot.layers) keep_clear_of(seen, layer);
    for (const Rect& name : places_of_names(frame, plot)) placer.keep_clear(name);
    for (const Rect& label : places_of_still_labels(frame, plot)) placer.keep_clear(label);
    if (const auto title = place_of_y_title(plot, frame)) placer.keep_clear(*title);
    Text words;
    for (std::size_t i = 0; i < first.value.size(); ++i) {
        for (const Bars* bars : all) {
            if (!is_broken(*bars, i)) continue;
            if (!words.empty()) words += std::string(between_numbers(plot.language));
            words += named(bars->broken[i], bars->role);
        }
        const bool is_next_broken = i + 1 < first.value.size() && is_any_broken(all, i + 1);
        if (words.empty() || is_next_broken) continue;
        const double left = frame.x(first.from[i]), right = frame.x(first.to[i]);
        const std::string markup = markup_of(std::exchange(words, {}), frame.dc.theme);
        const double width = measure_text(markup, label_style(frame.dc)).width;
        const auto rect_at = [&](const Point& at) {
            return Rect{at.x - 0.2 * u, at.y - 0.95 * u, width + 0.4 * u, 1.25 * u};
        };
        const std::vector<Point> places = places_of_count(frame, left, right, width);
        const auto place = std::ranges::find_if(places, [&](const Point& at) {
            return placer.is_inside(rect_at(at)) && placer.is_free(rect_at(at));
        });
        if (place == places.end()) {
            leave_out(markup);
            continue;
        }
        placer.keep_clear(rect_at(*place));
        draw_text(canvas, *place, markup, label_style(frame.dc));
    }
}

}  // namespace carom::plot
