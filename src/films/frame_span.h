// A part of a film, chosen by simulated time.
#pragma once

#include <optional>
#include <vector>

#include "scene/time/timeline.h"

namespace carom {

/// The frames [first, end) of a film.
struct FrameSpan {
    int first = 0, end = 0;
    int frames() const { return end - first; }

    template <class Archive>
    void archive(Archive& archive) {
        archive(first, end);
    }
};

/// The first of the frames of the gas (not of a title or end card) whose simulated time is nearest
/// to `time`. A frame over which a card fades is chosen only if no other frame is as near. `ticks`
/// must be the complete timeline() of a scene with this film.
int frame_nearest_to(const Film& film, const std::vector<Tick>& ticks, double time);

/// The span from the first frame nearest to `from` to the last one nearest to `to`, including
/// pauses at these times. A frame over which a card fades is taken as first or last only if no
/// other shows the same time. A missing `from` means the start of the film, a missing `to` its end.
/// Requires from < to.
FrameSpan frames_between(const Film& film, const std::vector<Tick>& ticks,
                         std::optional<double> from, std::optional<double> to);

}  // namespace carom
