// The range of positions along an axis of a box whose sides may move.
#pragma once

#include <algorithm>
#include <utility>

#include "panels/panel.h"
#include "panels/surfaces/surface_words.h"

namespace carom {

/// Widens a range of positions to the positions of the sides in a frame.
inline void widen_to_sides(std::pair<double, double>& range, const Box& box, Eigen::Index axis,
                           const FrameInput& input) {
    const std::vector<SurfaceState>& states = input.advanced.surfaces;
    const auto low = static_cast<std::size_t>(2 * axis);
    range.first = std::min(range.first, place_of_surface(box, states, low));
    range.second = std::max(range.second, place_of_surface(box, states, low + 1));
}

}  // namespace carom
