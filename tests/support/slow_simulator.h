// A simple simulator of hard disks, as a reference for the fast one: at each event it examines all
// pairs (with all periodic images) and all walls, moves all disks to the earliest contact, and
// carries out the collision. It has no cell grid, no event queue and no local times, and uses the
// textbook quadratic formula; its arithmetic is long double, which makes up for its larger
// round-off.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "physics/box.h"
#include "physics/particles.h"
#include "support/slow_rounds.h"

namespace carom::test {

struct SlowEvent {
    long double time;
    std::int32_t first, second;  ///< as in carom::Collision; first < second for a pair
    int contacts = 1;  ///< carried out, of all that coincide and are connected (slow_rounds.h)
    bool is_doubtful = false;  ///< round-off decides which coincide
};

class SlowSimulator {
  public:
    SlowSimulator(const Box& box, const Particles& particles, const Sample& start);

    /// Advances to the next collision and returns it; none if there is none before `end`.
    std::optional<SlowEvent> next(long double end);

    /// Takes over the state of another simulator.
    void adopt(const Sample& state);

    long double x(std::int32_t i) const { return disks_[static_cast<std::size_t>(i)].x; }
    long double y(std::int32_t i) const { return disks_[static_cast<std::size_t>(i)].y; }
    long double vx(std::int32_t i) const { return disks_[static_cast<std::size_t>(i)].vx; }
    long double vy(std::int32_t i) const { return disks_[static_cast<std::size_t>(i)].vy; }

  private:
    struct Disk {
        long double x, y, vx, vy, radius, inverse_mass;
    };
    struct Candidate {
        long double wait;
        std::int32_t first, second;
        long double shift_x, shift_y;
    };
    void look_at_pairs(Candidate& best) const;
    void look_at_walls(Candidate& best) const;
    long double longest_step() const;
    void fly(long double wait);
    void collide(const Candidate& event);
    void append_touches_of_pair(std::size_t i, std::size_t j, std::vector<SlowTouch>& all) const;
    void append_touches_of_walls(std::size_t i, std::vector<SlowTouch>& all) const;
    bool grazes(const Candidate& event) const;
    void settle(const Candidate& first, SlowEvent& event);

    Box box_;
    std::vector<Disk> disks_;
    long double time_ = 0.0L;
};

}  // namespace carom::test
