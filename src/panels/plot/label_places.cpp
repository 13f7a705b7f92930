// Where words stand that are the same in every frame, names of lines among them, what room in a
// plot is free in the whole film, and where a point of a plot is.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "panels/plot/bar_notes.h"
#include "panels/plot/draw_plot.h"
#include "panels/plot/layers.h"

namespace carom::plot {

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

std::vector<const AnyLayer*> layers_in_order(const Plot& plot, bool still) {
    std::vector<const AnyLayer*> layers;
    for (const AnyLayer& layer : plot.layers)
        if (common(layer).still == still) layers.push_back(&layer);
    std::ranges::stable_sort(layers, std::ranges::greater{},
                             [](const AnyLayer* layer) { return common(*layer).depth; });
    return layers;
}

namespace {

// All but words, with the highest that bars ever reach.
void keep_clear_of_data(const Frame& frame, const Plot& plot, LabelPlacer& placer) {
    const Frame of_all{frame.dc, frame.area, frame.x_scale, frame.y_scale, frame.y_kind, placer};
    for (std::size_t k = 0; k < plot.layers.size(); ++k) {
        const AnyLayer& layer = plot.layers[k];
        if (std::holds_alternative<Bars>(layer)) continue;
        const auto* line = std::get_if<Polyline>(&layer);
        if (line != nullptr && line->head) placer.set_line(k);
        keep_clear_of(of_all, layer);
        placer.set_line({});
    }
    if (!plot.bar_notes) return;
    for (const BarNotes::Reach& bar : plot.bar_notes->highest) {
        const double top = frame.y(bar.value, Beyond::clamped), left = frame.x(bar.from);
        placer.keep_clear({left, top, frame.x(bar.to) - left, frame.area.bottom() - top});
    }
}

// The names over bars, which have numbers later.
std::vector<Rect> room_of_names(const Frame& frame, const Plot& plot) {
    std::vector<Rect> names = places_of_names(frame, plot);
    for (Rect& name : names) name.width = std::max(name.width, frame.area.right() - name.x);
    return names;
}

}  // namespace

void keep_clear_of_film(const Frame& frame, const Plot& plot, LabelPlacer& placer) {
    keep_clear_of_data(frame, plot, placer);
    for (const Rect& name : room_of_names(frame, plot)) placer.keep_clear(name);
}

std::vector<Rect> places_of_still_labels(const Frame& frame, const Plot& plot, bool with_arriving) {
    std::vector<Rect> places;
    if (!has_labels(plot, true)) return places;
    LabelPlacer placer(frame.area);
    keep_clear_of_film(frame, plot, placer);
    const Frame of_all{frame.dc, frame.area, frame.x_scale, frame.y_scale, frame.y_kind, placer};
    for (const AnyLayer* layer : layers_in_order(plot, true))
        if (const Label* label = label_of(*layer))
            if (const auto rect = rect_of(of_all, *label); rect && (with_arriving || !label->line))
                places.push_back(*rect);
    return places;
}

namespace {

constexpr int depth_after_names = -1;

bool is_name(const AnyLayer& layer) {
    const auto* label = std::get_if<Label>(&layer);
    return label != nullptr && label->is_name;
}

// Whether all names have places, and with them the words of levels if these come after them.
bool all_names_stand(const Plot& plot, const DrawContext& dc) {
    LabelPlacer placer({});
    const Frame frame = frame_of(plot, dc, placer);
    keep_clear_of_film(frame, plot, placer);
    for (const AnyLayer* layer : layers_in_order(plot, true)) {
        const Label* label = label_of(*layer);
        if (label == nullptr || rect_of(frame, *label)) continue;
        const bool is_after = common(*layer).depth == depth_after_names;
        if ((label->is_name && label->swatch) || (label->level && is_after)) return false;
    }
    return true;
}

}  // namespace

Plot with_names(const Plot& plot, const DrawContext& dc) {
    Plot named = plot;
    if (!plot.at_lines) return named;
    named.at_lines.reset();
    named.titles = plot.at_lines->titles;
    named.wide_titles.clear();
    if (!named.y.is_titled_by_scene) named.y.title = {};
    std::erase_if(named.notes, [](const Note& note) { return note.of_last_titles > 0; });
    const std::vector<std::string>& means = plot.at_lines->means;
    for (std::size_t k = 0; named.bar_notes && k < means.size(); ++k) {
        BarNotes::Name& name = named.bar_notes->names.at(k);
        name.name = name.short_name = means[k];
    }
    if (all_names_stand(named, dc)) return named;
    for (AnyLayer& layer : named.layers)  // names first: levels have more places
        if (auto* level = std::get_if<Level>(&layer)) level->depth = depth_after_names;
    if (all_names_stand(named, dc)) return named;
    named = plot;
    named.at_lines.reset();
    std::erase_if(named.layers, is_name);
    return named;
}

namespace {

bool arrives(const AnyLayer& layer) {
    const Label* label = label_of(layer);
    return label != nullptr && label->line;
}

}  // namespace

Plot with_fixed_names(const Plot& whole, const DrawContext& dc) {
    if (std::ranges::none_of(whole.layers, arrives)) return {};
    Plot plot = with_names(whole, dc);
    LabelPlacer placer({});
    const Frame frame = frame_of(plot, dc, placer);
    keep_clear_of_film(frame, plot, placer);
    std::vector<AnyLayer> names;
    for (const AnyLayer* layer : layers_in_order(plot, true)) {
        const Label* label = label_of(*layer);
        if (label == nullptr) continue;
        if (label->line)
            names.emplace_back(fixed_label(frame, *label));
        else
            rect_of(frame, *label);
    }
    plot.layers = std::move(names);
    return plot;
}

void draw_arriving_names(Canvas& canvas, const DrawContext& dc, const Plot& whole,
                         const Plot& now) {
    if (std::ranges::none_of(whole.layers, arrives)) return;
    LabelPlacer placer({});
    Frame frame = frame_of(whole, dc, placer);
    frame.grid = grid_of(frame, whole);
    for (const AnyLayer& layer : whole.layers) {
        const auto& label = std::get<Label>(layer);
        draw_arriving(canvas, frame, label, std::get<Polyline>(now.layers.at(*label.line)));
    }
}

bool FreeRoom::is_free(const Rect& part) const {
    return taken.is_inside(part) && taken.is_free(part) &&
           std::ranges::none_of(words, [&](const Rect& one) { return overlap(one, part); });
}

bool FreeRoom::is_free(const Point& from, const Point& to) const {
    return std::ranges::none_of(words, [&](const Rect& one) { return meets(one, from, to); });
}

double FreeRoom::top_at(double x) const {
    double y = area.y;
    while (y < area.bottom() && taken.is_free({x, y, 1.0, 1.0})) y += 1.0;
    return y;
}

FreeRoom free_room(const DrawContext& dc, const Plot& whole) {
    const Plot plot = with_names(whole, dc);
    FreeRoom room{{}, LabelPlacer({}), {}};
    const Frame frame = frame_of(plot, dc, room.taken);
    const double u = dc.unit;
    room.area = frame.area;
    room.words = places_of_still_labels(frame, plot);
    keep_clear_of_data(frame, plot, room.taken);
    std::ranges::copy(room_of_names(frame, plot), std::back_inserter(room.words));
    const double left = dc.area.x, bottom = frame.area.bottom();
    room.words.push_back({left, dc.area.y, dc.area.width, 1.4 * u});               // the title
    room.words.push_back({left, bottom + 2.0, dc.area.width, dc.area.height});     // under the axis
    room.words.push_back({left, bottom - 0.7 * u, frame.area.x - left, 1.4 * u});  // its number
    for (const double y : grid_of(frame, plot))
        room.words.push_back({left, y - 0.6 * u, frame.area.x - left, 1.2 * u});
    return room;
}

namespace {

using Height = std::optional<double>;

Height highest(Height a, Height b) {
    if (!a || !b) return a ? a : b;
    return std::max(*a, *b);
}

Height height_at(const Bars& bars, double x) {
    for (std::size_t i = 0; i < bars.value.size(); ++i)
        if (bars.from[i] <= x && x < bars.to[i]) return bars.value[i];
    return {};
}

// Interpolates between the points on either side.
Height height_at(const Polyline& line, double x) {
    Height highest_there;
    const std::size_t end = std::min(line.shown.end, line.x.size());
    for (std::size_t i = line.shown.first + 1; i < end; ++i) {
        const double a = line.x[i - 1], b = line.x[i];
        if (x < std::min(a, b) || x > std::max(a, b)) continue;
        const double share = a == b ? 1.0 : (x - a) / (b - a);
        const double y = line.y[i - 1] + share * (line.y[i] - line.y[i - 1]);
        if (std::isfinite(y)) highest_there = highest(highest_there, y);
    }
    return highest_there;
}

// Bars take precedence over lines: a theoretical curve over them is not the measurement.
Height top_at(const Plot& plot, double x) {
    Height bars, lines;
    for (const AnyLayer& layer : plot.layers) {
        if (const auto* its = std::get_if<Bars>(&layer)) bars = highest(bars, height_at(*its, x));
        if (const auto* its = std::get_if<Polyline>(&layer))
            lines = highest(lines, height_at(*its, x));
    }
    return bars ? bars : lines;
}

bool is_within(double value, double a, double b) {
    return value >= std::min(a, b) - 1.0 && value <= std::max(a, b) + 1.0;
}

}  // namespace

std::optional<Point> place_in(const DrawContext& dc, const Plot& plot, double x,
                              std::optional<double> y) {
    if (plot.at_lines) return place_in(dc, with_names(plot, dc), x, y);
    LabelPlacer placer(Rect{});
    const Frame frame = frame_of(plot, dc, placer);
    const double across = frame.x(plot.x.kind == Axis::Kind::logarithmic ? std::log10(x) : x);
    if (!is_within(across, frame.area.x, frame.area.right())) return std::nullopt;
    if (!y) y = top_at(plot, x);
    const double up = y ? frame.y(*y) : frame.area.y + 0.5 * frame.area.height;
    return Point{across, std::clamp(up, frame.area.y, frame.area.bottom())};
}

}  // namespace carom::plot
