// The obvious simulator of hard disks, to check the fast one against: at each event it looks at all
// pairs (all images) and all walls, moves everybody to the earliest, and collides. No grid, no
// queue, no local times, textbook quadratic formula; long double makes up for its round-off.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "physics/gas.h"
#include "physics/particles.h"

namespace carom::test {

struct SlowEvent {
    long double time;
    std::int32_t first, second;  ///< as in carom::Collision; first < second for a pair
};

class SlowSimulator {
  public:
    SlowSimulator(const Box& box, const Particles& particles, const Sample& start);

    /// Goes on to the next collision, nothing if there is none before `end`.
    std::optional<SlowEvent> next(long double end);

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

    Box box_;
    std::vector<Disk> disks_;
    long double time_ = 0.0L;
};

}  // namespace carom::test
