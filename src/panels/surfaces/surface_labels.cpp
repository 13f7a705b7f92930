// The words about surfaces in the picture.
#include <algorithm>
#include <vector>

#include "panels/surfaces/surface_brush.h"
#include "panels/surfaces/surface_strokes.h"
#include "panels/surfaces/surface_words.h"
#include "scene/describe.h"
#include "util/text.h"

namespace carom {

// The part of the label of the lower or the upper side that fits beside its arrow, or beyond the
// side: all of it, or only its last part. The arrow is shifted if necessary.
SurfaceView::Brush::SideLabel SurfaceView::Brush::label_beside(std::size_t side) const {
    if (is_upright(side)) return {};
    const std::string all = label_of_surface(view.language_, view.gas_, behaviour(side), 1);
    const auto* piston = piston_of(behaviour(side));
    const bool has_arrow = piston != nullptr && piston->force != 0.0;
    const double taken = has_arrow ? 1.8 * u : 0.0;
    const std::size_t comma = all.rfind(", ");
    const std::string last = comma == std::string::npos ? all : all.substr(comma + 2);
    for (const std::string& words : {all, last}) {
        const double width = measure_text(escape_markup(words), label_style(dc)).width;
        if (width + taken > room.width) continue;
        const double excess = has_arrow ? 0.5 * taken + width - room.width / 2 : 0.0;
        return {words, has_arrow, std::max(0.0, excess)};
    }
    return {"", has_arrow, 0.0};
}

void SurfaceView::Brush::draw_side_label(std::size_t side) const {
    const auto [words, has_arrow, shift] = label_beside(side);
    if (words.empty()) return;
    TextStyle style = label_style(dc);
    style.color = label_color(side);
    style.align = has_arrow ? Align::left : Align::center;
    const double from = bath_of(behaviour(side)) ? SurfaceSize::bath : SurfaceSize::bar;
    const Rect band =
        outside(side, from * u, (has_arrow ? SurfaceSize::arrow : SurfaceSize::label) * u);
    draw_text(canvas,
              {band.x + band.width / 2 + (has_arrow ? 0.9 * u - shift : 0.0),
               band.y + band.height / 2 + 0.36 * u},
              escape_markup(words), style);
}

// The baseline of words from one place to another that stand on the end of a side at the left or
// the right: over the upper side or, where the words of that are, over these.
double SurfaceView::Brush::row_over_side(double from, double to) const {
    const double row = view.whole(map, u).y + 1.05 * u;
    if (moves(behaviour(top_side))) return row;  // the sides reach to where it moves
    const auto [words, has_arrow, shift] = label_beside(top_side);
    if (!words.empty() || has_arrow) {
        const double width = measure_text(escape_markup(words), label_style(dc)).width;
        const double middle = room.x + room.width / 2, half = 0.5 * SurfaceSize::arrow * u;
        const double left = has_arrow ? middle - shift - half : middle - width / 2;
        const double right = has_arrow ? middle - shift + half + width : middle + width / 2;
        if (from < right + 0.5 * u && to > left - 0.5 * u) return row;
    }
    const double hatch = is_imposed(top_side) ? SurfaceSize::hatch : 0.0;
    return std::max(row, room.y - (thickness(top_side) + hatch + 0.45) * u);
}

// A heat bath's words have its colour, in print that of all words.
Color SurfaceView::Brush::label_color(std::size_t k) const {
    const auto* bath = bath_of(behaviour(k));
    if (theme.kind == ThemeKind::print) return theme.ink;
    return bath != nullptr ? legible(bath_color(*bath), theme) : theme.ink;
}

// Of a sheet in space: "back: T = 2", "lid: z = 3".
std::string SurfaceView::Brush::words_in_space(std::size_t k) const {
    const Language language = view.language_;
    if (states[k].is_open || only_reflects(behaviour(k))) return "";
    const int axis = box.surfaces.axis_of(k);
    std::string what = label_of_surface(language, view.gas_, behaviour(k), axis);
    if (moves(behaviour(k))) {
        const std::string place = std::string(name_of_axis(axis)) + " = " +
                                  three_digits(language, place_of_surface(box, states, k));
        what = what.empty() ? place : say(language, "{}, {}", what, place);
    }
    if (what.empty()) what = words_of({language}, behaviour(k), view.gas_, axis);
    return say(language, "{}: {}", short_name_of_surface(language, box, k), what);
}

// Labels of vertical partitions, and of all sheets in space, are in a row above the box, clear of
// each other, and those of sides on their ends; labels of horizontal partitions are on them.
void SurfaceView::Brush::draw_labels() const {
    TextStyle style = label_style(dc);
    style.color = theme.ink;
    std::vector<SurfaceLabel> labels;
    for (std::size_t k = 0; k < states.size(); ++k) {
        const int axis = box.surfaces.axis_of(k);
        if (map.space) {
            const Region inside = view.room(states);
            Vec middle = 0.5 * (inside.low + inside.high);
            middle[axis] = place_of_surface(box, states, k);
            const std::string words = words_in_space(k);
            if (!words.empty())
                labels.push_back(
                    {map.space->at(middle).x, escape_markup(words), false, label_color(k)});
            continue;
        }
        const std::string words = label_of_surface(view.language_, view.gas_, behaviour(k), axis);
        if (words.empty() || states[k].is_open || (axis == 1 && box.surfaces.is_side(k))) continue;
        const double at = place_of_surface(box, states, k);
        const Point foot = map.pixel({at, at});
        if (axis == 0) {
            labels.push_back(
                {foot.x, escape_markup(words), box.surfaces.is_side(k), label_color(k)});
            continue;
        }
        TextStyle within = style;
        within.halo = 0.16 * u;
        within.behind = theme.ground;
        draw_text(canvas, {room.x + 0.5 * u, foot.y - 0.45 * u}, escape_markup(words), within);
    }
    std::ranges::stable_sort(labels, {}, &SurfaceLabel::middle);
    const Rect all = view.whole(map, u);
    const double gap = 1.2 * u;
    const auto width_of = [&](const SurfaceLabel& label) {
        return measure_text(label.words, style).width + gap;
    };
    const auto all_widths = [&] {
        double sum = -gap;
        for (const SurfaceLabel& label : labels) sum += width_of(label);
        return sum;
    };
    while (!labels.empty() && all_widths() > all.width)  // the longest says the most, but not there
        labels.erase(std::ranges::max_element(labels, {}, width_of));
    std::vector<double> lefts;
    double least = all.x;
    for (const SurfaceLabel& label : labels) {
        const double width = measure_text(label.words, style).width;
        lefts.push_back(std::max(least, label.middle - width / 2));
        least = lefts.back() + width + gap;
    }
    double most = all.right();
    for (std::size_t k = labels.size(); k-- > 0;) {
        lefts[k] = std::min(lefts[k], most - measure_text(labels[k].words, style).width);
        const double right = lefts[k] + width_of(labels[k]) - gap;
        most = lefts[k] - gap;
        style.color = labels[k].color;
        const double row = labels[k].is_of_side ? row_over_side(lefts[k], right) : all.y + 1.05 * u;
        draw_text(canvas, {lefts[k], row}, labels[k].words, style);
    }
}

}  // namespace carom
