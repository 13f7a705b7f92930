// A part of a film, by simulated time.
#pragma once

#include <optional>
#include <vector>

#include "scene/time/timeline.h"

namespace carom {

/// Frames [first, end) of a film.
struct FrameSpan {
    int first = 0, end = 0;
    int frames() const { return end - first; }

    template <class Archive>
    void archive(Archive& archive) {
        archive(first, end);
    }
};

/// The first of the frames of the gas whose time is nearest to `time`, of those that no card
/// covers if there are any. `ticks` are a whole timeline() of a scene with this film.
int frame_nearest_to(const Film& film, const std::vector<Tick>& ticks, double time);

/// From the first frame nearest to `from` to the last one nearest to `to`, with the pauses there,
/// and without a card over these two if others show the same; where one is not given, from the
/// film's start or to its end. Needs from < to.
FrameSpan frames_between(const Film& film, const std::vector<Tick>& ticks,
                         std::optional<double> from, std::optional<double> to);

}  // namespace carom
