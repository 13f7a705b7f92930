#include "panels/collision/collision_map_marks.h"

#include <array>

#include "panels/gas/velocity_arrows.h"

namespace carom {
namespace {

ArrowStyle arrow(const DrawContext& dc, Color color, Color edge) {
    return collision_arrow(dc, color, edge, 0.08);
}

}  // namespace

ArrowStyle map_arrow_before(const DrawContext& dc) {
    return arrow(dc, dc.theme.page, dc.theme.ink);
}

ArrowStyle map_arrow_after(const DrawContext& dc) { return arrow(dc, dc.theme.ink, dc.theme.page); }

ArrowStyle map_arrow_center(const DrawContext& dc) {
    return arrow(dc, dc.theme.muted, dc.theme.page);
}

Color momentum_color(const DrawContext& dc) { return edge_of(dc.theme.highlight, dc.theme); }

std::vector<double> momentum_dashes(const DrawContext& dc) { return line_dashes(1, 2, dc); }

std::vector<double> wall_dashes(const DrawContext& dc) { return {0.4 * dc.unit, 0.3 * dc.unit}; }

std::vector<double> equal_dots(const DrawContext& dc) { return {0.12 * dc.unit, 0.3 * dc.unit}; }

void draw_map_point(Canvas& canvas, const DrawContext& dc, Point at, bool hollow) {
    const double radius = map_point_radius * dc.unit;
    canvas.fill_circle(at, radius + 0.1 * dc.unit, dc.theme.page);
    canvas.fill_circle(at, radius, dc.theme.ink);
    if (hollow) canvas.fill_circle(at, 0.58 * radius, dc.theme.page);
}

void draw_map_sample(Canvas& canvas, const DrawContext& dc, MapMark mark, Point at, double wide) {
    const double u = dc.unit, y = at.y - 0.35 * u, end = at.x + wide * u;
    const Point middle{at.x + 0.5 * wide * u, y};
    const std::array line{Point{at.x, y}, Point{end, y}};
    const Color grey = dc.theme.muted;
    switch (mark) {
        case MapMark::before:
        case MapMark::after:
            draw_map_point(canvas, dc, middle, mark == MapMark::before);
            break;
        case MapMark::energy:
            canvas.stroke_line(line[0], line[1], 0.16 * u, grey);
            break;
        case MapMark::momentum:
            canvas.stroke_path(line, 0.14 * u, momentum_color(dc), momentum_dashes(dc));
            break;
        case MapMark::steps:
            canvas.stroke_path(line, 0.14 * u, momentum_color(dc));
            break;
        case MapMark::walls:
            canvas.stroke_path(line, 0.11 * u, grey, wall_dashes(dc));
            break;
        case MapMark::equal:
            canvas.stroke_path(line, 0.1 * u, grey, equal_dots(dc));
            break;
        case MapMark::center:
            canvas.stroke_path(line, 0.1 * u, grey, equal_dots(dc));
            draw_arrow(canvas, line[0], {at.x + 0.6 * wide * u, y}, map_arrow_center(dc));
            break;
        case MapMark::turning:
            draw_arrow(canvas, middle, line[0], map_arrow_before(dc));
            draw_arrow(canvas, middle, line[1], map_arrow_after(dc));
            break;
    }
}

}  // namespace carom
