// The paths of walls and partitions that move at prescribed velocities, determined without a
// simulation: whether one of them would reach another, or leave the particles no room.
#pragma once

#include <cstdint>
#include <optional>

#include "physics/box.h"
#include "physics/run.h"

namespace carom {

struct DrivenEnd {
    double time;
    double room;                        ///< length left between the outer walls
    std::int32_t surface;               ///< the surface that moves
    std::optional<std::int32_t> other;  ///< the surface that it reaches; unset: the particles have
                                        ///< no room
};

/// The first such end before the first reversal of a run, if any. `content`: the area or the volume
/// of all particles.
/// Pistons are ignored, because their motion depends on the gas.
std::optional<DrivenEnd> driven_end(const Box& box, const Run& run, double content);

}  // namespace carom
