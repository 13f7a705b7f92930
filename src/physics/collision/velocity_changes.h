// Which velocities have changed in an advance, for those who would otherwise look at all particles
// again and again.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace carom {

/// The velocity of a particle before an advance and after it; y is 0 in 1-D.
struct VelocityChange {
    std::int32_t particle;
    std::array<double, 2> before, after;
};

/// Keeps one entry for each particle whose velocity has changed. Beyond a number of them it keeps
/// none: looking at all particles takes less time then.
class VelocityLog {
  public:
    /// From now on changes are noted, of so many particles at most, and those noted before are
    /// forgotten.
    void open(std::size_t most);
    bool is_open() const { return is_open_; }

    /// The next change of a particle.
    void note(std::int32_t particle, const std::array<double, 2>& before,
              const std::array<double, 2>& after);

    /// Velocities have changed of which nothing is noted.
    void give_up() { is_open_ = false; }

    /// Those since open(), in no particular order; none if not all are known.
    std::optional<std::span<const VelocityChange>> changes() const {
        if (!is_open_) return std::nullopt;
        return changes_;
    }

  private:
    static constexpr std::uint32_t vacant = 0;

    std::size_t slot_of(std::int32_t particle) const;
    void grow();

    bool is_open_ = false;
    std::size_t most_ = 0;
    std::vector<VelocityChange> changes_;
    std::vector<std::uint32_t> slots_;  ///< a hash table of numbers in changes_, from 1
    int slot_bits_ = 0;
};

/// Decides from advance to advance whether the changes of the next are followed: as long as they
/// are few.
class VelocityFollowing {
  public:
    explicit VelocityFollowing(bool is_possible) : pause_(is_possible ? 0 : never) {}

    bool is_on() const { return pause_ == 0; }

    /// After each advance; whether its changes were known.
    void see(bool were_known) {
        constexpr int advances_in_pause = 16;
        if (pause_ == never) return;
        if (is_on() && !were_known)
            pause_ = advances_in_pause;
        else
            pause_ = std::max(0, pause_ - 1);
    }

  private:
    static constexpr int never = -1;
    int pause_;
};

}  // namespace carom
