#include "panels/dials/round_dial.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace carom {
namespace {

// In radii, except the widths of lines, which are in units.
struct RoundDialSize {
    static constexpr double tick_outer = 0.93, long_tick = 0.15, short_tick = 0.08;
    static constexpr double needle_length = 0.86, needle_width = 0.055, hub = 0.1;
    static constexpr double rim = 0.1, band = 0.965, band_width = 0.2, long_width = 0.12,
                            short_width = 0.07;
    static constexpr int steps_between = 5;  // short steps between two long ticks
};

}  // namespace

RoundDial::RoundDial(const DrawContext& dc, const Rect& face, const DialShape& shape)
    : dc_(dc), shape_(shape) {
    radius_ = std::min(face.width / 2.0, face.height / shape.depth);
    center_ = {face.x + 0.5 * face.width,
               face.y + 0.5 * (face.height - shape.depth * radius_) + radius_};
}

Point RoundDial::at(double share, double radii) const {
    const double angle = shape_.degrees(share) * std::numbers::pi / 180.0;
    return {center_.x + radii * radius_ * std::sin(angle),
            center_.y - radii * radius_ * std::cos(angle)};
}

// Draws the plate: a disk, or a disk that is cut by a straight lower edge.
void RoundDial::draw_plate(Canvas& canvas) const {
    const double below = std::clamp(shape_.depth - 1.0, -1.0, 1.0);
    const double half = std::numbers::pi - std::acos(below);  // of the part that is left
    constexpr int steps = 120;
    std::vector<Point> outline;
    for (int i = 0; i <= steps; ++i) {
        const double angle = half * (2.0 * i / steps - 1.0);
        outline.push_back(
            {center_.x + radius_ * std::sin(angle), center_.y - radius_ * std::cos(angle)});
    }
    canvas.fill_polygon(outline, dc_.theme.ground);
    outline.push_back(outline.front());
    canvas.stroke_path(outline, RoundDialSize::rim * dc_.unit, dc_.theme.muted);
}

// The rectangle of a mark's number: as far inside of its tick as its half width and height require.
Rect RoundDial::rect_of(const TickMark& mark, const DialScale& scale) const {
    const double u = dc_.unit;
    const double half = 0.5 * measure_text(mark.label, label_style(dc_)).width, high = 0.36 * u;
    const double share = scale.share(mark.value);
    const Point edge = at(share, RoundDialSize::tick_outer - RoundDialSize::long_tick);
    const double norm = std::hypot(edge.x - center_.x, edge.y - center_.y);
    const double x = (edge.x - center_.x) / norm, y = (edge.y - center_.y) / norm;
    const double reach = std::hypot(half * x, high * y) + 0.35 * u;
    return {edge.x - reach * x - half, edge.y - reach * y - high, 2.0 * half, 2.0 * high};
}

// The marks: as many as fit without their numbers touching each other or the hub. On a full circle
// the end is omitted, as it coincides with the start. Marks have no numbers if the dial is too
// small for any.
std::vector<TickMark> RoundDial::marks(const DialScale& scale, Language language) const {
    const bool is_full = shape_.sweep >= 360.0;
    const double apart = 0.35 * dc_.unit, hub = RoundDialSize::hub * radius_ + apart;
    const auto is_clear = [&](const Rect& a, const Rect& b) {
        return a.right() + apart <= b.x || b.right() + apart <= a.x || a.bottom() + apart <= b.y ||
               b.bottom() + apart <= a.y;
    };
    for (const int most : {11, 9, 7, 5, 4, 3, 2}) {
        std::vector<TickMark> all = ticks(scale.low, scale.high, most);
        if (is_full && !all.empty() && all.back().value >= scale.high) all.pop_back();
        std::vector<Rect> taken{{center_.x - hub, center_.y - hub, 2.0 * hub, 2.0 * hub}};
        bool has_room = true;
        for (TickMark& mark : all) {
            mark.label = mark.value == 0.0 ? "0" : localised(language, mark.label);
            const Rect rect = rect_of(mark, scale);
            for (const Rect& other : taken) has_room = has_room && is_clear(rect, other);
            taken.push_back(rect);
        }
        if (has_room && all.size() > 1) return all;
    }
    std::vector<TickMark> few = ticks(scale.low, scale.high, 3);
    for (TickMark& mark : few) mark.label.clear();
    return few;
}

void RoundDial::draw_face(Canvas& canvas, const DialScale& scale, Language language) const {
    draw_plate(canvas);
    const std::vector<TickMark> all = marks(scale, language);
    if (all.size() < 2) return;
    const double u = dc_.unit, step = (all[1].value - all[0].value) / RoundDialSize::steps_between;
    const auto first = static_cast<int>(std::ceil((scale.low - all[0].value) / step - 1e-6));
    const auto last = static_cast<int>(std::floor((scale.high - all[0].value) / step + 1e-6));
    for (int i = first; i <= last; ++i) {
        const bool is_long = i % RoundDialSize::steps_between == 0;
        const double share = scale.share(all[0].value + i * step);
        canvas.stroke_line(
            at(share, RoundDialSize::tick_outer),
            at(share, RoundDialSize::tick_outer -
                          (is_long ? RoundDialSize::long_tick : RoundDialSize::short_tick)),
            (is_long ? RoundDialSize::long_width : RoundDialSize::short_width) * u,
            is_long ? dc_.theme.ink : dc_.theme.muted);
    }
    TextStyle style = label_style(dc_);
    style.align = Align::center;
    for (const TickMark& mark : all) {
        const Rect rect = rect_of(mark, scale);
        draw_text(canvas, {rect.x + 0.5 * rect.width, rect.bottom()}, mark.label, style);
    }
}

void RoundDial::draw_band(Canvas& canvas, const std::array<double, 2>& shares, Color color) const {
    constexpr int steps = 60;
    std::vector<Point> arc;
    for (int i = 0; i <= steps; ++i)
        arc.push_back(at(shares[0] + (shares[1] - shares[0]) * i / steps, RoundDialSize::band));
    canvas.stroke_path(arc, RoundDialSize::band_width * dc_.unit, edge_of(color, dc_.theme));
}

void RoundDial::draw_needle(Canvas& canvas, double share, Color color) const {
    const Point tip = at(share, RoundDialSize::needle_length);
    const double length = std::hypot(tip.x - center_.x, tip.y - center_.y);
    const double dx = (tip.x - center_.x) / length, dy = (tip.y - center_.y) / length;
    const double wide = RoundDialSize::needle_width * radius_;
    const std::array corners{Point{center_.x - wide * dy, center_.y + wide * dx}, tip,
                             Point{center_.x + wide * dy, center_.y - wide * dx}};
    const Color edge = edge_of(color, dc_.theme);
    canvas.fill_polygon(corners, edge);
    canvas.fill_circle(center_, RoundDialSize::hub * radius_, edge);
    canvas.fill_circle(center_, 0.4 * RoundDialSize::hub * radius_, dc_.theme.ground);
}

}  // namespace carom
