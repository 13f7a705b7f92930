// The plane: disks in two dimensions between walls that reflect or are periodic, which pairs touch
// (pair_search.h), and when a disk reaches a wall. Knows no queue and no clock.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "physics/collision/lanes.h"
#include "physics/collision/loop_types.h"
#include "physics/plane/disk_state.h"
#include "physics/plane/pair_search.h"

namespace carom {

extern template class PairSearch<DiskState>;

class Plane : public PairSearch<DiskState> {
  public:
    Plane(const Box& box, const Particles& particles, const Arithmetic& = {});

    /// The bodies of these particles.
    static Bodies bodies_of(const Particles& particles);

    /// Finds out what happens next to a body, which keeps it, and returns when (local time).
    double predict(Bodies& bodies, std::int32_t i, double now);

    /// The same for two bodies that have just collided; false, and nothing is found, where one
    /// might meet the other again before it meets a third.
    bool predict_both(Bodies& bodies, std::int32_t i, std::int32_t j, double now,
                      std::array<double, 2>& when);

    /// The same for a body that has just crossed the side of a cell: the contact that was predicted
    /// before still holds.
    double predict_after_crossing(Bodies& bodies, std::int32_t i, int side, double now);

    /// Changes the velocities of two disks in contact that are at one time, false if they do not
    /// approach (a graze, by round-off).
    bool collide(Bodies& bodies, std::int32_t i, std::int32_t j, Contact<2>& contact) const;

  private:
    double next_event(Body& d, double radius, double now, const FirstContact& contact) const;

    TwoLanes cell_size_{}, last_cell_{}, overhang_{};  ///< of the grid, as lanes
    TwoLanes box_size_{};
    TwoMasks solid_{};  ///< of the walls
    bool has_walls_ = false;
};

}  // namespace carom
