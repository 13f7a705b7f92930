// The partners of each particle along the path of a reversed run (reversal_schedule.h). Where the
// run has been before, it must collide with the same partners again.
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
    /// Collisions less than `slack` of the path apart may change their order.
    CollisionHistory(Eigen::Index particles, double slack)
        : of_particle_(static_cast<std::size_t>(particles)), slack_(slack) {}

    /// Adds a collision, or compares it with the one recorded; false if it contradicts it.
    bool record(const Branch& branch, const Collision& collision);

    /// For each particle how many collisions from its first state it is, to be compared at a second
    /// visit.
    std::vector<std::ptrdiff_t> checkpoint() const;

    /// Whether each particle is where it was at a checkpoint, up to what happens at this very
    /// moment.
    bool is_at(const std::vector<std::ptrdiff_t>& checkpoint, double path) const;

    /// From the begin of this branch on nothing is recorded of what lies ahead on it.
    void forget_ahead(const Branch& branch);

    /// Declares the path recorded up to `path`, by an observer who goes along.
    void extend_to(double path);

  private:
    struct Entry {
        Partner partner;
        double path;
    };
    struct OfParticle {
        std::deque<Entry> entries;
        std::ptrdiff_t position = 0;      ///< of the next entry in the direction of the start run
        std::ptrdiff_t before_start = 0;  ///< entries from before the start; negative where those
                                          ///< from after it are forgotten
    };

    bool record(int direction, double path, std::int32_t particle, Partner partner);

    std::vector<OfParticle> of_particle_;
    double slack_;
    double low_ = 0.0, high_ = 0.0;
};

}  // namespace carom
