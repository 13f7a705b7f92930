#include "panels/plot/bar_notes.h"

#include <algorithm>
#include <cmath>

#include "draw/style.h"
#include "panels/plot/draw_bars.h"
#include "panels/plot/notes.h"

namespace carom::plot {
namespace {

constexpr double usual_width = 10.6;  // units, of a name and its number
// Units: from the top of the plot to the baseline of the first name, and from name to name.
constexpr double first_row = 1.05, next_row = 1.4;

using Side = PlaceOfNotes::Side;

const std::string& name_of(const BarNotes::Name& name, bool is_short) {
    return is_short && !name.short_name.empty() ? name.short_name : name.name;
}

// The width of a name with its mark and, if it has a number, with one of typical width.
double width_of(const DrawContext& dc, const BarNotes& notes, const BarNotes::Name& name,
                bool is_short) {
    std::string words = escape_markup(name_of(name, is_short));
    if (name.has_number) words += " " + notes.typical_number;
    return measure_text(words, label_style(dc)).width + 0.7 * dc.unit;
}

bool has_short_names(const Plot& plot) {
    return !plot.bar_notes->are_in_a_row &&
           std::ranges::none_of(plot.bar_notes->names,
                                [](const auto& name) { return name.short_name.empty(); });
}

// A name, and its number if it has one.
std::string words_of(const BarNotes::Name& name, bool is_short) {
    const std::string words = escape_markup(name_of(name, is_short));
    return name.number.empty() ? words : words + " " + name.number;
}

double width_of_names(const DrawContext& dc, const Plot& plot, bool is_short) {
    if (plot.bar_notes->names.empty()) return usual_width * dc.unit;
    const double numbers_waver = 0.6 * dc.unit;
    double width = 0.0;
    for (const BarNotes::Name& name : plot.bar_notes->names)
        width = std::max(width, width_of(dc, *plot.bar_notes, name, is_short) + numbers_waver);
    return width;
}

// Where the baseline of a name beside the bars is, in units; that after the last ends their place.
double row_of_name(std::size_t index) { return first_row + next_row * static_cast<double>(index); }

double height_of_names(const DrawContext& dc, const BarNotes& notes) {
    constexpr double after_last = 0.8;
    return (row_of_name(notes.names.size()) - after_last) * dc.unit;
}

// The place of all names at the top of an area, with the swatches before them.
Rect beside(const Rect& area, Side side, const DrawContext& dc, const BarNotes& notes,
            double width) {
    const double air = 0.3 * dc.unit;
    const double left = side == Side::left ? area.x + dc.unit : area.right() - width;
    return {left - air, area.y, width + air, height_of_names(dc, notes)};
}

// Whether a place is in the plot, and no bar and no curve ever reaches it.
bool is_ever_free(const Rect& place, const Frame& frame, const Plot& plot) {
    const BarNotes& notes = *plot.bar_notes;
    LabelPlacer placer(frame.area);
    const Frame seen{frame.dc, frame.area, frame.x_scale, frame.y_scale, frame.y_kind, placer};
    for (const AnyLayer& layer : plot.layers)
        if (common(layer).part == "curve") keep_clear_of(seen, layer);
    for (const BarNotes::Reach& bar : notes.highest) {
        const double top = frame.y(bar.value, Beyond::clamped), left = frame.x(bar.from);
        placer.keep_clear({left, top, frame.x(bar.to) - left, frame.area.bottom() - top});
    }
    return placer.is_inside(place) && placer.is_free(place);
}

Side side_of(const Plot& plot, const Frame& frame, double width) {
    const BarNotes& notes = *plot.bar_notes;
    if (!notes.may_be_beside) return Side::above;
    for (const Side side : {Side::right, Side::left})
        if (is_ever_free(beside(frame.area, side, frame.dc, notes, width), frame, plot))
            return side;
    return Side::above;
}

double left_end(const Frame& frame) {
    return frame.notes.side == Side::left ? frame.area.x + frame.dc.unit
                                          : frame.area.right() - frame.notes.width;
}

// The places of names above the bars: one after another, in as many rows as they need.
struct Rows {
    std::vector<Point> places = {};  ///< from the first; x in pixels, y in rows
    std::size_t count = 0;
};

Rows rows_of(const DrawContext& dc, const BarNotes& notes, bool is_short) {
    constexpr double before = 0.2, gap = 0.9;  // units
    Rows rows;
    double x = 0.0;
    for (const BarNotes::Name& name : notes.names) {
        const double width = width_of(dc, notes, name, is_short) + before * dc.unit;
        if (rows.count == 0 || x + width > dc.area.width) {
            ++rows.count;
            x = 0.0;
        }
        rows.places.push_back({x + before * dc.unit, static_cast<double>(rows.count - 1)});
        x += width + gap * dc.unit;
    }
    return rows;
}

Point place_of_name(const Frame& frame, const Plot& plot, std::size_t index, bool is_short) {
    const double u = frame.dc.unit;
    const BarNotes& notes = *plot.bar_notes;
    if (frame.notes.side != Side::above)
        return {left_end(frame), frame.area.y + row_of_name(index) * u};
    const Point& row = frame.row;
    const Point place = rows_of(frame.dc, notes, is_short).places.at(index);
    return {frame.dc.area.x + place.x, row.y + place.y * note_height * u};
}

}  // namespace

PlaceOfNotes place_of_notes(const Plot& plot, const Frame& frame) {
    if (!plot.bar_notes) return {};
    const DrawContext& dc = frame.dc;
    const BarNotes& notes = *plot.bar_notes;
    // Names of several choices are short beside the bars; above them, the row has room for more.
    bool is_short = notes.are_in_a_row;
    double width = width_of_names(dc, plot, is_short);
    Side side = side_of(plot, frame, width);
    if (side == Side::above && has_short_names(plot)) {
        const double short_width = width_of_names(dc, plot, true);
        side = side_of(plot, frame, short_width);
        is_short = side != Side::above;
        if (is_short) width = short_width;
    }
    const bool has_row = side == Side::above && !notes.names.empty();
    std::size_t rows = 1;
    if (has_row) {
        rows = rows_of(dc, notes, true).count;
        is_short = rows_of(dc, notes, false).count > rows;
        width = width_of_names(dc, plot, is_short);
    }
    const double left_over = plot_area(dc).height / dc.unit - height_of_rows(plot, dc, false);
    const double height = note_height * static_cast<double>(rows);
    if (has_row && left_over < least_height + height) return {Side::none, 0.0};
    const double in_plot = row_of_name(notes.names.size());
    if (side != Side::above && !notes.names.empty() && left_over < in_plot)
        return {Side::none, 0.0};
    return {side, width, is_short, has_row ? height : 0.0};
}

std::vector<Rect> places_of_names(const Frame& frame, const Plot& plot) {
    std::vector<Rect> places;
    if (!plot.bar_notes || frame.notes.side == Side::none) return places;
    const BarNotes& notes = *plot.bar_notes;
    const double u = frame.dc.unit;
    const bool is_short = frame.notes.is_short;
    for (std::size_t k = 0; k < notes.names.size(); ++k) {
        const Point at = place_of_name(frame, plot, k, is_short);
        const std::string words = words_of(notes.names[k], is_short);
        const double width = measure_text(words, label_style(frame.dc)).width;
        places.push_back({at.x - 0.2 * u, at.y - 0.95 * u, 0.8 * u + width, 1.25 * u});
    }
    return places;
}

namespace {

// At an end of the axis, over the bars: at the lowest place that is free.
void draw_count_at_end(Canvas& canvas, const Frame& frame, LabelPlacer& placer, Align align,
                       const std::vector<std::string>& words) {
    constexpr double lowest = 0.45, step = 0.6;  // units, over the axis
    const double u = frame.dc.unit;
    TextStyle style = label_style(frame.dc);
    style.align = align;
    const double x = align == Align::right ? frame.area.right() : frame.area.x + 0.4 * u;
    for (const std::string& one : words) {
        const double width = measure_text(one, style).width;
        const double left = align == Align::right ? x - width : x;
        for (double y = frame.area.bottom() - lowest * u; y > frame.area.y + u; y -= step * u) {
            const Rect rect{left - 0.2 * u, y - 0.95 * u, width + 0.4 * u, 1.25 * u};
            if (rect.x < frame.area.x || !placer.is_free(rect)) continue;
            placer.keep_clear(rect);
            draw_text(canvas, {x, y}, one, clear_of_grid(frame, style, rect));
            return;
        }
    }
    leave_out(words.back());
}

}  // namespace

// In the longest words that have room.
void draw_counts_beyond(Canvas& canvas, const Frame& frame, const Plot& plot) {
    if (!plot.bar_notes) return;
    const BarNotes& notes = *plot.bar_notes;
    if (notes.below.empty() && notes.above.empty()) return;
    LabelPlacer placer(frame.area);
    const Frame seen{frame.dc, frame.area, frame.x_scale, frame.y_scale, frame.y_kind, placer};
    for (const AnyLayer& layer : plot.layers) keep_clear_of(seen, layer);
    for (const Rect& name : places_of_names(frame, plot)) placer.keep_clear(name);
    for (const Rect& label : places_of_still_labels(frame, plot)) placer.keep_clear(label);
    if (!notes.below.empty())
        draw_count_at_end(canvas, frame, placer, Align::left, {"← " + notes.below});
    if (notes.above.empty()) return;
    std::vector<std::string> above{notes.above + " →"};
    if (!notes.beyond.empty()) above.insert(above.begin(), notes.above + " " + notes.beyond + " →");
    draw_count_at_end(canvas, frame, placer, Align::right, above);
}

void leave_out_names(const Frame& frame, const Plot& plot) {
    if (!plot.bar_notes || frame.notes.side != Side::none) return;
    for (const BarNotes::Name& name : plot.bar_notes->names) leave_out(words_of(name, false));
}

void draw_names(Canvas& canvas, const Frame& frame, const Plot& plot) {
    if (!plot.bar_notes) return;
    const BarNotes& notes = *plot.bar_notes;
    const double u = frame.dc.unit;
    const bool is_short = frame.notes.is_short, is_above = frame.notes.side == Side::above;
    LabelPlacer placer(frame.area);
    const Frame seen{frame.dc, frame.area, frame.x_scale, frame.y_scale, frame.y_kind, placer};
    if (!is_above)
        for (const AnyLayer& layer : plot.layers) keep_clear_of(seen, layer);
    const std::vector<Rect> places = places_of_names(frame, plot);
    for (std::size_t k = 0; k < places.size(); ++k) {
        const BarNotes::Name& name = notes.names[k];
        const std::string words = words_of(name, is_short);
        if (!is_above && !placer.is_free(places[k])) {
            leave_out(words);
            continue;
        }
        const Point at = place_of_name(frame, plot, k, is_short);
        TextStyle style = label_style(frame.dc);
        style.color = legible(color_of(name.swatch, frame.dc.theme), frame.dc.theme);
        style.max_width = frame.notes.width;
        draw_text(canvas, {at.x + 0.6 * u, at.y}, words, style);
        draw_straight(canvas, frame.dc, {at.x, at.y + 0.1 * u}, {at.x, at.y - 0.85 * u},
                      name.swatch);
    }
}

}  // namespace carom::plot
