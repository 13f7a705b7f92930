// Draws levels, markers and arrows, and the words beside them.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "panels/plot/layers.h"

namespace carom::plot {
namespace {

constexpr double ascent = 1.1, descent = 0.4;           // of words, units, with air
constexpr double swatch_from = -1.8, swatch_to = -0.6;  // of a swatch before words, units

// Where an anchor is on the canvas.
Point place_of(const Frame& frame, const Anchor& anchor) {
    const Point at{
        anchor.x_is_share ? frame.area.x + anchor.at.x * frame.area.width : frame.x(anchor.at.x),
        anchor.y_is_share ? frame.area.y + anchor.at.y * frame.area.height
                          : frame.y(anchor.at.y, Beyond::clamped)};
    return {at.x + frame.pixels(anchor.offset.x), at.y + frame.pixels(anchor.offset.y)};
}

Rect rect_of(const Frame& frame, Point baseline, Align align, double width) {
    const double share = align == Align::left ? 0.0 : align == Align::center ? 0.5 : 1.0;
    const double air = frame.pixels(0.15);
    return {baseline.x - share * width - air, baseline.y - frame.pixels(ascent), width + 2.0 * air,
            frame.pixels(ascent + descent)};
}

struct Place {
    Point baseline;
    Align align;
    Rect rect;
    bool has_swatch;
    std::string words = {};
    bool is_away = false;  ///< from what they name
};

// With the swatch before the words, which keeps off other words.
Rect whole_of(const Frame& frame, const Place& place) {
    constexpr double air = 0.5;  // units
    Rect whole = place.rect;
    if (!place.has_swatch) return whole;
    whole.x += frame.pixels(swatch_from - air);
    whole.width -= frame.pixels(swatch_from - air);
    return whole;
}

// Onto the axis or into the row of its numbers.
bool reaches_x_axis(const Frame& frame, const Rect& words) {
    constexpr double slack = 0.5;  // pixels
    return words.bottom() > frame.area.bottom() + slack;
}

bool reaches_title(const Frame& frame, const Rect& words) {
    constexpr double most_over = 0.9;  // units, over the plot
    return words.y < frame.area.y - frame.pixels(most_over);
}

// Whether words, and the swatch before them, are within the plot from left to right.
bool fits_across(const Frame& frame, const Place& place) {
    const double left = place.rect.x + (place.has_swatch ? frame.pixels(swatch_from) : 0.0);
    return left >= frame.area.x && place.rect.right() <= frame.area.right();
}

// Shifts centred words near the left or the right side of the plot horizontally so that they stay
// inside.
void keep_inside(const Frame& frame, Place& place) {
    const double air = frame.pixels(0.3), least = frame.area.x + air;
    const double most = frame.area.right() - air - place.rect.width;
    if (place.align != Align::center || most < least) return;
    const double x = std::clamp(place.rect.x, least, most);
    place.baseline.x += x - place.rect.x;
    place.rect.x = x;
}

// Whether words are nearer to the level or the line that they name than to any other one.
bool is_at_its_own(const Frame& frame, const Label& label, const Rect& words) {
    if (label.level)
        return frame.placer.is_nearest_level(frame.y(*label.level, Beyond::clamped), words);
    constexpr double close = 0.4;  // units
    return !label.line || frame.placer.is_nearest_line(*label.line, words, frame.pixels(close));
}

// In print the words of names begin with swatches.
bool has_own_swatch(const Frame& frame, const Label& label) {
    return label.is_name && frame.dc.theme.kind == ThemeKind::print;
}

// A name to which its line comes late in the film has a swatch until then; false if it has no room.
bool add_sample_until_come(const Frame& frame, const Label& label, Place& place) {
    constexpr double late = 0.15;  // of the film
    if (has_own_swatch(frame, label) || place.rect.x < frame.area.x + late * frame.area.width)
        return true;
    Place with_swatch = place;
    with_swatch.has_swatch = true;
    if (!frame.placer.is_free(whole_of(frame, with_swatch)) || !fits_across(frame, with_swatch))
        return false;
    place = with_swatch;
    return true;
}

// The first free place of all anchors and their steps. While shorter words remain to be tried, the
// place must hold the words completely.
std::optional<Place> free_place(const Frame& frame, const Label& label, double width,
                                bool has_shorter, bool over_markers) {
    constexpr double latest = 0.4;  // of the film, for a name without a swatch until then
    std::optional<Place> late;
    for (const Anchor& anchor : label.anchors) {
        const bool steps = anchor.step.x != 0.0 || anchor.step.y != 0.0;
        Place place{place_of(frame, anchor), anchor.align, {}, anchor.has_swatch};
        for (;;) {
            place.rect = rect_of(frame, place.baseline, anchor.align, width);
            keep_inside(frame, place);
            if ((steps || anchor.is_inside) && !frame.placer.is_inside(place.rect)) break;
            if (reaches_x_axis(frame, place.rect) || reaches_title(frame, place.rect)) break;
            if (!fits_across(frame, place)) {
                if (has_shorter) break;
                place.has_swatch = false;  // it would lie on the numbers of the axis
                if (!fits_across(frame, place)) break;
            }
            if (frame.placer.is_free(whole_of(frame, place), over_markers) &&
                is_at_its_own(frame, label, place.rect)) {
                if (!label.line || add_sample_until_come(frame, label, place)) return place;
                if (!late && place.rect.x < frame.area.x + latest * frame.area.width) late = place;
            }
            if (!steps) break;
            place.baseline.x += frame.pixels(anchor.step.x);
            place.baseline.y += frame.pixels(anchor.step.y);
        }
    }
    return late;
}

// Whether the words say by a swatch what they belong to, and may therefore be anywhere: words of a
// level, and names.
bool has_swatch(const Label& label) {
    return label.swatch && !label.anchors.empty() &&
           (label.is_name || label.level || label.anchors.front().has_swatch);
}

// The free place nearest to the first anchor.
std::optional<Place> place_anywhere(const Frame& frame, const Label& label, double width,
                                    bool over_markers) {
    constexpr double step = 0.5;  // units
    const Rect& area = frame.area;
    const Point wanted = place_of(frame, label.anchors.front());
    std::optional<Place> nearest;
    double least = 0.0;
    const double air = frame.pixels(step);
    for (double y = area.y + frame.pixels(ascent); y < area.bottom(); y += air)
        for (double x = area.right() - air; x > area.x; x -= air) {
            Place place{{x, y}, Align::right, {}, !has_own_swatch(frame, label)};
            place.is_away = true;
            place.rect = rect_of(frame, place.baseline, place.align, width);
            const double distance = std::hypot(x - wanted.x, y - wanted.y);
            if (nearest && distance >= least) continue;
            const Rect whole = whole_of(frame, place);
            if (!frame.placer.is_inside(whole) || !frame.placer.is_free(whole, over_markers))
                continue;
            nearest = place;
            least = distance;
        }
    return nearest;
}

TextStyle style_of(const Frame& frame, const Label& label) {
    TextStyle style = label_style(frame.dc);
    style.color = legible(color_of(label.role, frame.dc.theme), frame.dc.theme);
    return style;
}

// The place of a label and the version of its words that is used; none if the label is left out.
std::optional<Place> place_of(const Frame& frame, const Label& label) {
    struct Search {
        bool anywhere, over_markers;
    };
    const auto found = [&](const Search& search) -> std::optional<Place> {
        for (const Text& text : label.words) {
            const std::string words = markup_of(text, frame.dc.theme);
            const double width = measure_text(words, style_of(frame, label)).width;
            const bool has_shorter = &text != &label.words.back();
            std::optional<Place> place =
                search.anywhere ? place_anywhere(frame, label, width, search.over_markers)
                                : free_place(frame, label, width, has_shorter, search.over_markers);
            if (!place) continue;
            place->words = words;
            return place;
        }
        return {};
    };
    std::optional<Place> place = found({});
    if (place || !has_swatch(label)) return place;
    std::array<Search, 3> others{Search{true, false}, Search{false, true}, Search{true, true}};
    if (label.level) std::swap(others[0], others[1]);  // beside its line, not in a key
    for (const Search& search : others)
        if ((place = found(search))) break;
    return place;
}

}  // namespace

std::optional<Rect> rect_of(const Frame& frame, const Label& label) {
    const std::optional<Place> place = place_of(frame, label);
    if (!place) return {};
    const Rect whole = whole_of(frame, *place);
    frame.placer.place(whole);
    return whole;
}

namespace {

void draw_in_place(Canvas& canvas, const Frame& frame, const Label& label, const Place& place) {
    const Rect& rect = place.rect;
    TextStyle style = style_of(frame, label);
    style.align = place.align;
    draw_text(canvas, place.baseline, place.words, clear_of_grid(frame, style, rect));
    if (!place.has_swatch || !label.swatch) return;
    const double y = place.baseline.y - frame.pixels(0.35);
    draw_straight(canvas, frame.dc, {rect.x + frame.pixels(swatch_from), y},
                  {rect.x + frame.pixels(swatch_to), y}, *label.swatch);
}

// How much of a name is to be seen of a line that has come so far: it fades in as the end of the
// line passes its beginning.
double share_seen(const Frame& frame, const Polyline& line, const Rect& words) {
    constexpr double way = 1.0;  // units
    const std::size_t end = std::min(line.shown.end, line.x.size());
    double head = -INFINITY;
    for (std::size_t i = line.shown.first; i < end; ++i)
        if (std::isfinite(line.y[i])) head = std::max(head, frame.x(line.x[i]));
    return std::clamp((head - words.x) / std::min(words.width, frame.pixels(way)), 0.0, 1.0);
}

}  // namespace

void draw_layer(Canvas& canvas, const Frame& frame, const Label& label) {
    const std::optional<Place> place = place_of(frame, label);
    if (!place) {
        if (!label.words.empty()) leave_out(markup_of(label.words.back(), frame.dc.theme));
        return;
    }
    if (place->is_away && label.level) name_in_key(place->words);
    if (!label.line || place->is_away) draw_in_place(canvas, frame, label, *place);
    frame.placer.place(whole_of(frame, *place));
}

Label fixed_label(const Frame& frame, const Label& label) {
    Label name = label;
    name.anchors.clear();
    const std::optional<Place> place = place_of(frame, label);
    if (!place) return name;
    frame.placer.place(whole_of(frame, *place));
    if (place->is_away) return name;
    std::erase_if(name.words, [&](const Text& text) {
        return markup_of(text, frame.dc.theme) != place->words;
    });
    const Rect& area = frame.area;
    name.anchors = {{.at = {(place->baseline.x - area.x) / area.width,
                            (place->baseline.y - area.y) / area.height},
                     .x_is_share = true,
                     .y_is_share = true,
                     .align = place->align,
                     .has_swatch = place->has_swatch}};
    return name;
}

void draw_arriving(Canvas& canvas, const Frame& frame, const Label& label, const Polyline& line) {
    if (label.anchors.empty()) return;
    const Anchor& anchor = label.anchors.front();
    Place place{place_of(frame, anchor), anchor.align, {}, anchor.has_swatch};
    place.words = markup_of(label.words.front(), frame.dc.theme);
    const double width = measure_text(place.words, style_of(frame, label)).width;
    place.rect = rect_of(frame, place.baseline, place.align, width);
    const double share = has_own_swatch(frame, label) ? 1.0 : share_seen(frame, line, place.rect);
    Label fading = label;
    if (place.has_swatch) {
        fading.swatch->fade = share;
        place.has_swatch = share < 1.0;
        return draw_in_place(canvas, frame, fading, place);
    }
    if (share == 0.0) return;
    place.words = markup_of(label.words.front(), frame.dc.theme, 1.0 - share);
    draw_in_place(canvas, frame, fading, place);
}

void draw_layer(Canvas& canvas, const Frame& frame, const Level& level) {
    const double y = frame.y(level.value);
    if (const auto exit = exit_of(frame, level))
        draw_exit(canvas, frame, *exit, level.stroke);
    else
        draw_straight(canvas, frame.dc, {frame.area.x, y}, {frame.area.right(), y}, level.stroke);
    if (level.label) draw_layer(canvas, frame, *level.label);
}

namespace {

// A vertical line with gaps where words have their places.
void draw_with_gaps(Canvas& canvas, const Frame& frame, double x, double from, double to,
                    const Stroke& stroke) {
    const double air = 0.5 * frame.pixels(stroke.width), up = to < from ? -1.0 : 1.0;
    std::vector<std::pair<double, double>> gaps;
    for (const Rect& words : frame.gaps)
        if (x > words.x - air && x < words.right() + air)
            gaps.emplace_back(up * (up < 0.0 ? words.bottom() : words.y),
                              up * (up < 0.0 ? words.y : words.bottom()));
    std::ranges::sort(gaps);
    for (const auto& [first, last] : gaps) {
        if (up * first > up * from)
            draw_straight(canvas, frame.dc, {x, from}, {x, up * std::min(first, up * to)}, stroke);
        from = up * std::max(up * from, last);
    }
    if (up * from < up * to) draw_straight(canvas, frame.dc, {x, from}, {x, to}, stroke);
}

}  // namespace

void draw_layer(Canvas& canvas, const Frame& frame, const Marker& marker) {
    const double x = frame.x(marker.value);
    if (!(x >= frame.area.x && x <= frame.area.right())) return;
    if (marker.is_under_axis) {
        constexpr double length = 0.5;  // units
        draw_straight(canvas, frame.dc, {x, frame.area.bottom()},
                      {x, frame.area.bottom() + frame.pixels(length)}, marker.stroke);
        return;
    }
    double from = frame.area.bottom(), to = frame.area.y;  // dashes begin at `from`
    if (marker.up_to) from = frame.y(*marker.up_to, Beyond::clamped), to = frame.area.bottom();
    draw_with_gaps(canvas, frame, x, from, to, marker.stroke);
    if (marker.label) draw_layer(canvas, frame, *marker.label);
}

void draw_layer(Canvas& canvas, const Frame& frame, const Arrow& arrow) {
    const Point from{frame.x(arrow.from.x), frame.y(arrow.from.y)};
    const Point to{frame.x(arrow.to.x), frame.y(arrow.to.y)};
    draw_in_area(canvas, frame, std::array{from, to}, frame.dc.unit,
                 [&] { draw_arrow(canvas, frame.dc, from, to, arrow); });
}

}  // namespace carom::plot
