// What words in a plot keep clear of: all that its layers draw.
#include <algorithm>
#include <cmath>
#include <optional>
#include <variant>

#include "panels/plot/layers.h"

namespace carom::plot {
namespace {

constexpr double arrow_reach = 0.9;  // units, around where a line leaves the plot

// The whole course of lines and bands, not only the part that a frame shows.
struct Obstacles {
    const Frame& frame;

    // Of a straight piece, only the part in the plot, and the arrow where it leaves that.
    void keep_clear_of_piece(const Point& from, const Point& to, double width) const {
        const auto part = part_in(frame.area, from, to);
        if (!part) return;
        const auto at = [&](double share) {
            return Point{std::lerp(from.x, to.x, share), std::lerp(from.y, to.y, share)};
        };
        const Point first = at(part->first), last = at(part->second);
        frame.placer.keep_clear(first, last, width);
        if (part->first > 0.0) frame.placer.keep_clear(first, first, frame.pixels(arrow_reach));
        if (part->second < 1.0) frame.placer.keep_clear(last, last, frame.pixels(arrow_reach));
    }

    void operator()(const Polyline& line) const {
        const double width = frame.pixels(line.stroke.width);
        std::optional<Point> before;
        for (std::size_t i = 0; i < line.x.size(); ++i) {
            const bool is_there = std::isfinite(line.y[i]);
            const Point now{frame.x(line.x[i]), is_there ? frame.y(line.y[i]) : 0.0};
            if (!is_there) {
                before = {};
            } else if (!before || is_apart(*before, now, frame.pixels(0.1)) ||
                       i + 1 == line.x.size()) {
                if (before) keep_clear_of_piece(*before, now, width);
                before = now;
            }
        }
    }

    void operator()(const Band& band) const {
        std::optional<Rect> piece;
        for (std::size_t i = 0; i < band.x.size(); ++i) {
            if (!std::isfinite(band.error[i])) {
                piece = {};
                continue;
            }
            const double across = band.is_along_x ? band.error[i] : 0.0;
            const double up = band.is_along_x ? 0.0 : band.error[i];
            const double left = frame.x(band.x[i] - across), right = frame.x(band.x[i] + across);
            const double top = frame.y(band.y[i] + up, Beyond::clamped);
            const double bottom = frame.y(band.y[i] - up, Beyond::clamped);
            if (piece) {
                const double first = std::min(piece->x, left), high = std::min(piece->y, top);
                frame.placer.keep_clear({first, high, std::max(piece->right(), right) - first,
                                         std::max(piece->bottom(), bottom) - high});
            }
            piece = Rect{left, top, right - left, bottom - top};
        }
    }

    void operator()(const Points& points) const {
        const double radius = frame.pixels(points.dot.radius + points.dot.halo);
        const std::size_t end = std::min(points.shown.end, points.x.size());
        for (std::size_t i = points.shown.first; i < end; ++i) {
            if (std::isnan(points.y[i])) continue;
            const Point at{frame.x(points.x[i]), frame.y(points.y[i])};
            frame.placer.keep_clear({at.x - radius, at.y - radius, 2.0 * radius, 2.0 * radius});
        }
    }

    void operator()(const Level& level) const {
        const double y = frame.y(level.value);
        if (const auto exit = exit_of(frame, level))
            return frame.placer.keep_clear(exit->at, exit->at, frame.pixels(arrow_reach));
        frame.placer.add_level(y);
        frame.placer.keep_clear({frame.area.x, y}, {frame.area.right(), y},
                                frame.pixels(level.stroke.width));
    }

    void operator()(const Marker& marker) const {
        if (marker.is_under_axis) return;
        const double x = frame.x(marker.value);
        const double top = marker.up_to ? frame.y(*marker.up_to, Beyond::clamped) : frame.area.y;
        frame.placer.keep_off_marker(x, top, frame.area.bottom(),
                                     frame.pixels(marker.stroke.width));
    }

    void operator()(const Bars& bars) const {
        for (std::size_t i = 0; i < bars.value.size(); ++i) {
            const double left = frame.x(bars.from[i]), right = frame.x(bars.to[i]);
            double most = bars.value[i];
            if (i < bars.error.size() && std::isfinite(bars.error[i])) most += bars.error[i];
            const bool is_taller = i < bars.taller.size() && !bars.taller[i].empty();
            const double top = is_taller ? frame.area.y : frame.y(most, Beyond::clamped);
            if (top < frame.area.bottom())
                frame.placer.keep_clear({left, top, right - left, frame.area.bottom() - top});
        }
    }

    void operator()(const Arrow& arrow) const {
        frame.placer.keep_clear({frame.x(arrow.from.x), frame.y(arrow.from.y)},
                                {frame.x(arrow.to.x), frame.y(arrow.to.y)}, frame.pixels(0.65));
    }

    void operator()(const Label&) const {}
};

}  // namespace

void keep_clear_of(const Frame& frame, const AnyLayer& layer) {
    std::visit(Obstacles{frame}, layer);
}

}  // namespace carom::plot
