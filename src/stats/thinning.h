// Which values of a film's frames are kept where a scale is fixed by all of them: of each frame a
// few, of the next one others.
#pragma once

#include <Eigen/Core>
#include <algorithm>

namespace carom {

/// As many as are kept of all frames, or a little more.
constexpr double most_kept_of_film = 200'000;

/// Calls `keep(i)` for those of `count` values of a frame, where each frame gives `numbers` in all.
void for_each_kept(Eigen::Index count, double numbers, int frame, int frames, const auto& keep) {
    const auto stride =
        std::max<Eigen::Index>(1, static_cast<Eigen::Index>(numbers * frames / most_kept_of_film));
    for (Eigen::Index i = frame % stride; i < count; i += stride) keep(i);
}

}  // namespace carom
