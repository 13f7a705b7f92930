#include "panels/surfaces/surface_strokes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "draw/arrow.h"
#include "panels/surfaces/surface_sizes.h"

namespace carom {
namespace {

// A dashed line with chevrons in its middle that point from its start to its end.
void add_joined_side(std::vector<std::vector<Point>>& lines, Point from, Point to, int chevrons,
                     double unit) {
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    if (!(length > 0.0)) return;
    const Point along{(to.x - from.x) / length, (to.y - from.y) / length};
    const auto at = [&](double way, double aside) {
        return Point{from.x + way * along.x - aside * along.y,
                     from.y + way * along.y + aside * along.x};
    };
    constexpr double apart = 0.5, half_height = 0.36, half_depth = 0.22;  // units
    const double room = ((chevrons - 1) * apart / 2 + half_depth + 0.4) * unit;
    const double half = length / 2 - room, dash = 0.8 * unit, gap = 0.5 * unit;
    if (half < dash) return lines.push_back({from, to});
    for (int k = 0; k < chevrons; ++k) {
        const double middle = length / 2 + (k - 0.5 * (chevrons - 1)) * apart * unit;
        const double tail = middle - half_depth * unit;
        lines.push_back({at(tail, -half_height * unit), at(middle + half_depth * unit, 0.0),
                         at(tail, half_height * unit)});
    }
    const double count = std::max(1.0, std::round((half + gap) / (dash + gap)));
    const double step = (half + gap) / count;
    for (double k = 0.0; k < count; k += 1.0)
        for (const bool is_second : {false, true}) {
            const double first = k * step, last = first + step - gap;
            lines.push_back(is_second ? std::vector{at(length - last, 0.0), at(length - first, 0.0)}
                                      : std::vector{at(first, 0.0), at(last, 0.0)});
        }
}

// A row of teeth with their bases on the line from one point to another and their heads `deep` to
// its left, seen with y upwards; negative: to its right.
void draw_row_of_teeth(Canvas& canvas, const DrawContext& dc, Point from, Point to, double deep) {
    const Point way{to.x - from.x, to.y - from.y};
    const double length = std::hypot(way.x, way.y);
    if (!(length > 0.0)) return;
    const double count = std::max(1.0, std::round(length / (0.7 * dc.unit)));
    const Point head{deep * way.y / length, -deep * way.x / length};
    const auto at = [&](double k) {
        return Point{from.x + k / count * way.x, from.y + k / count * way.y};
    };
    for (double k = 0.0; k < count; k += 1.0) {
        const Point middle = at(k + 0.5);
        const std::array tooth{at(k), Point{middle.x + head.x, middle.y + head.y}, at(k + 1.0)};
        canvas.fill_polygon(tooth, dc.theme.wall);
    }
}

std::vector<Point> corners_of_rect(const Rect& rect) {
    return {{rect.x, rect.y},
            {rect.right(), rect.y},
            {rect.right(), rect.bottom()},
            {rect.x, rect.bottom()}};
}

}  // namespace

std::vector<std::vector<Point>> outline_of_box(const Rect& room, std::array<bool, 2> joined,
                                               double unit) {
    const double half = 0.5 * SurfaceSize::line * unit;
    const double left = room.x - half, right = room.right() + half, top = room.y - half,
                 bottom = room.bottom() + half;
    std::vector<std::vector<Point>> lines;
    for (const double x : {left, right})
        if (joined[0])
            add_joined_side(lines, {x, bottom}, {x, top}, 1, unit);
        else
            lines.push_back({{x, bottom + half}, {x, top - half}});
    for (const double y : {bottom, top})
        if (joined[1])
            add_joined_side(lines, {left, y}, {right, y}, 2, unit);
        else
            lines.push_back({{left - half, y}, {right + half, y}});
    return lines;
}

void draw_box_outline(Canvas& canvas, const DrawContext& dc, const Rect& room,
                      std::array<bool, 2> joined) {
    const double wide = SurfaceSize::line * dc.unit;
    if (!joined[0] && !joined[1])
        return canvas.stroke_rect(
            {room.x - wide / 2, room.y - wide / 2, room.width + wide, room.height + wide}, wide,
            dc.theme.wall);
    for (const std::vector<Point>& line : outline_of_box(room, joined, dc.unit))
        if (line.size() == 2)
            canvas.stroke_line(line[0], line[1], wide, dc.theme.wall);
        else
            canvas.stroke_path(line, 1.4 * wide, dc.theme.wall);
}

void hatch_polygon(Canvas& canvas, const std::vector<Point>& corners, double apart, double width,
                   Color color) {
    constexpr double root = std::numbers::sqrt2;
    constexpr double infinite = std::numeric_limits<double>::infinity();
    double low = infinite, high = -infinite;
    for (const Point& at : corners) {
        low = std::min(low, (at.x + at.y) / root);
        high = std::max(high, (at.x + at.y) / root);
    }
    for (double off = std::ceil(low / apart) * apart; off < high; off += apart) {
        std::vector<double> along;  // where the line crosses the edges
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const Point &a = corners[k], &b = corners[(k + 1) % corners.size()];
            const double from = (a.x + a.y) / root - off, to = (b.x + b.y) / root - off;
            if ((from > 0.0) == (to > 0.0)) continue;
            const double share = from / (from - to);
            along.push_back(((a.x - a.y) + share * ((b.x - b.y) - (a.x - a.y))) / root);
        }
        std::ranges::sort(along);
        for (std::size_t k = 0; k + 1 < along.size(); k += 2)
            canvas.stroke_line({(off + along[k]) / root, (off - along[k]) / root},
                               {(off + along[k + 1]) / root, (off - along[k + 1]) / root}, width,
                               color);
    }
}

void draw_bath(Canvas& canvas, const DrawContext& dc, const Rect& band, bool upright, Color color) {
    const double u = dc.unit;
    canvas.fill(band, color);
    const double depth = upright ? band.width : band.height;
    const double length = upright ? band.height : band.width;
    const double period = 1.2 * u, inset = 0.3 * u;
    std::vector<Point> wave;
    for (double along = inset; along <= length - inset; along += period / 12.0) {
        const double aside =
            depth / 2 + 0.24 * depth * std::sin(2.0 * std::numbers::pi * along / period);
        wave.push_back(upright ? Point{band.x + aside, band.y + along}
                               : Point{band.x + along, band.y + aside});
    }
    if (wave.size() > 1) canvas.stroke_path(wave, 0.13 * u, letters_on(color, dc.theme));
}

void draw_dotted_line(Canvas& canvas, const DrawContext& dc, Point from, Point to) {
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    const double count = std::max(1.0, std::round(length / (0.6 * dc.unit)));
    for (double dot = 0.5; dot < count; dot += 1.0)
        canvas.fill_circle(
            {from.x + dot / count * (to.x - from.x), from.y + dot / count * (to.y - from.y)},
            0.15 * dc.unit, dc.theme.ink);
}

void draw_eye(Canvas& canvas, const DrawContext& dc, const Rect& block) {
    const Point middle{block.x + block.width / 2, block.y + block.height / 2};
    canvas.stroke_circle(middle, 0.34 * dc.unit, 0.1 * dc.unit, dc.theme.ink);
    canvas.fill_circle(middle, 0.13 * dc.unit, dc.theme.ink);
}

void draw_holder(Canvas& canvas, const DrawContext& dc, const Rect& block, bool is_imposed) {
    canvas.fill(block, is_imposed ? dc.theme.page : dc.theme.muted);
    if (is_imposed) {
        hatch_polygon(canvas, corners_of_rect(block), 0.25 * dc.unit, 0.09 * dc.unit,
                      dc.theme.muted);
        canvas.stroke_rect(block, 0.09 * dc.unit, dc.theme.muted);
    }
}

void draw_teeth(Canvas& canvas, const DrawContext& dc, const Rect& band, std::size_t side) {
    const Point low_left{band.x, band.bottom()}, low_right{band.right(), band.bottom()},
        top_left{band.x, band.y}, top_right{band.right(), band.y};
    if (side == 0) draw_row_of_teeth(canvas, dc, low_right, top_right, band.width);
    if (side == 1) draw_row_of_teeth(canvas, dc, top_left, low_left, band.width);
    if (side == bottom_side) draw_row_of_teeth(canvas, dc, top_right, top_left, band.height);
    if (side == top_side) draw_row_of_teeth(canvas, dc, low_left, low_right, band.height);
}

void draw_rough_line(Canvas& canvas, const DrawContext& dc, Point from, Point to) {
    constexpr double half = 0.3;  // units
    for (const double deep : {half, -half}) draw_row_of_teeth(canvas, dc, from, to, deep * dc.unit);
    canvas.stroke_line(from, to, SurfaceSize::line * dc.unit, dc.theme.wall);
}

void draw_ticks(Canvas& canvas, const DrawContext& dc, const Rect& band, std::size_t side) {
    const double u = dc.unit, apart = 0.75 * u;
    const bool upright = is_upright(side);
    const double deep = upright ? band.width : band.height;
    const double length = upright ? band.height : band.width;
    for (double along = 0.2 * u; along + deep < length; along += apart) {
        const Point root = upright
                               ? Point{side == 0 ? band.right() : band.x, band.y + along + deep}
                               : Point{band.x + along, side == top_side ? band.bottom() : band.y};
        const Point end =
            upright ? Point{side == 0 ? band.x : band.right(), band.y + along}
                    : Point{band.x + along + deep, side == top_side ? band.y : band.bottom()};
        canvas.stroke_line(root, end, 0.12 * u, dc.theme.muted);
    }
}

void draw_surface_arrow(Canvas& canvas, const DrawContext& dc, Point from, Point step) {
    const double u = dc.unit;
    draw_arrow(canvas, from, {from.x + step.x, from.y + step.y},
               {.shaft = 0.24 * u,
                .head_length = 0.85 * u,
                .head_width = 0.85 * u,
                .edge = 0.08 * u,
                .color = dc.theme.ink,
                .edge_color = dc.theme.page});
}

void draw_arrow_end_on(Canvas& canvas, const DrawContext& dc, Point middle, bool toward_viewer) {
    const double u = dc.unit, radius = 0.55 * u;
    canvas.stroke_circle(middle, radius, 0.13 * u, dc.theme.ink);
    if (toward_viewer) return canvas.fill_circle(middle, 0.2 * u, dc.theme.ink);
    const double arm = radius * std::numbers::sqrt2 / 2;
    for (const double turn : {1.0, -1.0})
        canvas.stroke_line({middle.x - arm, middle.y - turn * arm},
                           {middle.x + arm, middle.y + turn * arm}, 0.13 * u, dc.theme.ink);
}

}  // namespace carom
