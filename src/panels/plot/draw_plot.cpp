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

AxisStyle style_of(const Plot& plot, const Axis& axis, const DrawContext& dc) {
    AxisStyle style = axis_style(dc);
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
        area.height = std::max(dc.unit, area.height - rows * dc.unit);
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
    const PlaceOfNotes place = place_of_notes(plot, dc);
    const auto equal_scale = [&](const Rect& area) {
        return plot.has_equal_scales ? std::optional(scale_in(area, plot)) : std::nullopt;
    };
    const auto scale_up = [&](const Rect& area) {
        const double floor =
            plot.y.has_zero_place ? std::min(0.3 * area.height, zero_place_height * u) : 0.0;
        return scale_of(plot.y, area.bottom() - floor, area.y, equal_scale(area));
    };
    const double space =
        y_axis_space(scale_up(area_of(plot, dc, place, 0.0).rect), style_of(plot, plot.y, dc));
    const auto [area, is_key_beside] =
        area_of(plot, dc, place, std::max(0.0, space - least_left * u));
    placer = LabelPlacer(area);
    const double row = first_note(plot, dc) + height_of_rows(plot, dc, is_key_beside) * u;
    return {dc,
            area,
            scale_of(plot.x, area.x, area.right(), equal_scale(area)),
            scale_up(area),
            plot.y.kind,
            placer,
            place,
            {area.x, row},
            is_key_beside};
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

// Over the axis; one that has no room there is left out.
void draw_y_title(Canvas& canvas, const Frame& frame, const std::string& title) {
    const TextStyle style = label_style(frame.dc);
    const double x = frame.area.x + 0.4 * frame.dc.unit;
    if (x + measure_text(title, style).width <= frame.area.right())
        draw_text(canvas, {x, frame.area.y - 0.35 * frame.dc.unit}, title, style);
}

void draw_axes(Canvas& canvas, const Frame& frame, const Plot& plot) {
    const DrawContext& dc = frame.dc;
    const AxisStyle style = style_of(plot, plot.x, dc);
    std::string title = markup_of(plot.x.title, dc.theme);
    if (!plot.x.short_title.empty() &&
        measure_text(title, style.title).width > frame.area.right() - dc.area.x)
        title = markup_of(plot.x.short_title, dc.theme);
    draw_x_axis(canvas, frame.area, frame.x_scale, title, style);
    Rect above = frame.area;
    above.height = frame.y_scale.from - frame.area.y;
    draw_y_axis(canvas, above, frame.y_scale, style_of(plot, plot.y, dc));
    if (plot.y.has_zero_place) draw_zero_place(canvas, frame);
    if (!plot.y.title.empty()) draw_y_title(canvas, frame, markup_of(plot.y.title, dc.theme));
}

// Labels keep clear of the whole course of lines in the film, of levels and of some markers.
struct Obstacles {
    const Frame& frame;
    void operator()(const Line& line) const {
        std::optional<Point> before;
        for (std::size_t i = 0; i < line.x.size(); ++i) {
            const bool is_there = std::isfinite(line.y[i]);
            const Point now{frame.x(line.x[i]), is_there ? frame.y(line.y[i], line.beyond) : 0.0};
            if (!is_there) {
                before = {};
            } else if (!before || is_apart(*before, now, frame.pixels(0.1)) ||
                       i + 1 == line.x.size()) {
                if (before) frame.placer.keep_clear(*before, now);
                before = now;
            }
        }
    }
    void operator()(const Level& level) const {
        const double y = frame.y(level.value, Beyond::clamped);
        frame.placer.keep_clear({frame.area.x, y}, {frame.area.right(), y});
    }
    void operator()(const Marker& marker) const {
        const double x = frame.x(marker.value);
        if (marker.is_kept_clear)
            frame.placer.keep_clear({x, frame.area.y}, {x, frame.area.bottom()});
    }
    void operator()(const Layer&) const {}
};

// The words of a layer; nullptr: none.
const Label* label_of(const AnyLayer& layer) {
    const auto of = [](const auto& part) { return part && part->label ? &*part->label : nullptr; };
    if (const Label* level = of(std::get_if<Level>(&layer))) return level;
    if (const Label* marker = of(std::get_if<Marker>(&layer))) return marker;
    return std::get_if<Label>(&layer);
}

bool has_labels(const Plot& plot, bool still) {
    return std::ranges::any_of(plot.layers, [&](const AnyLayer& layer) {
        return common(layer).still == still && label_of(layer) != nullptr;
    });
}

// Layers of a part in the order in which they are drawn.
std::vector<const AnyLayer*> layers_of(const Plot& plot, bool still) {
    std::vector<const AnyLayer*> layers;
    for (const AnyLayer& layer : plot.layers)
        if (common(layer).still == still) layers.push_back(&layer);
    std::ranges::stable_sort(layers, std::ranges::greater{},
                             [](const AnyLayer* layer) { return common(*layer).depth; });
    return layers;
}

// Whether a frame shows nothing of a line yet.
bool is_hidden(const AnyLayer& layer) {
    const auto* line = std::get_if<Line>(&layer);
    return line != nullptr && line->shown.end == 0;
}

// Registers what the labels of a part must not overlap: for still labels, all that is shown in the
// film; for changing labels, what is shown now, and the still labels.
void keep_labels_clear(const Frame& frame, const Plot& plot, bool still) {
    if (!has_labels(plot, still)) return;
    LabelPlacer placer(frame.area);
    const Frame of_all{frame.dc,      frame.area,   frame.x_scale,
                       frame.y_scale, frame.y_kind, still ? frame.placer : placer};
    for (const AnyLayer& layer : plot.layers) {
        std::visit(Obstacles{of_all}, layer);
        if (!still && !is_hidden(layer)) std::visit(Obstacles{frame}, layer);
    }
    if (still) return;
    for (const AnyLayer* layer : layers_of(plot, true))
        if (const Label* label = label_of(*layer))
            if (const auto rect = rect_of(of_all, *label)) frame.placer.keep_clear(*rect);
}

}  // namespace

double Frame::y(double value, Beyond beyond) const {
    double power = value;
    if (y_kind == Axis::Kind::logarithmic) power = std::log10(std::max(value, 1e-300));
    if (y_kind == Axis::Kind::powers && !std::isfinite(value)) return area.bottom();
    const double y = y_scale(power);
    return beyond == Beyond::clamped ? std::clamp(y, area.y, y_scale.from) : y;
}

void draw_plot(Canvas& canvas, const DrawContext& dc, const Plot& plot, Part part) {
    LabelPlacer placer({});
    const Frame frame = frame_of(plot, dc, placer);
    const bool still = part == Part::still;
    if (still) {
        draw_panel_title(canvas, dc, title_of(plot, dc));
        draw_axes(canvas, frame, plot);
    }
    draw_notes(canvas, frame, plot, part);
    keep_labels_clear(frame, plot, still);
    const std::vector<const AnyLayer*> layers = layers_of(plot, still);
    const auto last_bars = std::ranges::find_if(
        layers.rbegin(), layers.rend(),
        [](const AnyLayer* layer) { return std::holds_alternative<Bars>(*layer); });
    for (const AnyLayer* layer : layers) {
        std::visit([&](const auto& one) { draw_layer(canvas, frame, one); }, *layer);
        if (last_bars == layers.rend() || layer != *last_bars) continue;
        draw_over_bars(canvas, frame, plot);
        draw_counts_beyond(canvas, frame, plot);
    }
    if (last_bars != layers.rend()) draw_counts_of_broken_bars(canvas, frame, plot);
    if (!still) draw_names(canvas, frame, plot);
}

}  // namespace carom::plot
