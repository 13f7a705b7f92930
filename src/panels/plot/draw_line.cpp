// Draws growing lines, cut where they leave the plot, error bands around them, and points.
#include <algorithm>
#include <array>
#include <cmath>

#include "panels/plot/layers.h"

namespace carom::plot {
namespace {

constexpr double slack = 1.0;         // pixels beyond the area that still lie in it
constexpr double half_of_head = 0.3;  // of the arrow at an exit, units

double distance(const Point& a, const Point& b) { return std::hypot(a.x - b.x, a.y - b.y); }

Point between(const Point& from, const Point& to, double share) {
    return {std::lerp(from.x, to.x, share), std::lerp(from.y, to.y, share)};
}

// At most 45 degrees off the upright of the edge, so that the arrow is not taken for a part of it.
Exit exit_at(const Rect& area, const Point& at, Point along) {
    const double beyond_x = std::max(area.x - at.x, at.x - area.right());
    const double beyond_y = std::max(area.y - at.y, at.y - area.bottom());
    const double length = std::hypot(along.x, along.y);
    along = {along.x / length, along.y / length};
    double &across = beyond_y >= beyond_x ? along.y : along.x,
           &beside = beyond_y >= beyond_x ? along.x : along.y;
    if (std::abs(across) < std::abs(beside)) {
        across = std::copysign(std::sqrt(0.5), across);
        beside = std::copysign(std::sqrt(0.5), beside);
    }
    return {{std::clamp(at.x, area.x, area.right()), std::clamp(at.y, area.y, area.bottom())},
            along};
}

// Takes away what lies at most `by` from an end of a path, if its end is at `at`.
void shorten(std::vector<Point>& path, const Point& at, double by) {
    for (int end = 0; end < 2; ++end) {
        std::ranges::reverse(path);
        if (path.size() < 2 || distance(path.front(), at) > 2.0 * slack) continue;
        std::size_t inside = 0;
        while (inside + 1 < path.size() && distance(path[inside + 1], at) < by) ++inside;
        if (inside + 1 == path.size()) {
            path.clear();
            continue;
        }
        const double near = distance(path[inside], at), far = distance(path[inside + 1], at);
        path[inside] = between(path[inside], path[inside + 1],
                               far > near ? std::max(0.0, by - near) / (far - near) : 0.0);
        path.erase(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(inside));
    }
}

}  // namespace

std::optional<std::pair<double, double>> part_in(const Rect& area, Point from, Point to) {
    double first = 0.0, last = 1.0;
    const auto cut = [&](double start, double way, double low, double high) {
        if (way == 0.0) return start >= low && start <= high;
        const auto [near, far] = std::minmax({(low - start) / way, (high - start) / way});
        first = std::max(first, near);
        last = std::min(last, far);
        return first <= last;
    };
    const bool meet = cut(from.x, to.x - from.x, area.x - slack, area.right() + slack) &&
                      cut(from.y, to.y - from.y, area.y - slack, area.bottom() + slack);
    if (!meet) return {};
    return std::pair{first, last};
}

CutPath cut_to(const Rect& area, std::span<const Point> path, double apart) {
    CutPath cut;
    const auto leave = [&](const Point& at, const Point& along) {
        const bool is_known = std::ranges::any_of(
            cut.exits, [&](const Exit& exit) { return distance(exit.at, at) < apart; });
        if (!is_known) cut.exits.push_back(exit_at(area, at, along));
    };
    bool goes_on = false;
    for (std::size_t i = 1; i < path.size(); ++i) {
        const Point &from = path[i - 1], &to = path[i];
        const auto part = part_in(area, from, to);
        if (!part) {
            goes_on = false;
            continue;
        }
        const auto [first, last] = *part;
        if (first > 0.0) leave(between(from, to, first), {from.x - to.x, from.y - to.y});
        if (!goes_on || first > 0.0)
            cut.pieces.push_back({first > 0.0 ? between(from, to, first) : from});
        cut.pieces.back().push_back(last < 1.0 ? between(from, to, last) : to);
        if (last < 1.0) leave(cut.pieces.back().back(), {to.x - from.x, to.y - from.y});
        goes_on = last == 1.0;
    }
    return cut;
}

std::vector<std::vector<Point>> draw_exits(Canvas& canvas, const Frame& frame,
                                           std::span<const Point> path, const Polyline& line) {
    constexpr double apart = 0.8;  // units
    CutPath cut = cut_to(frame.area, path, frame.pixels(apart));
    if (!line.marks_exits) return std::move(cut.pieces);
    for (const Exit& exit : cut.exits) draw_exit(canvas, frame, exit, line.stroke);
    for (std::vector<Point>& piece : cut.pieces)
        for (const Exit& exit : cut.exits) shorten(piece, exit.at, frame.pixels(half_of_head));
    std::erase_if(cut.pieces, [](const auto& piece) { return piece.size() < 2; });
    return std::move(cut.pieces);
}

std::optional<Exit> exit_of(const Frame& frame, const Level& level) {
    constexpr double from_end = 0.6;  // units
    const Rect& area = frame.area;
    const double x = area.right() - frame.pixels(from_end), y = frame.y(level.value);
    if (is_in_area(frame, {x, y})) return {};
    return y < area.y ? Exit{{x, area.y}, {0.0, -1.0}} : Exit{{x, area.bottom()}, {0.0, 1.0}};
}

void draw_exit(Canvas& canvas, const Frame& frame, const Exit& exit, const Stroke& stroke) {
    constexpr double edge = 0.06;  // units
    const double length = frame.pixels(2.0 * half_of_head), half = 0.5 * length;
    const Point &tip = exit.at, &out = exit.outward;
    const Point foot{tip.x - length * out.x, tip.y - length * out.y};
    const std::array<Point, 3> head{{tip,
                                     {foot.x - half * out.y, foot.y + half * out.x},
                                     {foot.x + half * out.y, foot.y - half * out.x}}};
    const std::array<Point, 4> around{head[0], head[1], head[2], head[0]};
    canvas.stroke_path(around, 2.0 * frame.pixels(edge), frame.dc.theme.page);
    canvas.fill_polygon(head, color_of(stroke, frame.dc.theme));
}

namespace {

constexpr double detail = 0.08;  // units: points nearer than half a line's width show nothing new

template <class Curve>
std::size_t end_of(const Curve& curve) {
    return std::min(curve.shown.end, curve.x.size());
}

bool piece_ends(const Polyline& line, std::size_t i) {
    return i + 1 == end_of(line) || (line.piece && (*line.piece)[i + 1] != (*line.piece)[i]);
}

}  // namespace

void draw_layer(Canvas& canvas, const Frame& frame, const Polyline& line) {
    std::vector<Point> path;
    std::optional<Point> last;
    bool is_inside = true;
    for (std::size_t i = line.shown.first; i < end_of(line); ++i) {
        const bool is_known = std::isfinite(line.y[i]);
        if (is_known) last = {frame.x(line.x[i]), frame.y(line.y[i])};
        if (is_known && (path.empty() || !line.is_thinned ||
                         is_apart(path.back(), *last, frame.pixels(detail))))
            path.push_back(*last);
        is_inside = is_inside && (!is_known || is_in_area(frame, *last));
        if (!piece_ends(line, i) || path.empty()) continue;
        if (is_apart(path.back(), *last, 0.0)) path.push_back(*last);
        if (is_inside)
            draw_stroke(canvas, frame.dc, path, line.stroke);
        else
            for (const std::vector<Point>& piece : draw_exits(canvas, frame, path, line))
                draw_stroke(canvas, frame.dc, piece, line.stroke);
        path.clear();
        is_inside = true;
    }
    if (last && line.head && is_in_area(frame, *last))
        draw_dot(canvas, frame.dc, *last, *line.head);
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
            const double across = band.is_along_x ? band.error[i] : 0.0;
            const double up = band.is_along_x ? 0.0 : band.error[i];
            const Point high{frame.x(band.x[i] + across), frame.y(band.y[i] + up, Beyond::clamped)};
            const Point low{frame.x(band.x[i] - across), frame.y(band.y[i] - up, Beyond::clamped)};
            if (ends || upper.empty() || is_apart(upper.back(), high, frame.pixels(detail)) ||
                is_apart(lower.back(), low, frame.pixels(detail))) {
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
        draw_dot(canvas, frame.dc, at, points.dot);
        if (points.spacing > 0.0) last = at;
    }
}

}  // namespace carom::plot
