#include "panels/plot/label_placer.h"

#include <algorithm>
#include <cmath>

namespace carom::plot {

bool meets(const Rect& part, const Point& from, const Point& to) {
    const double left = std::max(part.x, std::min(from.x, to.x));
    const double right = std::min(part.right(), std::max(from.x, to.x));
    if (left > right) return false;
    double first = from.y, second = to.y;
    if (from.x != to.x) {
        const double slope = (to.y - from.y) / (to.x - from.x);
        first = from.y + slope * (left - from.x);
        second = from.y + slope * (right - from.x);
    }
    return std::min(first, second) <= part.bottom() && std::max(first, second) >= part.y;
}

bool LabelPlacer::is_inside(const Rect& words) const {
    constexpr double slack = 0.5;  // pixels
    return words.x >= area_.x - slack && words.right() <= area_.right() + slack &&
           words.y >= area_.y - slack && words.bottom() <= area_.bottom() + slack;
}

void LabelPlacer::keep_clear(Point from, Point to, double width) {
    segments_.push_back({from, to, width, line_});
}

void LabelPlacer::keep_off_marker(double x, double top, double bottom, double width) {
    markers_.push_back({{x, top}, {x, bottom}, width});
}

namespace {

double distance(const Rect& part, const Point& at) {
    return std::hypot(std::max({part.x - at.x, at.x - part.right(), 0.0}),
                      std::max({part.y - at.y, at.y - part.bottom(), 0.0}));
}

double distance(const Point& at, const Point& from, const Point& to) {
    const double x = to.x - from.x, y = to.y - from.y, square = x * x + y * y;
    const double along = (at.x - from.x) * x + (at.y - from.y) * y;
    const double share = square > 0.0 ? std::clamp(along / square, 0.0, 1.0) : 0.0;
    return std::hypot(from.x + share * x - at.x, from.y + share * y - at.y);
}

double distance(const Rect& part, const Point& from, const Point& to) {
    if (meets(part, from, to)) return 0.0;
    double least = std::min(distance(part, from), distance(part, to));
    for (const double x : {part.x, part.right()})
        for (const double y : {part.y, part.bottom()})
            least = std::min(least, distance(Point{x, y}, from, to));
    return least;
}

}  // namespace

bool LabelPlacer::is_nearest_line(std::size_t line, const Rect& words, double close) const {
    double own = INFINITY, others = INFINITY;
    for (const Segment& segment : segments_) {
        if (!segment.line) continue;
        double& least = *segment.line == line ? own : others;
        least = std::min(least, distance(words, segment.from, segment.to));
    }
    return own < others || own <= close || own == INFINITY;
}

bool LabelPlacer::is_nearest_level(double y, const Rect& words) const {
    constexpr double same = 0.5;  // pixels
    const auto distance = [&](double level) {
        return std::max({words.y - level, level - words.bottom(), 0.0});
    };
    return std::ranges::none_of(levels_, [&](double other) {
        return std::abs(other - y) > same && distance(other) <= distance(y);
    });
}

void LabelPlacer::place(const Rect& words) {
    parts_.push_back(words);
    placed_.push_back(words);
}

bool LabelPlacer::crosses(const Segment& segment, const Rect& words) {
    const double half = 0.5 * segment.width;
    return meets(
        {words.x - half, words.y - half, words.width + segment.width, words.height + segment.width},
        segment.from, segment.to);
}

bool LabelPlacer::is_free(const Rect& words, bool over_markers) const {
    const auto is_crossed = [&](const Segment& segment) { return crosses(segment, words); };
    const auto overlaps = [&](const Rect& part) { return overlap(words, part); };
    const auto leaves_an_end = [&](const Segment& marker) {
        return words.y > marker.from.y && words.bottom() < marker.to.y;
    };
    if (std::ranges::any_of(parts_, overlaps) || std::ranges::any_of(segments_, is_crossed))
        return false;
    return std::ranges::none_of(markers_, [&](const Segment& marker) {
        return is_crossed(marker) && !(over_markers && leaves_an_end(marker));
    });
}

bool overlap(const Rect& one, const Rect& other) {
    return one.x < other.right() && other.x < one.right() && one.y < other.bottom() &&
           other.y < one.bottom();
}

}  // namespace carom::plot
