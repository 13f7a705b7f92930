// Where panels measure: parts of the box and lines across it, as plain values; and when a stopwatch
// starts.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "physics/box.h"

namespace carom {

/// The numbers of surfaces at which a panel measures.
using SurfaceNumbers = std::vector<std::int32_t>;

/// A named part of the box.
struct NamedRegion {
    std::string name;
    Region region = {};
};

/// Surfaces or regions at which a panel measures; of a panel that measures in parts of the box,
/// these are its regions, or the two sides of its first surface.
struct MeasuredAt {
    SurfaceNumbers surfaces = {};
    std::vector<NamedRegion> regions = {};
    bool any() const { return !regions.empty() || !surfaces.empty(); }
};

/// A line parallel to an axis or, in space, a plane, across the whole box or a part of it, at which
/// crossing particles are counted.
struct CountingLine {
    int axis = 0;                     ///< the axis perpendicular to it: 0 for x, 1 for y, 2 for z
    double at = 0.0;                  ///< its position on that axis
    std::optional<Gap> between = {};  ///< the part, as of a partition; none: all of it
};

/// When a stopwatch starts.
struct WatchStart {
    double at = 0.0;                        ///< simulated time
    std::optional<std::size_t> event = {};  ///< index in Run::events of what starts it
};

}  // namespace carom
