// Collisions that go on without end at one instant, or beyond the ceiling of the run.
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace carom {

class CollisionError : public std::runtime_error {
  public:
    explicit CollisionError(const std::string& what,
                            std::optional<std::int32_t> particle = std::nullopt,
                            std::string hint = "")
        : std::runtime_error(what), particle_(particle), hint_(std::move(hint)) {}

    /// The particle that collides so often, by its number in the gas; none: no single one does.
    std::optional<std::int32_t> particle() const { return particle_; }
    const std::string& hint() const { return hint_; }  ///< what to change

  private:
    std::optional<std::int32_t> particle_;
    std::string hint_;
};

/// What is seen of the collisions at the ceiling of a run.
struct CollisionsSeen {
    std::int64_t most = 0;          ///< the ceiling
    double begin = 0.0, end = 0.0;  ///< simulated time in which they are counted
    std::int64_t count = 0;
    std::optional<std::int32_t> particle = {};  ///< of which more than half of them are
    std::vector<double> place = {};             ///< of this particle
};

/// A run has reached its ceiling.
class TooManyCollisions : public CollisionError {
  public:
    explicit TooManyCollisions(const CollisionsSeen& seen);

    const CollisionsSeen& seen() const { return seen_; }

  private:
    CollisionsSeen seen_;
};

}  // namespace carom
