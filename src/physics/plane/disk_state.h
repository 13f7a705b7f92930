// A disk as the event loop has it, and what disks are apart from that.
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

/// All that a pair of disks alike needs to be tested and to collide: one cache line.
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

/// As for any body. What is read as a pair is written as a pair: a processor can hand on at once
/// only what it stored in one piece.
inline void advance_body(DiskState& d, double now) {
    const TwoLanes x = load_two(d.x.data()), v = load_two(d.v.data());
    store_two(x + v * (now - d.time), d.x.data());
    d.time = now;
}

using DiskStates = LargeVector<DiskState>;

/// The properties of each disk; of disks that are all alike, once.
class DiskProperties {
  public:
    explicit DiskProperties(const Particles& particles);

    const Properties& operator[](std::int32_t i) const {
        return each_[static_cast<std::size_t>(i) & mask_];
    }
    const Properties& operator[](std::size_t i) const { return each_[i & mask_]; }

    /// All have one radius, not 0, and one mass that is not infinite.
    bool alike() const { return alike_; }

    /// Gives the disks new numbers: k is who was before[k].
    void renumber(const std::vector<std::int32_t>& before);

    /// In the order that the disks have.
    template <class Archive>
    void archive(Archive& archive) {
        archive(each_);
    }

  private:
    LargeVector<Properties> each_;
    std::size_t mask_ = 0;  ///< of numbers: 0 where there is but one entry
    bool alike_ = false;
};

}  // namespace carom
