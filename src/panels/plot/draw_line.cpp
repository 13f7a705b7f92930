// Draws growing lines, error bands around them, and points.
#include <algorithm>
#include <cmath>

#include "panels/plot/layers.h"

namespace carom::plot {
namespace {

constexpr double detail = 0.08;  // units: points nearer than half a line's width show nothing new

template <class Curve>
std::size_t end_of(const Curve& curve) {
    return std::min(curve.shown.end, curve.x.size());
}

bool piece_ends(const Line& line, std::size_t i) {
    return i + 1 == end_of(line) || (line.piece && (*line.piece)[i + 1] != (*line.piece)[i]);
}

}  // namespace

void draw_layer(Canvas& canvas, const Frame& frame, const Line& line) {
    const double width = frame.pixels(line.stroke.width);
    const bool is_cut = line.beyond == Beyond::cut;
    if (is_cut)
        canvas.clip_to(
            {frame.area.x, frame.area.y, frame.area.width, frame.area.height + 0.5 * width});
    std::vector<Point> path;
    std::optional<Point> last;
    for (std::size_t i = line.shown.first; i < end_of(line); ++i) {
        const bool is_known = std::isfinite(line.y[i]);
        if (is_known) last = {frame.x(line.x[i]), frame.y(line.y[i], line.beyond)};
        if (is_known && (path.empty() || !line.is_thinned ||
                         is_apart(path.back(), *last, frame.pixels(detail))))
            path.push_back(*last);
        if (!piece_ends(line, i) || path.empty()) continue;
        if (is_apart(path.back(), *last, 0.0)) path.push_back(*last);
        if (is_cut)
            draw_stroke(canvas, frame.dc, path, line.stroke);
        else
            draw_in_area(canvas, frame, path, width,
                         [&] { draw_stroke(canvas, frame.dc, path, line.stroke); });
        path.clear();
    }
    if (is_cut) canvas.release_clip();
    if (last && line.head && is_in_area(frame, *last))
        draw_mark(canvas, frame.dc, *last, *line.head);
}

void draw_layer(Canvas& canvas, const Frame& frame, const Band& band) {
    const Color color = with_alpha(color_of(band.role, frame.dc.theme), band.alpha);
    std::vector<Point> upper, lower;
    const auto end_band = [&] {
        upper.insert(upper.end(), lower.rbegin(), lower.rend());
        if (upper.size() > 3)
            draw_in_area(canvas, frame, upper, 0.0, [&] { canvas.fill_polygon(upper, color); });
        upper.clear();
        lower.clear();
    };
    for (std::size_t i = band.shown.first; i < end_of(band); ++i) {
        const bool ends = i + 1 == end_of(band);
        if (std::isfinite(band.error[i])) {
            const double x = frame.x(band.x[i]);
            const Point high{x, frame.y(band.y[i] + band.error[i], Beyond::clamped)};
            const Point low{x, frame.y(band.y[i] - band.error[i], Beyond::clamped)};
            if (ends || upper.empty() || is_apart(upper.back(), high, frame.pixels(detail))) {
                upper.push_back(high);
                lower.push_back(low);
            }
        }
        if (ends || !std::isfinite(band.error[i])) end_band();
    }
}

void draw_layer(Canvas& canvas, const Frame& frame, const Points& points) {
    std::optional<Point> last;
    for (std::size_t i = points.shown.first; i < end_of(points); ++i) {
        if (std::isnan(points.y[i])) continue;
        const Point at{frame.x(points.x[i]), frame.y(points.y[i])};
        if (!is_in_area(frame, at)) continue;
        if (last && !is_apart(*last, at, frame.pixels(points.spacing))) continue;
        draw_mark(canvas, frame.dc, at, points.mark);
        if (points.spacing > 0.0) last = at;
    }
}

}  // namespace carom::plot
