// The layout of a plot: title, notes and axes around the area of the data, and the order of layers.
#include "panels/plot/draw_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "panels/plot/bar_notes.h"
#include "panels/plot/draw_bars.h"
#include "panels/plot/notes.h"

namespace carom::plot {
namespace {

constexpr double least_left = 3.0;         // for the labels of the vertical axis, units
constexpr double zero_place_height = 1.5;  // units
constexpr double height_of_ramp = 0.4, gap_over_ramp = 0.12;  // units
constexpr double gap_over_bars = 0.4;  // under notes, for the counts of bars that are cut, units
constexpr double thinnest = 0.8, widest = 1.6;  // of a plot beside a note, width over height

// The first of the wide titles that fits at full size, otherwise the first of the others that fits.
std::string title_of(const Plot& plot, const DrawContext& dc) {
    for (const Text& title : plot.wide_titles) {
        const std::string words = markup_of(title, dc.theme);
        if (measure_text(words, title_style(dc)).width <= dc.area.width) return words;
    }
    std::vector<std::string> titles;
    for (const Text& title : plot.titles) titles.push_back(markup_of(title, dc.theme));
    return fitting_title(dc, titles);
}

double space_of_ramp(const Plot& plot, const DrawContext& dc) {
    return plot.ramp ? (gap_over_ramp + height_of_ramp) * dc.unit : 0.0;
}

AxisStyle style_of(const Plot& plot, const Axis& axis, const DrawContext& dc) {
    AxisStyle style = axis_style(dc);
    if (&axis == &plot.x) style.below = space_of_ramp(plot, dc);
    if (&axis == &plot.y && axis.kind == Axis::Kind::linear) style.grid = dc.theme.grid;
    style.language = plot.language;
    style.whole = axis.is_whole;
    style.decades = axis.kind != Axis::Kind::linear;
    return style;
}

// Pixels per unit of data, the same on both axes.
double scale_in(const Rect& area, const Plot& plot) {
    return std::min(area.width / (plot.x.high - plot.x.low),
                    area.height / (plot.y.high - plot.y.low));
}

// The numbers that an axis shows along a scale of data.
Scale shown_scale(const Plot& plot, const Axis& axis, const Scale& data) {
    const double factor = unit_of(axis, plot.units).factor;
    if (factor == 1.0) return data;
    if (axis.kind != Axis::Kind::linear)
        return {data.low + std::log10(factor), data.high + std::log10(factor), data.from, data.to};
    return {factor * data.low, factor * data.high, data.from, data.to};
}

struct PlotArea {
    Rect rect;
    bool is_key_beside = false;
};

// The area of the data: under the title and the notes, and to the right of `left` pixels for the
// labels of the axis. A note that may be beside the plot is put there if this makes the plot
// larger.
PlotArea area_of(const Plot& plot, const DrawContext& dc, const PlaceOfNotes& place, double left) {
    const Rect whole = plot_area(dc);
    const auto under_notes = [&](bool is_key_beside) {
        Rect area = whole;
        double rows = height_of_rows(plot, dc, is_key_beside) + place.row;
        if (plot.bar_notes && rows > 0.0) rows += gap_over_bars;
        area.x += left;
        area.width -= left;
        area.y += rows * dc.unit;
        area.height = std::max(dc.unit, area.height - rows * dc.unit - space_of_ramp(plot, dc));
        return area;
    };
    const Rect under = under_notes(false);
    const auto key = std::ranges::find_if(plot.notes, &Note::may_be_beside);
    if (key == plot.notes.end()) return {under};
    Rect beside = under_notes(true);
    const double column = width_beside(*key, dc);
    const double ratio =
        std::clamp((plot.x.high - plot.x.low) / (plot.y.high - plot.y.low), thinnest, widest);
    beside.width = std::clamp(beside.width - column, 0.1 * dc.unit, ratio * beside.height);
    if (scale_in(beside, plot) > scale_in(under, plot)) return {beside, true};
    return {under};
}

// The scale of an axis between two positions: its own range, or a larger range in which a unit
// takes `scale` pixels.
Scale scale_of(const Axis& axis, double from, double to, std::optional<double> scale) {
    if (!scale) return {axis.low, axis.high, from, to};
    const double middle = 0.5 * (axis.low + axis.high), half = 0.5 * std::abs(to - from) / *scale;
    return {middle - half, middle + half, from, to};
}

}  // namespace

Frame frame_of(const Plot& plot, const DrawContext& dc, LabelPlacer& placer) {
    const double u = dc.unit;
    const auto equal_scale = [&](const Rect& area) {
        return plot.has_equal_scales ? std::optional(scale_in(area, plot)) : std::nullopt;
    };
    const auto scale_up = [&](const Rect& area) {
        const double floor =
            plot.y.has_zero_place ? std::min(0.3 * area.height, zero_place_height * u) : 0.0;
        return scale_of(plot.y, area.bottom() - floor, area.y, equal_scale(area));
    };
    const auto frame_in = [&](const PlaceOfNotes& place) {
        const double space =
            y_axis_space(shown_scale(plot, plot.y, scale_up(area_of(plot, dc, place, 0.0).rect)),
                         style_of(plot, plot.y, dc));
        const auto [area, is_key_beside] =
            area_of(plot, dc, place, std::max(0.0, space - least_left * u));
        const double row = first_note(plot, dc) + height_of_rows(plot, dc, is_key_beside) * u;
        return Frame{dc,
                     area,
                     scale_of(plot.x, area.x, area.right(), equal_scale(area)),
                     scale_up(area),
                     plot.y.kind,
                     placer,
                     place,
                     {area.x, row},
                     is_key_beside};
    };
    Frame frame = frame_in({});
    if (const PlaceOfNotes place = place_of_notes(plot, frame); plot.bar_notes) {
        Frame with_notes = frame_in(place);
        placer = LabelPlacer(with_notes.area);
        return with_notes;
    }
    placer = LabelPlacer(frame.area);
    return frame;
}

bool is_in_area(const Frame& frame, const Point& at) {
    constexpr double slack = 1.0;  // pixels
    const Rect& area = frame.area;
    return at.x >= area.x - slack && at.x <= area.right() + slack && at.y >= area.y - slack &&
           at.y <= area.bottom() + slack;
}

std::string x_title_of(const Plot& plot, const Frame& frame, const AxisStyle& style) {
    const std::string title = markup_of(plot.x.title, frame.dc.theme);
    if (plot.x.short_title.empty() ||
        keeps_labels(shown_scale(plot, plot.x, frame.x_scale), title, style))
        return title;
    return markup_of(plot.x.short_title, frame.dc.theme);
}

std::optional<Rect> place_of_y_title(const Plot& plot, const Frame& frame) {
    if (plot.y.title.empty()) return {};
    const double u = frame.dc.unit, x = frame.area.x + 0.4 * u;
    const double width =
        measure_text(markup_of(plot.y.title, frame.dc.theme), label_style(frame.dc)).width;
    if (x + width > frame.area.right()) return {};
    return Rect{x, frame.area.y - 1.3 * u, width, 1.25 * u};
}

namespace {

// On an axis of powers of ten, 0 has a separate place below, where the axis is broken.
void draw_zero_place(Canvas& canvas, const Frame& frame) {
    const double u = frame.dc.unit;
    const double middle = 0.5 * (frame.y_scale.from + frame.area.bottom());
    for (const double y : {middle - 0.14 * u, middle + 0.14 * u})
        canvas.stroke_line({frame.area.x - 0.35 * u, y + 0.12 * u},
                           {frame.area.x + 0.35 * u, y - 0.12 * u}, 0.07 * u, frame.dc.theme.muted);
    TextStyle style = label_style(frame.dc);
    style.align = Align::right;
    draw_text(canvas, {frame.area.x - 0.65 * u, frame.area.bottom() + 0.36 * u}, "0", style);
}

// Over the axis.
void draw_y_title(Canvas& canvas, const Frame& frame, const Plot& plot) {
    const std::string title = markup_of(plot.y.title, frame.dc.theme);
    if (const std::optional<Rect> place = place_of_y_title(plot, frame))
        draw_text(canvas, {place->x, frame.area.y - 0.35 * frame.dc.unit}, title,
                  label_style(frame.dc));
    else if (!plot.y.title.empty())
        leave_out(title);
}

void draw_ramp(Canvas& canvas, const Frame& frame, const Ramp& ramp) {
    const double u = frame.dc.unit;
    const Scale& x = frame.x_scale;
    draw_strip(
        canvas,
        {frame.area.x, frame.area.bottom() + gap_over_ramp * u, frame.area.width,
         height_of_ramp * u},
        [&](double share) { return ramp.color(std::lerp(x.low, x.high, share), frame.dc.theme); });
}

// The area over the place of 0, if there is one.
Rect area_of_scale(const Frame& frame) {
    Rect above = frame.area;
    above.height = frame.y_scale.from - frame.area.y;
    return above;
}

}  // namespace

std::vector<double> grid_of(const Frame& frame, const Plot& plot) {
    return grid_lines(area_of_scale(frame), shown_scale(plot, plot.y, frame.y_scale),
                      style_of(plot, plot.y, frame.dc));
}

namespace {

// With room for numbers that come later.
std::vector<Rect> still_words(const Frame& frame, const Plot& plot) {
    std::vector<Rect> words = places_of_still_labels(frame, plot, false);
    if (!plot.bar_notes) return words;
    const double number =
        measure_text(" " + plot.bar_notes->typical_number, label_style(frame.dc)).width;
    for (Rect name : places_of_names(frame, plot)) {
        name.width += number;
        words.push_back(name);
    }
    return words;
}

void draw_axes(Canvas& canvas, const Frame& frame, const Plot& plot) {
    const DrawContext& dc = frame.dc;
    if (plot.ramp) draw_ramp(canvas, frame, *plot.ramp);
    const AxisStyle style = style_of(plot, plot.x, dc);
    draw_x_axis(canvas, frame.area, shown_scale(plot, plot.x, frame.x_scale),
                x_title_of(plot, frame, style), style);
    AxisStyle upright = style_of(plot, plot.y, dc);
    upright.words = still_words(frame, plot);
    draw_y_axis(canvas, area_of_scale(frame), shown_scale(plot, plot.y, frame.y_scale), upright);
    if (plot.y.has_zero_place) draw_zero_place(canvas, frame);
    draw_y_title(canvas, frame, plot);
}

// Whether a frame shows nothing of a line yet.
bool is_hidden(const AnyLayer& layer) {
    const auto* line = std::get_if<Polyline>(&layer);
    return line != nullptr && line->shown.end == 0;
}

// Registers what the labels of a part must not overlap: for still labels, all that is shown in the
// film; for changing labels, what is shown now, and the still labels.
void keep_labels_clear(const Frame& frame, const Plot& plot, bool still) {
    if (!has_labels(plot, still)) return;
    if (still) return keep_clear_of_film(frame, plot, frame.placer);
    for (const AnyLayer& layer : plot.layers)
        if (!is_hidden(layer)) keep_clear_of(frame, layer);
    for (const Rect& label : places_of_still_labels(frame, plot)) frame.placer.place(label);
}

// Whether it changes the layout where the names of lines are.
bool depends_on_names(const Plot& plot) {
    return plot.bar_notes || std::ranges::any_of(plot.notes, [](const Note& note) {
               return note.of_last_titles > 0;
           });
}

// Where markers of a part leave gaps: at the words that have their places, and at those that layers
// will place.
std::vector<Rect> gaps_of(const Frame& frame, const std::vector<const AnyLayer*>& layers) {
    const auto is_marker = [](const AnyLayer* layer) {
        return std::holds_alternative<Marker>(*layer);
    };
    if (std::ranges::none_of(layers, is_marker)) return {};
    LabelPlacer placer = frame.placer;
    const Frame tried{frame.dc, frame.area, frame.x_scale, frame.y_scale, frame.y_kind, placer};
    for (const AnyLayer* layer : layers)
        if (const Label* label = label_of(*layer)) rect_of(tried, *label);
    return placer.placed();
}

}  // namespace

double Frame::y(double value, Beyond beyond) const {
    double power = value;
    if (y_kind == Axis::Kind::logarithmic) power = std::log10(std::max(value, 1e-300));
    if (y_kind == Axis::Kind::powers && !std::isfinite(value)) return area.bottom();
    const double y = y_scale(power);
    return beyond == Beyond::clamped ? std::clamp(y, area.y, y_scale.from) : y;
}

void draw_plot(Canvas& canvas, const DrawContext& dc, const Plot& plot, DrawnPart part) {
    const bool still = part == DrawnPart::still;
    if (plot.at_lines && (still || depends_on_names(plot)))
        return draw_plot(canvas, dc, with_names(plot, dc), part);
    LabelPlacer placer({});
    Frame frame = frame_of(plot, dc, placer);
    if (!still) frame.grid = grid_of(frame, plot);  // it has gaps for words that stand still
    if (still) {
        draw_panel_title(canvas, dc, title_of(plot, dc));
        draw_axes(canvas, frame, plot);
    }
    draw_notes(canvas, frame, plot, part);
    keep_labels_clear(frame, plot, still);
    const std::vector<const AnyLayer*> layers = layers_in_order(plot, still);
    frame.gaps = gaps_of(frame, layers);
    const auto last_bars = std::ranges::find_if(
        layers.rbegin(), layers.rend(),
        [](const AnyLayer* layer) { return std::holds_alternative<Bars>(*layer); });
    for (const AnyLayer* layer : layers) {
        std::visit([&](const auto& one) { draw_layer(canvas, frame, one); }, *layer);
        if (last_bars == layers.rend() || layer != *last_bars) continue;
        draw_over_bars(canvas, frame, plot);
        draw_counts_beyond(canvas, frame, plot);
    }
    if (last_bars != layers.rend()) draw_numbers_of_tall_bars(canvas, frame, plot);
    if (still)
        leave_out_names(frame, plot);
    else
        draw_names(canvas, frame, plot);
}

}  // namespace carom::plot
