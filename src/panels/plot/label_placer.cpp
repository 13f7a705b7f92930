#include "panels/plot/label_placer.h"

#include <algorithm>

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

bool LabelPlacer::is_free(const Rect& words) const {
    const auto crosses = [&](const auto& segment) {
        return meets(words, segment.first, segment.second);
    };
    const auto overlaps = [&](const Rect& other) {
        return words.x < other.right() && other.x < words.right() && words.y < other.bottom() &&
               other.y < words.bottom();
    };
    return std::ranges::none_of(segments_, crosses) && std::ranges::none_of(words_, overlaps);
}

}  // namespace carom::plot
