#include "panels/surfaces/surface_strokes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "draw/arrow.h"

namespace carom {

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

}  // namespace carom
