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
constexpr double fading = 2.4;          // of bars that are taller than the axis, units

double left_of(const Frame& frame, const Bars& bars, std::size_t i) {
    return std::round(frame.x(bars.from[i]));
}

double right_of(const Frame& frame, const Bars& bars, std::size_t i) {
    return std::round(frame.x(bars.to[i]));
}

bool is_taller(const Bars& bars, std::size_t i) {
    return i < bars.taller.size() && !bars.taller[i].empty();
}

double top_of(const Frame& frame, const Bars& bars, std::size_t i) {
    const double top = is_taller(bars, i) ? frame.area.y : frame.y(bars.value[i], Beyond::clamped);
    return std::lerp(frame.area.bottom(), top, frame.dc.growth);
}

// Where the solid part of a bar ends: of a bar that is taller than the axis, the rest fades out.
double solid_top_of(const Frame& frame, const Bars& bars, std::size_t i) {
    const double top = top_of(frame, bars, i), whole = frame.area.bottom() - top;
    return is_taller(bars, i) ? std::round(top + std::min(frame.pixels(fading), 0.6 * whole)) : top;
}

// Calls draw(from, to, share) for pieces of the fading part, from its foot up, with the share of
// the bar's opacity that is left.
template <class Draw>
void fade_out(double foot, double top, const Draw& draw) {
    constexpr int steps = 12;
    for (int k = 0; k < steps; ++k) {
        const double from = std::round(std::lerp(foot, top, double(k) / steps));
        const double to = std::round(std::lerp(foot, top, (k + 1.0) / steps));
        if (to < from) draw(from, to, 1.0 - (k + 0.5) / steps);
    }
}

// The middle of a bar, in data.
double middle_of(const Bars& bars, std::size_t i) { return 0.5 * (bars.from[i] + bars.to[i]); }

// A bar by itself.
void fill_bar(Canvas& canvas, const Frame& frame, const Bars& bars, std::size_t i, double left,
              double width, Color color) {
    const double foot = solid_top_of(frame, bars, i), bottom = frame.area.bottom();
    canvas.fill({left, foot, width, bottom - foot}, color);
    if (!is_taller(bars, i)) return;
    fade_out(foot, top_of(frame, bars, i), [&](double from, double to, double share) {
        canvas.fill({left, to, width, from - to}, with_alpha(color, share * color.alpha));
    });
}

// Each bar by itself, with a gap to the next, in the colour of its middle.
void fill_in_colors(Canvas& canvas, const Frame& frame, const Bars& bars) {
    const double gap = std::max(1.0, std::round(gap_of_bars * frame.dc.unit));
    for (std::size_t i = 0; i < bars.value.size(); ++i) {
        const double left = left_of(frame, bars, i), right = right_of(frame, bars, i);
        const double width = std::max(1.0, right - left - gap);
        if (top_of(frame, bars, i) >= frame.area.bottom()) continue;
        fill_bar(canvas, frame, bars, i, left + std::round(0.5 * (right - left - width)), width,
                 with_alpha(bars.ramp->color(middle_of(bars, i), frame.dc.theme), alpha_of_bars));
    }
}

// Fills all bars as one polygon: separate bars would show seams in a vector picture that is scaled.
// Horizontal positions are whole pixels, so that all bars are equally sharp.
void fill_bars(Canvas& canvas, const Frame& frame, const Bars& bars) {
    std::vector<Point> outline{{left_of(frame, bars, 0), frame.area.bottom()}};
    for (std::size_t i = 0; i < bars.value.size(); ++i) {
        const double top = solid_top_of(frame, bars, i);
        outline.push_back({left_of(frame, bars, i), top});
        outline.push_back({right_of(frame, bars, i), top});
    }
    outline.push_back({outline.back().x, frame.area.bottom()});
    const Color color = with_alpha(color_of(bars.role, frame.dc.theme), bars.alpha);
    canvas.fill_polygon(outline, color);
    for (std::size_t i = 0; i < bars.value.size(); ++i) {
        if (!is_taller(bars, i)) continue;
        const double left = left_of(frame, bars, i), width = right_of(frame, bars, i) - left;
        fade_out(
            solid_top_of(frame, bars, i), top_of(frame, bars, i),
            [&](double from, double to, double share) {
                canvas.fill({left, to, width, from - to}, with_alpha(color, share * color.alpha));
            });
    }
}

// The sides of a bar that is taller than the axis, as far as a neighbour does not go along.
void draw_fading_sides(Canvas& canvas, const Frame& frame, const Bars& bars, std::size_t i) {
    const std::size_t count = bars.value.size();
    const double foot = solid_top_of(frame, bars, i);
    const bool has_left = i == 0 || !is_taller(bars, i - 1);
    const bool has_right = i + 1 == count || !is_taller(bars, i + 1);
    fade_out(foot, top_of(frame, bars, i), [&](double from, double to, double share) {
        const Color color = with_alpha(color_of(*bars.edge, frame.dc.theme), share);
        for (const auto& [is_there, value] :
             {std::pair{has_left, bars.from[i]}, std::pair{has_right, bars.to[i]}})
            if (is_there)
                canvas.stroke_line({frame.x(value), from}, {frame.x(value), to},
                                   frame.pixels(bars.edge->width), color);
    });
}

// The upper edge; at bars that are taller than the axis, their sides up to where they fade.
void draw_edge(Canvas& canvas, const Frame& frame, const Bars& bars) {
    std::vector<Point> path;
    const auto end_path = [&] {
        if (path.size() > 1) draw_stroke(canvas, frame.dc, path, *bars.edge);
        path.clear();
    };
    for (std::size_t i = 0; i < bars.value.size(); ++i) {
        const double y = solid_top_of(frame, bars, i);
        path.push_back({frame.x(bars.from[i]), y});
        if (is_taller(bars, i)) {
            end_path();
            draw_fading_sides(canvas, frame, bars, i);
        }
        path.push_back({frame.x(bars.to[i]), y});
    }
    end_path();
}

bool is_cut(const Frame& frame, double value) { return value > frame.y_scale.high; }

bool is_any_taller(const std::vector<const Bars*>& all, std::size_t bin) {
    return std::ranges::any_of(all, [&](const Bars* bars) { return is_taller(*bars, bin); });
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

void draw_casing(Canvas& canvas, const Frame& frame, const Polyline& line) {
    std::vector<Point> path;
    for (std::size_t i = 0; i < line.x.size(); ++i)
        path.push_back({frame.x(line.x[i]), frame.y(line.y[i])});
    const double width = frame.pixels(line.stroke.width + 2.0 * casing);
    for (const std::vector<Point>& piece : cut_to(frame.area, path).pieces)
        canvas.stroke_path(piece, width, frame.dc.theme.page);
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
            if (const auto* line = std::get_if<Polyline>(&layer)) draw_casing(canvas, frame, *line);
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
    if (all.size() == 1 && all.front()->alpha == 1.0)
        draw_casings(canvas, frame, plot, *all.front());
    for (const Bars* bars : all) draw_errors(canvas, frame, *bars);
}

namespace {

// Where the number of bars from `left` to `right` may stand that are taller than the axis: beside
// them near the top, otherwise lower.
std::vector<Point> places_of_number(const Frame& frame, double left, double right, double width) {
    constexpr double farthest = 2.4, lowest = 4.0, row = 1.3;  // units
    const double u = frame.dc.unit, air = 0.4 * u;
    std::vector<Point> places;
    for (double down = 1.05; down < lowest; down += row) {
        const double y = frame.area.y + down * u;
        places.push_back({right + air, y});
        places.push_back({left - air - width, y});
    }
    for (double off = 2.0 * air; off < farthest * u; off += air)
        places.push_back({right + off, frame.area.y + 1.05 * u});
    return places;
}

// Of bars beside each other that are taller than the axis, all numbers stand together.
struct TallBars {
    double left, right;
    Text numbers;
};

std::vector<TallBars> tall_bars(const Frame& frame, const Plot& plot,
                                const std::vector<const Bars*>& all) {
    std::vector<TallBars> tall;
    const Bars& first = *all.front();
    bool goes_on = false;
    for (std::size_t i = 0; i < first.value.size(); ++i) {
        if (!std::exchange(goes_on, is_any_taller(all, i)) && goes_on)
            tall.push_back({frame.x(first.from[i]), 0.0, {}});
        if (!goes_on) continue;
        TallBars& bars = tall.back();
        bars.right = frame.x(first.to[i]);
        for (const Bars* one : all) {
            if (!is_taller(*one, i)) continue;
            if (!bars.numbers.empty()) bars.numbers += std::string(between_numbers(plot.language));
            bars.numbers += named(one->taller[i], one->role);
        }
    }
    return tall;
}

}  // namespace

void draw_numbers_of_tall_bars(Canvas& canvas, const Frame& frame, const Plot& plot) {
    const std::vector<const Bars*> all = bars_of(plot);
    if (all.empty()) return;
    const std::vector<TallBars> tall = tall_bars(frame, plot, all);
    if (tall.empty()) return;
    const double u = frame.dc.unit;
    LabelPlacer free_of_all(frame.area), free_of_words(frame.area);
    const Frame seen{frame.dc, frame.area, frame.x_scale, frame.y_scale, frame.y_kind, free_of_all};
    for (const AnyLayer& layer : plot.layers) keep_clear_of(seen, layer);
    const auto keep_clear = [&](const Rect& words) {
        free_of_all.keep_clear(words);
        free_of_words.keep_clear(words);
    };
    for (const Rect& name : places_of_names(frame, plot)) keep_clear(name);
    for (const Rect& label : places_of_still_labels(frame, plot)) keep_clear(label);
    for (const TallBars& bars : tall) {
        const std::string markup = markup_of(bars.numbers, frame.dc.theme);
        TextStyle style = label_style(frame.dc);
        const double width = measure_text(markup, style).width;
        const auto rect_at = [&](const Point& at) {
            return Rect{at.x - 0.2 * u, at.y - 0.95 * u, width + 0.4 * u, 1.25 * u};
        };
        const std::vector<Point> places = places_of_number(frame, bars.left, bars.right, width);
        const auto free_in = [&](const LabelPlacer& placer) {
            return std::ranges::find_if(places, [&](const Point& at) {
                return placer.is_inside(rect_at(at)) && placer.is_free(rect_at(at));
            });
        };
        auto place = free_in(free_of_all);
        if (place == places.end()) {  // over lines and other bars
            place = free_in(free_of_words);
            style.halo = halo_of_words * u;
            style.behind = frame.dc.theme.page;
        }
        if (place == places.end()) {
            leave_out(markup);
            continue;
        }
        keep_clear(rect_at(*place));
        draw_text(canvas, *place, markup, clear_of_grid(frame, style, rect_at(*place)));
    }
}

}  // namespace carom::plot
