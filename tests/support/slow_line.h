// The obvious simulator of beads on a line, to check the fast one against: at each event it looks
// at all neighbours and both ends, moves everybody to the earliest contact, and collides. The order
// of the beads is fixed at the start. No queue, no local times; long double makes up for its
// round-off.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "physics/gas.h"
#include "physics/particles.h"
#include "support/slow_simulator.h"

namespace carom::test {

class SlowLine {
  public:
    SlowLine(const Box& box, const Particles& particles, const Sample& start);

    /// Goes on to the next collision, nothing if there is none before `end`. Of several at one
    /// time, pairs come before walls, low numbers before high ones. Two neighbours of infinite mass
    /// pass through each other: such scenes are not for it.
    std::optional<SlowEvent> next(long double end);

    long double x(std::int32_t i) const;  ///< in [0, length) on a ring
    long double vx(std::int32_t i) const { return beads_[static_cast<std::size_t>(i)].v; }

  private:
    struct Bead {
        long double x, v, radius, inverse_mass;  ///< x grows beyond the length on a ring
    };
    struct Contact {
        long double wait;
        std::int32_t first, second;  ///< as in SlowEvent
    };
    std::vector<Contact> contacts() const;
    void look_at_pair(std::int32_t left, std::int32_t right, long double turn,
                      std::vector<Contact>& found) const;
    void look_at_wall(std::int32_t bead, int side, std::vector<Contact>& found) const;
    void collide(const Contact& contact);

    const Bead& bead(std::int32_t i) const { return beads_[static_cast<std::size_t>(i)]; }

    long double length_;
    bool ring_;
    std::vector<Bead> beads_;
    std::vector<std::int32_t> order_;  ///< from left to right
    long double time_ = 0.0L;
};

}  // namespace carom::test
