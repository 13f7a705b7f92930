// Where walls and partitions are that move at given velocities, before anything is simulated: when
// one of them would reach another, or leave the disks no room.
#pragma once

#include <cstdint>
#include <optional>

#include "physics/gas.h"
#include "physics/run.h"

namespace carom {

struct DrivenEnd {
    double time;
    double room;                        ///< length left between the outer walls
    std::int32_t surface;               ///< that moves there
    std::optional<std::int32_t> other;  ///< that it reaches; none: the disks have no room
};

/// The first such end of a run, up to its first reversal. `area` is that of all disks. Pistons,
/// which go where they are pushed, are not looked at.
std::optional<DrivenEnd> driven_end(const Box& box, const Run& run, double area);

}  // namespace carom
