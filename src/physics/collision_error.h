// Errors thrown when collisions go on without end at one instant, or exceed the limit of the run.
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "physics/advance_result.h"

namespace carom {

class CollisionError : public std::runtime_error {
  public:
    explicit CollisionError(const std::string& what,
                            std::optional<std::int32_t> particle = std::nullopt,
                            std::string hint = "")
        : std::runtime_error(what), particle_(particle), hint_(std::move(hint)) {}

    /// The number in the gas of the particle that collides so often; unset if no single particle
    /// does.
    std::optional<std::int32_t> particle() const { return particle_; }
    const std::string& hint() const { return hint_; }  ///< suggested change

  private:
    std::optional<std::int32_t> particle_;
    std::string hint_;
};

/// Statistics of the collisions that follow the limit of a run.
struct CollisionsSeen {
    std::int64_t most = 0;          ///< the limit
    double begin = 0.0, end = 0.0;  ///< interval of simulated time in which they are counted
    std::int64_t count = 0;
    std::optional<std::int32_t> particle = {};  ///< the particle that takes part in more than half
                                                ///< of them
    std::vector<double> place = {};             ///< position of this particle
    Ties ties = {};                             ///< of the run so far
};

/// Thrown when a run has reached its largest number of collisions.
class TooManyCollisions : public CollisionError {
  public:
    explicit TooManyCollisions(const CollisionsSeen& seen);

    const CollisionsSeen& seen() const { return seen_; }

  private:
    CollisionsSeen seen_;
};

}  // namespace carom
