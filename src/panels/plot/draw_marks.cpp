// Draws levels, markers and arrows, and the words beside them.
#include <algorithm>
#include <cmath>

#include "panels/plot/layers.h"

namespace carom::plot {
namespace {

constexpr double ascent = 1.1, descent = 0.4;           // of words, units, with air
constexpr double sample_from = -1.8, sample_to = -0.6;  // of a sample before words, units

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
    return {baseline.x - share * width, baseline.y - frame.pixels(ascent), width,
            frame.pixels(ascent + descent)};
}

struct Place {
    Point baseline;
    Align align;
    Rect rect;
    bool has_sample;
    std::string words = {};
    bool is_free = true;
};

bool lies_on_x_axis(const Frame& frame, const Rect& words) {
    constexpr double slack = 0.5;  // pixels
    return words.y < frame.area.bottom() && words.bottom() > frame.area.bottom() + slack;
}

// Whether words, and the sample before them, are within the plot from left to right.
bool fits_across(const Frame& frame, const Place& place) {
    const double left = place.rect.x + (place.has_sample ? frame.pixels(sample_from) : 0.0);
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

// The first free place of all anchors and their steps. While shorter words remain to be tried, the
// place must hold the words completely.
std::optional<Place> free_place(const Frame& frame, const std::vector<Anchor>& anchors,
                                double width, bool has_shorter) {
    for (const Anchor& anchor : anchors) {
        const bool steps = anchor.step.x != 0.0 || anchor.step.y != 0.0;
        Place place{place_of(frame, anchor), anchor.align, {}, anchor.has_sample};
        for (;;) {
            place.rect = rect_of(frame, place.baseline, anchor.align, width);
            keep_inside(frame, place);
            if (steps && !frame.placer.is_inside(place.rect)) break;
            if (lies_on_x_axis(frame, place.rect)) break;
            if (!fits_across(frame, place)) {
                if (has_shorter) break;
                place.has_sample = false;  // it would lie on the numbers of the axis
            }
            if (frame.placer.is_free(place.rect)) return place;
            if (!steps) break;
            place.baseline.x += frame.pixels(anchor.step.x);
            place.baseline.y += frame.pixels(anchor.step.y);
        }
    }
    return {};
}

TextStyle style_of(const Frame& frame, const Label& label) {
    TextStyle style = label_style(frame.dc);
    style.color = legible(color_of(label.role, frame.dc.theme), frame.dc.theme);
    return style;
}

// The place of a label and the version of its words that is used; none if the label is left out.
std::optional<Place> place_of(const Frame& frame, const Label& label) {
    std::string words;
    double width = 0.0;
    for (const Text& text : label.words) {
        words = markup_of(text, frame.dc.theme);
        width = measure_text(words, style_of(frame, label)).width;
        const bool has_shorter = &text != &label.words.back();
        std::optional<Place> place = free_place(frame, label.anchors, width, has_shorter);
        if (!place) continue;
        place->words = words;
        return place;
    }
    if (label.may_be_left_out || label.anchors.empty()) return {};
    const Anchor& first = label.anchors.front();
    const Point at = place_of(frame, first);
    Place place{at,    first.align, rect_of(frame, at, first.align, width), first.has_sample,
                words, false};
    place.has_sample = place.has_sample && fits_across(frame, place);
    return place;
}

}  // namespace

std::optional<Rect> rect_of(const Frame& frame, const Label& label) {
    const std::optional<Place> place = place_of(frame, label);
    if (!place) return {};
    frame.placer.keep_clear(place->rect);
    return place->rect;
}

void draw_layer(Canvas& canvas, const Frame& frame, const Label& label) {
    const DrawContext& dc = frame.dc;
    const std::optional<Place> place = place_of(frame, label);
    if (!place) return;
    const Rect& rect = place->rect;
    if (label.has_plate || !place->is_free) {
        const double air = frame.pixels(0.3);
        canvas.fill({rect.x - air, rect.y, rect.width + 2.0 * air, rect.height},
                    with_alpha(dc.theme.page, plate_alpha));
    }
    TextStyle style = style_of(frame, label);
    style.align = place->align;
    draw_text(canvas, place->baseline, place->words, style);
    frame.placer.keep_clear(rect);
    if (!place->has_sample || !label.sample) return;
    const double y = place->baseline.y - frame.pixels(0.35);
    draw_straight(canvas, dc, {rect.x + frame.pixels(sample_from), y},
                  {rect.x + frame.pixels(sample_to), y}, *label.sample);
}

void draw_layer(Canvas& canvas, const Frame& frame, const Level& level) {
    const double y = frame.y(level.value, Beyond::clamped);
    draw_straight(canvas, frame.dc, {frame.area.x, y}, {frame.area.right(), y}, level.stroke);
    if (level.label) draw_layer(canvas, frame, *level.label);
}

void draw_layer(Canvas& canvas, const Frame& frame, const Marker& marker) {
    const double x = frame.x(marker.value);
    if (!(x >= frame.area.x && x <= frame.area.right())) return;
    Point from{x, frame.area.bottom()}, to{x, frame.area.y};  // dashes begin at `from`
    if (marker.up_to)
        from = {x, frame.y(*marker.up_to, Beyond::clamped)}, to.y = frame.area.bottom();
    draw_straight(canvas, frame.dc, from, to, marker.stroke);
    if (marker.label) draw_layer(canvas, frame, *marker.label);
}

void draw_layer(Canvas& canvas, const Frame& frame, const Arrow& arrow) {
    draw_arrow(canvas, frame.dc, {frame.x(arrow.from.x), frame.y(arrow.from.y)},
               {frame.x(arrow.to.x), frame.y(arrow.to.y)}, arrow);
}

}  // namespace carom::plot
