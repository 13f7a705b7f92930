#include "panels/plot/bar_notes.h"

#include <algorithm>

#include "draw/style.h"
#include "panels/plot/draw_bars.h"

namespace carom::plot {
namespace {

constexpr double usual_width = 10.6;  // units, of a name and its number

using Side = PlaceOfNotes::Side;

// With its mark, in a number's usual width.
double width_of(const DrawContext& dc, const BarNotes& notes, const std::string& name) {
    const std::string words = escape_markup(name) + " " + notes.typical_number;
    return measure_text(words, label_style(dc)).width + 0.7 * dc.unit;
}

// Names in a row share its width.
bool are_in_a_row(const Plot& plot) { return bars_of(plot).size() > 1; }

double width_of_names(const DrawContext& dc, const Plot& plot) {
    double width = usual_width * dc.unit;
    if (!are_in_a_row(plot))
        for (const BarNotes::Name& name : plot.bar_notes->names)
            width = std::max(width, width_of(dc, *plot.bar_notes, name.name));
    return width;
}

// Whether the curves of the theory, and so the bars in the long run, leave room under the names.
bool is_low_from(double x, const Rect& area, const DrawContext& dc, const Plot& plot) {
    constexpr double height_of_names = 2.8;  // units
    const double lowest = plot.y.high - height_of_names * dc.unit / area.height * plot.y.high;
    const double from = plot.x.low + (plot.x.high - plot.x.low) * (x - area.x) / area.width;
    for (const AnyLayer& layer : plot.layers) {
        const auto* line = std::get_if<Line>(&layer);
        if (line == nullptr || line->part != "curve") continue;
        for (std::size_t i = 0; i < line->x.size(); ++i)
            if (line->x[i] >= from && line->y[i] > lowest) return false;
    }
    return true;
}

Side side_of(const Plot& plot, const DrawContext& dc, double width) {
    const BarNotes& notes = *plot.bar_notes;
    if (!notes.may_be_beside) return Side::above;
    if (notes.is_right) return Side::right;
    const Rect area = plot_area(dc);
    const Scale x{plot.x.low, plot.x.high, area.x, area.right()};
    const double clear = 0.8 * dc.unit;
    if (x(notes.marks.second) < area.right() - width - clear &&
        is_low_from(area.right() - width, area, dc, plot))
        return Side::right;
    return x(notes.marks.first) > area.x + dc.unit + width + clear ? Side::left : Side::above;
}

double left_end(const Frame& frame) {
    return frame.notes.side == Side::left ? frame.area.x + frame.dc.unit
                                          : frame.area.right() - frame.notes.width;
}

// Short names where a row has no room for more.
bool are_short(const Frame& frame, const Plot& plot) {
    const BarNotes& notes = *plot.bar_notes;
    if (are_in_a_row(plot) || frame.notes.side != Side::above) return false;
    double width = 0.0;
    for (const BarNotes::Name& name : notes.names) width += width_of(frame.dc, notes, name.name);
    return width + frame.dc.unit > frame.area.right() - frame.dc.area.x;
}

Point place_of_name(const Frame& frame, const Plot& plot, std::size_t index, bool is_short) {
    const double u = frame.dc.unit;
    const BarNotes& notes = *plot.bar_notes;
    if (frame.notes.side != Side::above)
        return {left_end(frame), frame.area.y + (0.8 + 1.4 * static_cast<double>(index)) * u};
    const Point& row = frame.row;
    if (are_in_a_row(plot)) {
        const auto count = std::max<double>(2.0, static_cast<double>(notes.names.size()));
        return {row.x + 0.2 * u + static_cast<double>(index) * frame.area.width / count, row.y};
    }
    if (notes.names.size() == 1) return {row.x + 0.2 * u, row.y};
    // The first at the left, the other at the right.
    const auto width = [&](std::size_t k) {
        const BarNotes::Name& name = notes.names[k];
        return width_of(frame.dc, notes, is_short ? name.short_name : name.name);
    };
    const double second = frame.area.right() - (is_short ? width(1) : frame.notes.width);
    if (index == 1) return {second, row.y};
    return {std::max(frame.dc.area.x, std::min(row.x, second - width(0) - u)) + 0.2 * u, row.y};
}

// On a plate of the page's colour, so that bars behind it do not cut it up.
void draw_words(Canvas& canvas, const Frame& frame, Point at, const std::string& markup,
                Color color) {
    const double u = frame.dc.unit;
    TextStyle style = label_style(frame.dc);
    style.color = legible(color, frame.dc.theme);
    style.max_width = frame.notes.width;
    const double right = at.x + measure_text(markup, style).width + 0.3 * u;
    const double left = std::max(at.x - 0.9 * u, frame.area.x + 0.1 * u);  // off the axis
    if (at.y > frame.area.y)
        canvas.fill({left, at.y - 1.05 * u, right - left, 1.4 * u},
                    with_alpha(frame.dc.theme.page, plate_alpha));
    draw_text(canvas, at, markup, style);
}

}  // namespace

PlaceOfNotes place_of_notes(const Plot& plot, const DrawContext& dc) {
    if (!plot.bar_notes) return {};
    const double width = width_of_names(dc, plot);
    const Side side = side_of(plot, dc, width);
    const bool has_row = side == Side::above && !plot.bar_notes->names.empty();
    return {side, width, has_row ? note_height : 0.0};
}

void draw_counts_beyond(Canvas& canvas, const Frame& frame, const Plot& plot) {
    if (!plot.bar_notes) return;
    const BarNotes& notes = *plot.bar_notes;
    const double u = frame.dc.unit, top = frame.area.y + 0.8 * u;
    const Color color = frame.dc.theme.muted;
    const std::string lower = notes.below.empty() ? "" : "← " + notes.below;
    if (frame.notes.side == Side::above) {  // each at its own end
        const std::string higher = notes.above + " →";
        const double width = measure_text(higher, label_style(frame.dc)).width;
        if (!lower.empty()) draw_words(canvas, frame, {frame.area.x + 0.6 * u, top}, lower, color);
        if (!notes.above.empty())
            draw_words(canvas, frame, {frame.area.right() - width, top}, higher, color);
        return;
    }
    std::string words = lower.empty() ? "" : lower + "  ";
    if (!notes.above.empty()) words += notes.above + " " + notes.beyond + " →";
    if (words.empty()) return;
    const double row = 1.4 * static_cast<double>(std::max<std::size_t>(2, notes.names.size()));
    draw_words(canvas, frame, {left_end(frame) + 0.6 * u, top + row * u}, words, color);
}

void draw_names(Canvas& canvas, const Frame& frame, const Plot& plot) {
    if (!plot.bar_notes) return;
    const BarNotes& notes = *plot.bar_notes;
    const double u = frame.dc.unit;
    const bool is_short = are_short(frame, plot);
    for (std::size_t k = 0; k < notes.names.size(); ++k) {
        const BarNotes::Name& name = notes.names[k];
        const Point at = place_of_name(frame, plot, k, is_short);
        const std::string words = is_short ? name.short_name : name.name;
        draw_words(canvas, frame, {at.x + 0.6 * u, at.y}, escape_markup(words) + " " + name.number,
                   color_of(name.sample, frame.dc.theme));
        draw_straight(canvas, frame.dc, {at.x, at.y + 0.1 * u}, {at.x, at.y - 0.85 * u},
                      name.sample);
    }
}

}  // namespace carom::plot
