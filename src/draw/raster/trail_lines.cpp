#include "draw/raster/trail_lines.h"

namespace carom {
namespace {

// Whether the point lies where a line with linearly changing light from `from` to `to` would have
// it.
bool is_on_line(const TrailPlace& place, const TrailPlace& from, const TrailPlace& to) {
    constexpr double seen = 0.05;  // pixels from which a bend is visible
    const double all = to.light - from.light;
    const double share = all > 0.0 ? (place.light - from.light) / all : 0.5;
    const Point there{from.at.x + share * (to.at.x - from.at.x),
                      from.at.y + share * (to.at.y - from.at.y)};
    return !is_apart(place.at, there, seen);
}

}  // namespace

void add_trail_lines(std::vector<Taper>& lines, std::span<const TrailPlace> way, Color ground,
                     Color ink, double unit) {
    const auto width = [&](double light) { return (0.1 + 0.25 * light) * unit; };
    const auto color = [&](double light) { return mix(ground, ink, 0.75 * light); };
    std::size_t first = 0;
    for (std::size_t i = 1; i < way.size(); ++i) {
        const TrailPlace &from = way[first], &to = way[i];
        // A bend shows at the last point but one, a curve at the middle of the line.
        if (i + 1 < way.size() && is_on_line(to, from, way[i + 1]) &&
            is_on_line(way[(first + i + 1) / 2], from, way[i + 1]))
            continue;
        lines.push_back({from.at, to.at, width(from.light), width(to.light), color(from.light),
                         color(to.light)});
        first = i;
    }
}

}  // namespace carom
