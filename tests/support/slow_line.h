// A simple simulator of beads on a line, as a reference for the fast one: at each event it examines
// all pairs of neighbours and both ends, moves all beads to the earliest contact, and carries out
// the collision. The order of the beads is fixed at the start. It has no event queue and no local
// times; its arithmetic is long double, which makes up for its larger round-off.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "physics/box.h"
#include "physics/particles.h"
#include "support/slow_simulator.h"

namespace carom::test {

class SlowLine {
  public:
    SlowLine(const Box& box, const Particles& particles, const Sample& start);

    /// Advances to the next collision and returns it; none if there is none before `end`. Of
    /// several collisions at one time that are not connected, pairs come before walls and low
    /// numbers before high ones.
    /// Scenes with two neighbours of infinite mass are not supported: they would pass through each
    /// other.
    std::optional<SlowEvent> next(long double end);

    /// Takes over the state of another simulator.
    void adopt(const Sample& state);

    long double x(std::int32_t i) const;  ///< in [0, length) on a ring
    SlowVector velocity(std::int32_t i) const { return {bead(i).v}; }

  private:
    struct Bead {
        long double x, v, radius, inverse_mass;  ///< on a ring x is not wrapped
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
    std::vector<SlowTouch> touches() const;
    void settle(const Contact& first, SlowEvent& event);

    const Bead& bead(std::int32_t i) const { return beads_[static_cast<std::size_t>(i)]; }

    long double length_;
    bool ring_;
    std::vector<Bead> beads_;
    std::vector<std::int32_t> order_;  ///< from left to right
    long double time_ = 0.0L;
};

}  // namespace carom::test
