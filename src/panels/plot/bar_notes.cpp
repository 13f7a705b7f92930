#include "panels/plot/bar_notes.h"

#include <algorithm>
#include <cmath>

#include "draw/style.h"
#include "panels/plot/draw_bars.h"
#include "panels/plot/notes.h"

namespace carom::plot {
namespace {

constexpr double usual_width = 10.6;  // units, of a name and its number
constexpr double first_row = 1.05;    // units, from the top of the plot to its baseline

using Side = PlaceOfNotes::Side;

// The width of a name with its mark and with a number of typical width.
double width_of(const DrawContext& dc, const BarNotes& notes, const std::string& name) {
    const std::string words = escape_markup(name) + " " + notes.typical_number;
    return measure_text(words, label_style(dc)).width + 0.7 * dc.unit;
}

bool has_short_names(const Plot& plot) {
    return !plot.bar_notes->are_in_a_row &&
           std::ranges::none_of(plot.bar_notes->names,
                                [](const auto& name) { return name.short_name.empty(); });
}

const std::string& name_of(const BarNotes::Name& name, bool is_short) {
    return is_short ? name.short_name : name.name;
}

double width_of_names(const DrawContext& dc, const Plot& plot, bool is_short) {
    if (plot.bar_notes->names.empty()) return usual_width * dc.unit;
    const double numbers_waver = 0.6 * dc.unit;
    double width = 0.0;
    for (const BarNotes::Name& name : plot.bar_notes->names)
        width =
            std::max(width, width_of(dc, *plot.bar_notes, name_of(name, is_short)) + numbers_waver);
    return width;
}

// Whether the theoretical curves, and thus the bars in the long run, are low enough from `x` on to
// leave room for the names.
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
    if (frame.notes.side != Side::above) return frame.notes.is_short;
    if (plot.bar_notes->are_in_a_row) {
        const double share = frame.area.width / static_cast<double>(frame.notes.in_row);
        return std::ranges::any_of(notes.names, [&](const BarNotes::Name& name) {
            return width_of(frame.dc, notes, name.name) + 0.6 * frame.dc.unit > share;
        });
    }
    double width = 0.0;
    for (const BarNotes::Name& name : notes.names) width += width_of(frame.dc, notes, name.name);
    return width + frame.dc.unit > frame.area.right() - frame.dc.area.x;
}

Point place_of_name(const Frame& frame, const Plot& plot, std::size_t index, bool is_short) {
    const double u = frame.dc.unit;
    const BarNotes& notes = *plot.bar_notes;
    if (frame.notes.side != Side::above)
        return {left_end(frame), frame.area.y + (first_row + 1.4 * static_cast<double>(index)) * u};
    const Point& row = frame.row;
    if (plot.bar_notes->are_in_a_row) {
        const std::size_t in_row = frame.notes.in_row;
        const double share = frame.area.width / static_cast<double>(in_row);
        return {row.x + 0.2 * u + static_cast<double>(index % in_row) * share,
                row.y + static_cast<double>(index / in_row) * note_height * u};
    }
    if (notes.names.size() == 1) return {row.x + 0.2 * u, row.y};
    // The first at the left, the other at the right.
    const auto width = [&](std::size_t k) {
        const BarNotes::Name& name = notes.names[k];
        return width_of(frame.dc, notes, name_of(name, is_short));
    };
    const double second = frame.area.right() - (is_short ? width(1) : frame.notes.width);
    if (index == 1) return {second, row.y};
    return {std::max(frame.dc.area.x, std::min(row.x, second - width(0) - u)) + 0.2 * u, row.y};
}

// The number of names in a row, with short names if necessary; room is computed for at least two
// names, and rows are balanced.
std::size_t in_a_row(const Plot& plot, const DrawContext& dc) {
    constexpr double labels = 4.0;  // units, left of the area
    const std::size_t count = std::max<std::size_t>(2, plot.bar_notes->names.size());
    const double width = dc.area.width - labels * dc.unit;
    const double most = width / std::max(dc.unit, width_of_names(dc, plot, true));
    const auto found =
        static_cast<std::size_t>(std::clamp(std::floor(most), 1.0, static_cast<double>(count)));
    const std::size_t rows = (count + found - 1) / found;
    return (count + rows - 1) / rows;
}

// Draws words on a plate of the page's colour, so that bars behind do not impair them.
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
    // Names of several choices are short beside the bars; above them, the row has room for more.
    bool is_short = plot.bar_notes->are_in_a_row;
    double width = width_of_names(dc, plot, is_short);
    Side side = side_of(plot, dc, width);
    if (side == Side::above && is_short) {
        is_short = false;
        width = width_of_names(dc, plot, is_short);
    }
    if (side == Side::above && has_short_names(plot)) {
        const double short_width = width_of_names(dc, plot, true);
        side = side_of(plot, dc, short_width);
        is_short = side != Side::above;
        if (is_short) width = short_width;
    }
    const bool has_row = side == Side::above && !plot.bar_notes->names.empty();
    const double left_over = plot_area(dc).height / dc.unit - height_of_rows(plot, dc, false);
    const std::size_t in_row = plot.bar_notes->are_in_a_row ? in_a_row(plot, dc) : 2;
    const double height =
        note_height *
        std::ceil(static_cast<double>(plot.bar_notes->names.size()) / static_cast<double>(in_row));
    if (has_row && left_over < least_height + height) return {Side::none, 0.0};
    const double rows = first_row + 1.4 * static_cast<double>(plot.bar_notes->names.size());
    if (side != Side::above && !plot.bar_notes->names.empty() && left_over < rows)
        return {Side::none, 0.0};
    return {side, width, is_short, has_row ? height : 0.0, in_row};
}

// On the line of the axis's name, each toward its own end.
void draw_counts_beyond(Canvas& canvas, const Frame& frame, const Plot& plot) {
    if (!plot.bar_notes) return;
    const BarNotes& notes = *plot.bar_notes;
    const DrawContext& dc = frame.dc;
    TextStyle style = label_style(dc);
    const double y = frame.area.bottom() + x_axis_space(axis_style(dc));
    double left = frame.area.x;
    if (!notes.below.empty())
        left += draw_text(canvas, {left, y}, "← " + notes.below, style).width + dc.unit;
    if (notes.above.empty()) return;
    const double right =
        frame.area.right() - dc.unit - measure_text(markup_of(plot.x.title, dc.theme), style).width;
    style.align = Align::right;
    std::string words = notes.above + (notes.beyond.empty() ? " →" : " " + notes.beyond + " →");
    if (measure_text(words, style).width > right - left) words = notes.above + " →";
    draw_text(canvas, {right, y}, words, style);
}

void draw_names(Canvas& canvas, const Frame& frame, const Plot& plot) {
    if (!plot.bar_notes || frame.notes.side == Side::none) return;
    const BarNotes& notes = *plot.bar_notes;
    const double u = frame.dc.unit;
    const bool is_short = are_short(frame, plot);
    for (std::size_t k = 0; k < notes.names.size(); ++k) {
        const BarNotes::Name& name = notes.names[k];
        const Point at = place_of_name(frame, plot, k, is_short);
        const std::string& words = name_of(name, is_short);
        draw_words(canvas, frame, {at.x + 0.6 * u, at.y}, escape_markup(words) + " " + name.number,
                   color_of(name.sample, frame.dc.theme));
        draw_straight(canvas, frame.dc, {at.x, at.y + 0.1 * u}, {at.x, at.y - 0.85 * u},
                      name.sample);
    }
}

}  // namespace carom::plot
