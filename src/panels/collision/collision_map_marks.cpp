#include "panels/collision/collision_map_marks.h"

#include <array>

#include "panels/gas/velocity_arrows.h"
#include "panels/plots/comparison.h"

namespace carom {
namespace {

ArrowStyle arrow(const Page& page, Color color, Color edge) {
    return collision_arrow(page, color, edge, 0.08);
}

}  // namespace

ArrowStyle map_arrow_before(const Page& page) {
    return arrow(page, page.theme.page, page.theme.ink);
}

ArrowStyle map_arrow_after(const Page& page) {
    return arrow(page, page.theme.ink, page.theme.page);
}

ArrowStyle map_arrow_center(const Page& page) {
    return arrow(page, page.theme.muted, page.theme.page);
}

Color momentum_color(const Page& page) { return edge_of(page.theme.highlight, page.theme); }

std::vector<double> momentum_dashes(const Page& page) { return line_dashes(1, 2, page); }

std::vector<double> wall_dashes(const Page& page) { return {0.4 * page.unit, 0.3 * page.unit}; }

std::vector<double> equal_dots(const Page& page) { return {0.12 * page.unit, 0.3 * page.unit}; }

void draw_map_point(Canvas& canvas, const Page& page, Point at, bool hollow) {
    const double radius = map_point_radius * page.unit;
    canvas.fill_circle(at, radius + 0.1 * page.unit, page.theme.page);
    canvas.fill_circle(at, radius, page.theme.ink);
    if (hollow) canvas.fill_circle(at, 0.58 * radius, page.theme.page);
}

void draw_map_sample(Canvas& canvas, const Page& page, MapMark mark, Point at, double wide) {
    const double u = page.unit, y = at.y - 0.35 * u, end = at.x + wide * u;
    const Point middle{at.x + 0.5 * wide * u, y};
    const std::array line{Point{at.x, y}, Point{end, y}};
    const Color grey = page.theme.muted;
    switch (mark) {
        case MapMark::before:
        case MapMark::after:
            draw_map_point(canvas, page, middle, mark == MapMark::before);
            break;
        case MapMark::energy:
            canvas.stroke_line(line[0], line[1], 0.16 * u, grey);
            break;
        case MapMark::momentum:
            canvas.stroke_path(line, 0.14 * u, momentum_color(page), momentum_dashes(page));
            break;
        case MapMark::steps:
            canvas.stroke_path(line, 0.14 * u, momentum_color(page));
            break;
        case MapMark::walls:
            canvas.stroke_path(line, 0.11 * u, grey, wall_dashes(page));
            break;
        case MapMark::equal:
            canvas.stroke_path(line, 0.1 * u, grey, equal_dots(page));
            break;
        case MapMark::center:
            canvas.stroke_path(line, 0.1 * u, grey, equal_dots(page));
            draw_arrow(canvas, line[0], {at.x + 0.6 * wide * u, y}, map_arrow_center(page));
            break;
        case MapMark::turning:
            draw_arrow(canvas, middle, line[0], map_arrow_before(page));
            draw_arrow(canvas, middle, line[1], map_arrow_after(page));
            break;
    }
}

}  // namespace carom
