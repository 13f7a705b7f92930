#include "films/frame_span.h"

#include <cmath>
#include <utility>

namespace carom {

int frame_nearest_to(const Film& film, const std::vector<Tick>& ticks, double time) {
    const auto distance = [&](const Tick& tick) {
        return std::pair(std::abs(tick.time - time), card_cover(film, tick) > 0.0);
    };
    std::size_t nearest = 0;
    while (is_card(ticks[nearest].phase)) ++nearest;
    for (std::size_t i = nearest; i < ticks.size() && !is_card(ticks[i].phase); ++i)
        if (distance(ticks[i]) < distance(ticks[nearest])) nearest = i;
    return static_cast<int>(nearest);
}

FrameSpan frames_between(const Film& film, const std::vector<Tick>& ticks,
                         std::optional<double> from, std::optional<double> to) {
    FrameSpan span{0, static_cast<int>(ticks.size())};
    if (from) span.first = frame_nearest_to(film, ticks, *from);
    if (!to) return span;
    const auto end = static_cast<std::size_t>(frame_nearest_to(film, ticks, *to));
    const double most_cover = card_cover(film, ticks[end]) > 0.0 ? 1.0 : 0.0;
    std::size_t last = end;
    while (last + 1 < ticks.size() && ticks[last + 1].time == ticks[end].time &&
           !is_card(ticks[last + 1].phase) && card_cover(film, ticks[last + 1]) <= most_cover)
        ++last;
    span.end = static_cast<int>(last) + 1;
    return span;
}

}  // namespace carom
