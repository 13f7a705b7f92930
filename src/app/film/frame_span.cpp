#include "app/film/frame_span.h"

#include <cmath>

namespace carom {

int frame_nearest_to(const std::vector<Tick>& ticks, double time) {
    std::size_t nearest = 0;
    while (is_card(ticks[nearest].phase)) ++nearest;
    for (std::size_t i = nearest; i < ticks.size() && !is_card(ticks[i].phase); ++i)
        if (std::abs(ticks[i].time - time) < std::abs(ticks[nearest].time - time)) nearest = i;
    return static_cast<int>(nearest);
}

FrameSpan frames_between(const std::vector<Tick>& ticks, std::optional<double> from,
                         std::optional<double> to) {
    FrameSpan span{0, static_cast<int>(ticks.size())};
    if (from) span.first = frame_nearest_to(ticks, *from);
    if (!to) return span;
    std::size_t last = static_cast<std::size_t>(frame_nearest_to(ticks, *to));
    while (last + 1 < ticks.size() && ticks[last + 1].time == ticks[last].time &&
           !is_card(ticks[last + 1].phase))
        ++last;
    span.end = static_cast<int>(last) + 1;
    return span;
}

}  // namespace carom
