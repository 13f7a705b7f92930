#include "scene/time/showing.h"

#include <algorithm>
#include <cmath>

namespace carom {

Showing showing(const std::vector<Tick>& ticks, const Film& film, const TimeSpan& span,
                std::optional<double> seconds) {
    const auto first_from = [&](double time) {
        const auto found = std::ranges::find_if(ticks, [&](const Tick& tick) {
            return tick.time >= time && tick.phase != Phase::title_card;
        });
        return static_cast<int>(found - ticks.begin());
    };
    Showing shown{.first = first_from(span.from), .from = span.from};
    const int end = static_cast<int>(ticks.size()) - card_frames(film).end;
    shown.last = end - 1;
    if (span.until) shown.last = std::min(shown.last, first_from(*span.until) - 1);
    if (seconds)
        shown.last = std::min(shown.last,
                              shown.first - 1 + static_cast<int>(std::lround(*seconds * film.fps)));
    if (span.until) shown.until = *span.until;
    if (shown.last < shown.first) return shown;
    // If it appears and disappears within one pause, it is shown until the gas moves again.
    const double begin = ticks[static_cast<std::size_t>(shown.first)].time;
    const auto next = std::find_if(ticks.begin() + shown.last + 1, ticks.begin() + end,
                                   [&](const Tick& tick) { return tick.time > begin; });
    if (next != ticks.begin() + end) shown.until = std::min(shown.until, next->time);
    return shown;
}

double opacity(const Showing& showing, const Film& film, int frame, double fade_seconds) {
    if (frame < showing.first || frame > showing.last) return 0.0;
    const auto fade = [&](int frames) {
        return std::min(1.0, (frames + 0.5) / film.fps / fade_seconds);
    };
    const CardFrames cards = card_frames(film);
    const bool at_start = showing.first == cards.title;
    const bool at_end = showing.last + 1 == frame_count(film) - cards.end;
    return std::min(at_start ? 1.0 : fade(frame - showing.first),
                    at_end ? 1.0 : fade(showing.last - frame));
}

}  // namespace carom
