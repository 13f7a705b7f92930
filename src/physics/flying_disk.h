// A disk as the event loop has it.
#pragma once

#include <array>
#include <cstdint>

#include "physics/cell_grid.h"
#include "physics/lanes.h"
#include "util/large_pages.h"

namespace carom {

/// All that a pair needs to be tested and to collide: one cache line.
struct alignas(64) FlyingDisk {
    std::array<double, 2> x;  ///< at the disk's own time; may lie a little outside a periodic box
    std::array<double, 2> v;
    double time;  ///< local
    double radius;
    double inverse_mass;
    std::uint32_t collisions;
    Cell cell;
};
static_assert(sizeof(FlyingDisk) == 64);

/// As for any body. What is read as a pair is written as a pair: a processor can hand on at once
/// only what it stored in one piece.
inline void fly(FlyingDisk& d, double now) {
    const TwoLanes x = load_two(d.x.data()), v = load_two(d.v.data());
    store_two(x + v * (now - d.time), d.x.data());
    d.time = now;
}

using FlyingDisks = LargeVector<FlyingDisk>;

}  // namespace carom
