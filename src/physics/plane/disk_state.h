// The state of a disk in the event loop, and the constant properties of disks.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "physics/collision/lanes.h"
#include "physics/collision/loop_types.h"
#include "physics/particles.h"
#include "physics/plane/cell_grid.h"
#include "util/memory/large_pages.h"

namespace carom {

/// All that is needed to test and collide a pair of equal disks, in one cache line.
struct alignas(64) DiskState {
    std::array<double, 2> x;  ///< at the disk's own time; may lie a little outside a periodic box
    std::array<double, 2> v;
    double time;  ///< local
    std::uint32_t collisions;
    Cell cell;
    Prediction prediction;

    template <class Archive>
    void archive(Archive& archive) {
        archive(x, v, time, collisions, cell, prediction);
    }
};
static_assert(sizeof(DiskState) == 64);

/// As the generic advance_body(). Values that are read as a pair are also written as a pair: a
/// processor can forward only what was stored as a unit.
inline void advance_body(DiskState& d, double now) {
    const TwoLanes x = load_two(d.x.data()), v = load_two(d.v.data());
    store_two(x + v * (now - d.time), d.x.data());
    d.time = now;
}

using DiskStates = LargeVector<DiskState>;

/// The properties of each disk, stored only once if all disks are alike.
class DiskProperties {
  public:
    explicit DiskProperties(const Particles& particles);

    const Properties& operator[](std::int32_t i) const {
        return each_[static_cast<std::size_t>(i) & mask_];
    }
    const Properties& operator[](std::size_t i) const { return each_[i & mask_]; }

    /// Whether all disks have the same nonzero radius and the same finite mass.
    bool alike() const { return alike_; }

    /// Renumbers the disks: disk k is the one that had the number before[k].
    void renumber(const std::vector<std::int32_t>& before);

    /// In the order that the disks have.
    template <class Archive>
    void archive(Archive& archive) {
        archive(each_);
    }

  private:
    LargeVector<Properties> each_;
    std::size_t mask_ = 0;  ///< applied to disk numbers: 0 if there is only one entry
    bool alike_ = false;
};

}  // namespace carom
