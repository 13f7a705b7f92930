// The layout of a plot: title, notes and axes around the area of the data, and the order of layers.
#include "panels/plot/draw_plot.h"

#include <algorithm>
#include <cmath>

#include "panels/plot/layers.h"

namespace carom::plot {
namespace {

constexpr double sample_width = 2.6, sample_gap = 0.5, entry_gap = 1.5;  // of notes, units
constexpr double first_baseline = 2.5;                                   // of notes, units
constexpr double least_left = 3.0;         // for the labels of the axis up, units
constexpr double zero_place_height = 1.5;  // units

double start_of_words(const KeyEntry& entry, const DrawContext& dc) {
    return entry.sample ? (sample_width + sample_gap) * dc.unit : 0.0;
}

// Which of its words an entry shows, and where it begins.
struct PlacedEntry {
    const KeyEntry* entry;
    std::size_t length;
    Point at;
    double width;
};

double width_of(const KeyEntry& entry, std::size_t length, const DrawContext& dc) {
    const Text& words = entry.words[std::min(length, entry.words.size() - 1)];
    return start_of_words(entry, dc) +
           measure_text(markup_of(words, dc.theme), label_style(dc)).width;
}

// From the left end of the first row's baseline.
std::vector<PlacedEntry> places(const Note& note, const DrawContext& dc) {
    std::size_t lengths = 1, length = 0;
    for (const KeyEntry& entry : note.entries) lengths = std::max(lengths, entry.words.size());
    const auto whole = [&] {
        double sum = -entry_gap * dc.unit;
        for (const KeyEntry& entry : note.entries)
            sum += width_of(entry, length, dc) + entry_gap * dc.unit;
        return sum;
    };
    while (length + 1 < lengths && whole() > dc.area.width) ++length;
    std::vector<PlacedEntry> placed;
    Point at{0.0, 0.0};
    for (const KeyEntry& entry : note.entries) {
        const double width = std::min(dc.area.width, width_of(entry, length, dc));
        if (note.wraps && at.x > 0.0 && at.x + width > dc.area.width)
            at = {0.0, at.y + note_height * dc.unit};
        placed.push_back({&entry, std::min(length, entry.words.size() - 1), at, width});
        at.x += width + entry_gap * dc.unit;
    }
    return placed;
}

// In units.
double height_of(const Note& note, const DrawContext& dc) {
    if (note.entries.empty()) return 0.0;
    return note_height + (note.wraps ? places(note, dc).back().at.y / dc.unit : 0.0);
}

double height_of_notes(const Plot& plot, const DrawContext& dc) {
    double sum = 0.0;
    for (const Note& note : plot.notes) sum += height_of(note, dc);
    return sum;
}

void draw_notes(Canvas& canvas, const DrawContext& dc, const Plot& plot) {
    double y = dc.area.y + first_baseline * dc.unit;
    for (const Note& note : plot.notes) {
        for (const PlacedEntry& one : places(note, dc)) {
            const Point left{dc.area.x + one.at.x, y + one.at.y};
            const double words = start_of_words(*one.entry, dc);
            if (one.entry->sample)
                draw_stroke(
                    canvas, dc,
                    std::array{Point{left.x, left.y - 0.35 * dc.unit},
                               Point{left.x + sample_width * dc.unit, left.y - 0.35 * dc.unit}},
                    *one.entry->sample);
            TextStyle style = label_style(dc);
            style.max_width =
                std::min(one.width - words + 0.1 * dc.unit, dc.area.width - one.at.x - words);
            draw_text(canvas, {left.x + words, left.y},
                      markup_of(one.entry->words[one.length], dc.theme), style);
        }
        y += height_of(note, dc) * dc.unit;
    }
}

AxisStyle style_of(const Axis& axis, const DrawContext& dc) {
    AxisStyle style = axis_style(dc);
    style.whole = axis.is_whole;
    return style;
}

bool is_linear(const Axis& axis) { return axis.kind == Axis::Kind::linear; }

// Where the data lie: under the title and the notes, left and above the axes' labels.
Frame frame_of(const Plot& plot, const DrawContext& dc, LabelPlacer& placer) {
    const double u = dc.unit;
    Rect area = plot_area(dc);
    const double notes = height_of_notes(plot, dc) * u;
    area.y += notes;
    area.height = std::max(u, area.height - notes);
    const double floor =
        plot.y.has_zero_place ? std::min(0.3 * area.height, zero_place_height * u) : 0.0;
    const Scale up{plot.y.low, plot.y.high, area.bottom() - floor, area.y};
    const AxisStyle style = style_of(plot.y, dc);
    const double space = is_linear(plot.y) ? y_axis_space(up, style) : log_y_axis_space(up, style);
    const double more = std::max(0.0, space - least_left * u);
    area.x += more;
    area.width -= more;
    placer = LabelPlacer(area);
    return {dc, area, {plot.x.low, plot.x.high, area.x, area.right()}, up, plot.y.kind, placer};
}

// No power of ten is 0: it has a place of its own under the axis, which is broken there.
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

void draw_axes(Canvas& canvas, const Frame& frame, const Plot& plot) {
    const DrawContext& dc = frame.dc;
    draw_x_axis(canvas, frame.area, frame.x_scale, markup_of(plot.x.title, dc.theme),
                style_of(plot.x, dc));
    Rect above = frame.area;
    above.height = frame.y_scale.from - frame.area.y;
    if (is_linear(plot.y))
        draw_y_axis(canvas, above, frame.y_scale, "", style_of(plot.y, dc));
    else
        draw_log_y_axis(canvas, above, frame.y_scale, "", style_of(plot.y, dc));
    if (plot.y.has_zero_place) draw_zero_place(canvas, frame);
    if (!plot.y.title.empty())
        draw_text(canvas, {frame.area.x + 0.4 * dc.unit, frame.area.y - 0.1 * dc.unit},
                  markup_of(plot.y.title, dc.theme), label_style(dc));
}

// Labels keep clear of all that lines will show in the film, and of levels.
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
    void operator()(const Layer&) const {}
};

bool has_labels(const Plot& plot, bool still) {
    return std::ranges::any_of(plot.layers, [&](const AnyLayer& layer) {
        if (common(layer).still != still) return false;
        if (const auto* level = std::get_if<Level>(&layer)) return level->label.has_value();
        if (const auto* marker = std::get_if<Marker>(&layer)) return marker->label.has_value();
        return std::holds_alternative<Label>(layer);
    });
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
        std::vector<std::string> titles;
        for (const Text& title : plot.titles) titles.push_back(markup_of(title, dc.theme));
        draw_panel_title(canvas, dc, fitting_title(dc, titles));
        draw_notes(canvas, dc, plot);
        draw_axes(canvas, frame, plot);
    }
    if (has_labels(plot, still))
        for (const AnyLayer& layer : plot.layers) std::visit(Obstacles{frame}, layer);
    std::vector<const AnyLayer*> layers;
    for (const AnyLayer& layer : plot.layers)
        if (common(layer).still == still) layers.push_back(&layer);
    std::ranges::stable_sort(layers, std::ranges::greater{},
                             [](const AnyLayer* layer) { return common(*layer).depth; });
    for (const AnyLayer* layer : layers)
        std::visit([&](const auto& one) { draw_layer(canvas, frame, one); }, *layer);
}

}  // namespace carom::plot
