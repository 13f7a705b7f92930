#include "draw/arrow.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace carom {
namespace {

double length_of(Point from, Point to) { return std::hypot(to.x - from.x, to.y - from.y); }

// The point at the distance `along` from `from` towards `to`, and `aside` to the right of this
// line.
Point beside(Point from, Point to, double along, double aside) {
    const double length = length_of(from, to);
    const double x = (to.x - from.x) / length, y = (to.y - from.y) / length;
    return {from.x + along * x - aside * y, from.y + along * y + aside * x};
}

// The fraction of `step`, starting at `from`, that stays between `low` and `high`.
double share_within(double from, double step, double low, double high) {
    if (from + step > high) return std::max(0.0, (high - from) / step);
    if (from + step < low) return std::max(0.0, (low - from) / step);
    return 1.0;
}

void draw_cut(Canvas& canvas, Point from, Point to, const ArrowStyle& style) {
    const double length = length_of(from, to);
    const double half = 1.3 * style.shaft, slant = 0.6 * style.shaft;
    for (const double back : {1.6, 3.4}) {
        const double at = length - style.head_length - back * style.shaft;
        if (at - slant < 0.0) return;
        canvas.stroke_line(beside(from, to, at - slant, -half), beside(from, to, at + slant, half),
                           0.9 * style.shaft, style.edge_color);
    }
}

}  // namespace

std::array<Point, 7> arrow_outline(Point from, Point to, const ArrowStyle& style) {
    const double length = length_of(from, to);
    constexpr double most_of_it = 0.6;
    const double shrink = std::min(1.0, most_of_it * length / style.head_length);
    const double neck = length - shrink * style.head_length;
    const double half = 0.5 * std::min(style.shaft, 0.6 * shrink * style.head_width);
    const double wing = 0.5 * shrink * style.head_width;
    return {beside(from, to, 0.0, -half),  beside(from, to, neck, -half),
            beside(from, to, neck, -wing), to,
            beside(from, to, neck, wing),  beside(from, to, neck, half),
            beside(from, to, 0.0, half)};
}

void draw_arrow(Canvas& canvas, Point from, Point to, const ArrowStyle& style) {
    if (!(length_of(from, to) >= style.shaft)) return;
    const std::array<Point, 7> outline = arrow_outline(from, to, style);
    std::vector<Point> closed(outline.begin(), outline.end());
    closed.push_back(outline.front());
    canvas.stroke_path(closed, 2.0 * style.edge, style.edge_color);
    canvas.fill_polygon(outline, style.color);
}

void draw_arrow_within(Canvas& canvas, const Rect& bounds, Point from, Point to,
                       const ArrowStyle& style) {
    const Point way{to.x - from.x, to.y - from.y};
    const double share = std::min(share_within(from.x, way.x, bounds.x, bounds.right()),
                                  share_within(from.y, way.y, bounds.y, bounds.bottom()));
    if (share == 1.0) return draw_arrow(canvas, from, to, style);
    const Point end{from.x + share * way.x, from.y + share * way.y};
    draw_arrow(canvas, from, end, style);
    draw_cut(canvas, from, end, style);
}

}  // namespace carom
