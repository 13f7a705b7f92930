// Records which velocities have changed in an advance, so that users of velocities need not look at
// all particles after each advance.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "physics/vec.h"

namespace carom {

/// The velocity of a particle before an advance and after it.
struct VelocityChange {
    std::int32_t particle;
    Vec before, after;
};

/// Keeps one entry for each particle whose velocity has changed. Above a maximum number of entries
/// the log is given up, because looking at all particles is then faster.
class VelocityLog {
  public:
    /// Clears the log and starts recording changes of up to `most` particles.
    void open(std::size_t most);
    bool is_open() const { return is_open_; }

    /// Records the next change of a particle.
    void note(std::int32_t particle, const Vec& before, const Vec& after);

    /// Gives up the log, because velocities have changed without being recorded.
    void give_up() { is_open_ = false; }

    /// The changes since open(), in no particular order; nothing if not all of them are known.
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
    std::vector<std::uint32_t> slots_;  ///< hash table of indices into changes_, plus 1; 0 is a
                                        ///< free slot
    int slot_bits_ = 0;
};

/// Decides before each advance whether velocity changes are recorded: as long as they are few.
class VelocityFollowing {
  public:
    explicit VelocityFollowing(bool is_possible) : pause_(is_possible ? 0 : never) {}

    bool is_on() const { return pause_ == 0; }

    /// To be called after each advance with whether its changes were known.
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
