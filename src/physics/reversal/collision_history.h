// The sequence of collision partners of each particle along the path of a reversed run
// (reversal_schedule.h). Where the run retraces its path, each particle must collide with the same
// partners again.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include "physics/advance_result.h"
#include "physics/reversal/reversal_schedule.h"

namespace carom {

class CollisionHistory {
  public:
    /// Collisions separated by less than `slack` along the path may change their order.
    CollisionHistory(Eigen::Index particles, double slack)
        : of_particle_(static_cast<std::size_t>(particles)), slack_(slack) {}

    /// Records a collision, or compares it with the one recorded before; returns false if they
    /// contradict each other.
    bool record(const Branch& branch, const Collision& collision);

    /// For each particle its number of collisions relative to the start, to be compared at a second
    /// visit.
    std::vector<std::ptrdiff_t> checkpoint() const;

    /// Whether each particle is at the same place in its sequence of collisions as at a checkpoint,
    /// apart from collisions at this very moment.
    bool is_at(const std::vector<std::ptrdiff_t>& checkpoint, double path) const;

    /// Forgets what has been recorded ahead of the beginning of this branch, in its direction.
    void forget_ahead(const Branch& branch);

    /// Marks the path as recorded up to `path`; to be called while the run advances.
    void extend_to(double path);

  private:
    struct Entry {
        Partner partner;
        double path;
    };
    struct OfParticle {
        std::deque<Entry> entries;
        std::ptrdiff_t position = 0;  ///< index of the next entry in the direction of the initial
                                      ///< run
        std::ptrdiff_t before_start = 0;  ///< number of entries from before the start; negative if
                                          ///< entries from after the start were forgotten
    };

    bool record(int direction, double path, std::int32_t particle, Partner partner);

    std::vector<OfParticle> of_particle_;
    double slack_;
    double low_ = 0.0, high_ = 0.0;
};

}  // namespace carom
