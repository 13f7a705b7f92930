// The layout of a plot: title, notes and axes around the area of the data, and the order of layers.
#include "panels/plot/draw_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "panels/plot/bar_notes.h"
#include "panels/plot/draw_bars.h"

namespace carom::plot {
namespace {

constexpr double sample_gap = 0.5, entry_gap = 1.5;  // of notes, units
constexpr double narrow_gap = 0.5;         // between entries that are in one row for want of room
constexpr double first_baseline = 2.5;     // of notes, units
constexpr double least_left = 3.0;         // for the labels of the axis up, units
constexpr double zero_place_height = 1.5;  // units
constexpr double sample_over_plot = 2.4;   // of notes that begin at the plot's edge, units
constexpr double gap_over_bars = 0.4;  // under notes, for the counts of bars that are cut, units
constexpr double gap_beside = 1.4;     // between a plot and the note beside it, units
constexpr double most_rows = 0.45;     // of the height, that a note takes which may be beside
constexpr double thinnest = 0.8, widest = 1.6;  // of a plot beside a note, width over height

// How much lower rows of words stand over bars.
double drop_over_bars(const Plot& plot, const DrawContext& dc) {
    return plot.bar_notes ? 0.3 * dc.unit : 0.0;
}

// Marks are narrower than other samples.
double sample_of(const Note& note, const KeyEntry& entry, const DrawContext& dc) {
    if (entry.sample || !entry.arrows.empty()) return note.sample_width * dc.unit;
    return entry.mark ? 2.5 * entry.mark->radius * dc.unit : 0.0;
}

double width_of(const Text& words, const DrawContext& dc) {
    return measure_text(markup_of(words, dc.theme), label_style(dc)).width;
}

const Text& words_of(const KeyEntry& entry, std::size_t length) {
    return entry.words[std::min(length, entry.words.size() - 1)];
}

// Which of its words an entry shows, and where it begins.
struct PlacedEntry {
    const KeyEntry* entry;
    std::size_t length;
    Point at;  // of the baseline
    double sample, width;
};

// With its sample as wide as given, or as it is by itself.
PlacedEntry measured(const Note& note, const KeyEntry& entry, std::size_t length,
                     const DrawContext& dc, std::optional<double> sample_width = {}) {
    const double sample = sample_width.value_or(sample_of(note, entry, dc));
    const double gap = sample > 0.0 ? sample_gap * dc.unit : 0.0;
    const Text& words = entry.longest ? *entry.longest : words_of(entry, length);
    return {&entry, length, {}, sample, sample + gap + width_of(words, dc)};
}

// Makes the widest of them narrower, until all have room side by side.
void squeeze(std::vector<PlacedEntry>& row, double room) {
    std::vector<double> widths;
    for (const PlacedEntry& one : row) widths.push_back(one.width);
    std::ranges::sort(widths);
    double most = room;
    for (std::size_t i = 0; i < widths.size(); ++i) {
        most = room / static_cast<double>(widths.size() - i);
        if (widths[i] > most) break;
        room -= widths[i];
    }
    for (PlacedEntry& one : row) one.width = std::min(one.width, most);
}

// All in one row, the ends of some words cut off; none where too little of them would be left.
std::vector<PlacedEntry> places_in_one_row(const Note& note, const DrawContext& dc, Point start) {
    constexpr double most_cut = 0.1;  // of all words
    std::vector<PlacedEntry> placed;
    double whole = 0.0;
    for (const KeyEntry& entry : note.entries) {
        placed.push_back(measured(note, entry, entry.words.size() - 1, dc));
        whole += placed.back().width;
    }
    const double gap = narrow_gap * dc.unit;
    const double room = dc.area.width - gap * static_cast<double>(placed.size() - 1);
    if (room < (1.0 - most_cut) * whole) return {};
    squeeze(placed, room);
    for (PlacedEntry& one : placed) {
        one.at = start;
        start.x += one.width + gap;
    }
    return placed;
}

// In rows, from the left end of the first one's baseline.
std::vector<PlacedEntry> places(const Note& note, const DrawContext& dc, Point start = {}) {
    std::size_t lengths = 1, length = 0;
    for (const KeyEntry& entry : note.entries) lengths = std::max(lengths, entry.words.size());
    const auto whole = [&] {
        double sum = -entry_gap * dc.unit;
        for (const KeyEntry& entry : note.entries)
            sum += measured(note, entry, length, dc).width + entry_gap * dc.unit;
        return sum;
    };
    while (length + 1 < lengths && whole() > dc.area.width) ++length;
    std::vector<PlacedEntry> placed;
    Point at;
    for (const KeyEntry& entry : note.entries) {
        PlacedEntry one = measured(note, entry, length, dc);
        one.width = std::min(dc.area.width, one.width);
        if (note.wraps && at.x > 0.0 && at.x + one.width > dc.area.width)
            at = {0.0, at.y + note_height * dc.unit};
        if (note.may_be_beside && at.y > most_rows * plot_area(dc).height) break;
        one.at = {start.x + at.x, start.y + at.y};
        at.x += one.width + entry_gap * dc.unit;
        placed.push_back(one);
    }
    return placed;
}

// The same for a column, in which words begin at one place; and the width that the column takes.
std::pair<std::vector<PlacedEntry>, double> column_of(const Note& note, const DrawContext& dc) {
    std::vector<PlacedEntry> entries;
    double width = 0.0;
    for (const KeyEntry& entry : note.entries) {
        entries.push_back(measured(note, entry, 0, dc, note.sample_width * dc.unit));
        width = std::max(width, entries.back().width + gap_beside * dc.unit);
    }
    return {std::move(entries), width};
}

// In columns right of an area, as many as there is room for.
std::vector<PlacedEntry> places_beside(const Note& note, const DrawContext& dc, const Rect& area) {
    const double u = dc.unit;
    auto [placed, width] = column_of(note, dc);
    Point at{area.right() + gap_beside * u, area.y + u};
    for (std::size_t i = 0; i < placed.size(); ++i, at.y += note_height * u) {
        if (at.y > area.bottom()) at = {at.x + width, area.y + u};
        if (at.x + placed[i].width > dc.area.right() + 1e-6) {
            placed.resize(i);
            break;
        }
        placed[i].at = at;
    }
    return placed;
}

// The height of its rows, units.
double height_of(const Note& note, const DrawContext& dc) {
    if (note.entries.empty()) return note.changes ? note_height : 0.0;
    const std::vector<PlacedEntry> placed = places(note, dc);
    return note_height + (placed.empty() ? 0.0 : placed.back().at.y / dc.unit);
}

// Whether all but the last of the titles are too long.
bool has_short_title(const Plot& plot, const DrawContext& dc) {
    const auto fits = [&](const Text& title, TextStyle style) {
        return measure_text(markup_of(title, dc.theme), style).width <= dc.area.width;
    };
    const TextStyle full = title_style(dc);
    TextStyle small = full;
    small.size = dc.unit;
    for (const Text& title : plot.wide_titles)
        if (fits(title, full)) return false;
    for (std::size_t i = 0; i + 1 < plot.titles.size(); ++i)
        if (fits(plot.titles[i], small)) return false;
    return true;
}

struct ShownNote {
    const Note* note;
    double height;       // units
    bool is_in_one_row;  // although it wraps: there is no room for more
};

// The notes that are drawn: those for which the title leaves no room, and as many as leave room to
// the data. A key whose rows do not is cut to one: lines that have no names tell nothing.
std::vector<ShownNote> notes_of(const Plot& plot, const DrawContext& dc) {
    double room = plot_area(dc).height / dc.unit - least_height;
    std::vector<ShownNote> notes;
    for (const Note& note : plot.notes) {
        if (note.is_of_short_title && !has_short_title(plot, dc)) continue;
        ShownNote shown{&note, height_of(note, dc), false};
        if (!note.may_be_beside && shown.height > room) {
            const bool is_key = note.wraps && note.is_of_short_title && note.entries.size() > 1;
            if (!is_key || note_height > room || places_in_one_row(note, dc, {}).empty()) continue;
            shown = {&note, note_height, true};
        }
        room -= shown.height;
        notes.push_back(shown);
    }
    return notes;
}

}  // namespace

double height_of_rows(const Plot& plot, const DrawContext& dc, bool is_key_beside) {
    double sum = 0.0;
    for (const ShownNote& shown : notes_of(plot, dc))
        if (!(shown.note->may_be_beside && is_key_beside)) sum += shown.height;
    return sum;
}

namespace {

// One entry at the left edge of the plot, its sample left of that.
void draw_note_over_plot(Canvas& canvas, const Frame& frame, const Note& note, double y) {
    const DrawContext& dc = frame.dc;
    TextStyle style = label_style(dc);
    style.max_width = frame.area.width;
    for (const KeyEntry& entry : note.entries) {
        const double end = frame.area.x - sample_gap * dc.unit, middle = y - 0.35 * dc.unit;
        if (entry.sample)
            draw_stroke(
                canvas, dc,
                std::array{Point{end - sample_over_plot * dc.unit, middle}, Point{end, middle}},
                *entry.sample);
        std::string words;
        for (const Text& text : entry.words) {  // a little more room, as its numbers change
            words = markup_of(text, dc.theme);
            if (measure_text(words + "00", label_style(dc)).width <= style.max_width) break;
        }
        draw_text(canvas, {frame.area.x, y}, words, style);
    }
}

// A line, a mark in its middle, arrows over it.
void draw_sample(Canvas& canvas, const DrawContext& dc, const PlacedEntry& placed) {
    const KeyEntry& entry = *placed.entry;
    const double y = placed.at.y - 0.35 * dc.unit;
    const auto along = [&](double share) { return Point{placed.at.x + share * placed.sample, y}; };
    if (entry.sample) draw_stroke(canvas, dc, std::array{along(0.0), along(1.0)}, *entry.sample);
    if (entry.mark) draw_mark(canvas, dc, along(0.5), *entry.mark);
    for (const Arrow& arrow : entry.arrows)
        draw_arrow(canvas, dc, along(arrow.from.x), along(arrow.to.x), arrow);
}

void draw_note(Canvas& canvas, const Frame& frame, const std::vector<PlacedEntry>& placed) {
    const DrawContext& dc = frame.dc;
    for (const PlacedEntry& one : placed) {
        draw_sample(canvas, dc, one);
        const double words = one.sample > 0.0 ? one.sample + sample_gap * dc.unit : 0.0;
        TextStyle style = label_style(dc);
        style.max_width =
            std::min(one.width - words + 0.1 * dc.unit, dc.area.right() - one.at.x - words);
        draw_text(canvas, {one.at.x + words, one.at.y},
                  markup_of(words_of(*one.entry, one.length), dc.theme), style);
        frame.placer.keep_clear(Rect{one.at.x, one.at.y - 0.9 * dc.unit,
                                     one.width + entry_gap * dc.unit, 1.2 * dc.unit});
    }
}

void draw_notes(Canvas& canvas, const Frame& frame, const Plot& plot, Part part) {
    const DrawContext& dc = frame.dc;
    double y = dc.area.y + first_baseline * dc.unit + drop_over_bars(plot, dc);
    for (const ShownNote& shown : notes_of(plot, dc)) {
        const Note& note = *shown.note;
        const bool is_beside = note.may_be_beside && frame.is_key_beside;
        if (note.changes == (part == Part::changing)) {
            if (note.is_over_plot)
                draw_note_over_plot(canvas, frame, note, y);
            else
                draw_note(canvas, frame,
                          is_beside             ? places_beside(note, dc, frame.area)
                          : shown.is_in_one_row ? places_in_one_row(note, dc, {dc.area.x, y})
                                                : places(note, dc, {dc.area.x, y}));
        }
        if (!is_beside) y += shown.height * dc.unit;
    }
}

// The first of the wide titles that is not cut at full size, else of the others.
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

// Pixels of a unit of data, the same on both axes.
double scale_in(const Rect& area, const Plot& plot) {
    return std::min(area.width / (plot.x.high - plot.x.low),
                    area.height / (plot.y.high - plot.y.low));
}

struct PlotArea {
    Rect rect;
    bool is_key_beside = false;
};

// Under the title and the notes, right of so much for the labels of the axis; the note that may be
// beside is, where that leaves more of the area.
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
    const double column = column_of(*key, dc).second;
    const double ratio =
        std::clamp((plot.x.high - plot.x.low) / (plot.y.high - plot.y.low), thinnest, widest);
    beside.width = std::clamp(beside.width - column, 0.1 * dc.unit, ratio * beside.height);
    if (scale_in(beside, plot) > scale_in(under, plot)) return {beside, true};
    return {under};
}

// What an axis shows between two places: what it says, or more, so that a unit takes `scale`.
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
    const double row = dc.area.y + first_baseline * u + drop_over_bars(plot, dc) +
                       height_of_rows(plot, dc, is_key_beside) * u;
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

// Labels keep clear of all that lines will show in the film, of levels and of some markers.
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

// What the labels of a part must not lie on: those that stand still, on nothing that is shown in
// the film; those that change, on nothing that is shown now, nor on those that stand still.
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
