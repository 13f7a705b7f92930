// Selects which values of a film's frames are kept when a scale is to be derived from all of them:
// a few from each frame, and different ones from frame to frame.
#pragma once

#include <Eigen/Core>
#include <algorithm>

namespace carom {

/// The number of values kept of all frames together; slightly more may be kept.
constexpr double most_kept_of_film = 200'000;

/// Calls `keep(i)` for the selected ones of the `count` values of a frame; `numbers` is the number
/// of all values of one frame, which sets how many are kept.
void for_each_kept(Eigen::Index count, double numbers, int frame, int frames, const auto& keep) {
    const auto stride =
        std::max<Eigen::Index>(1, static_cast<Eigen::Index>(numbers * frames / most_kept_of_film));
    for (Eigen::Index i = frame % stride; i < count; i += stride) keep(i);
}

}  // namespace carom
