// The event-driven simulation of hard particles: owns the state and the time.
// Between events particles fly freely; every contact is computed exactly, none is missed, nothing
// overlaps. Does not know films, files or statistics: it hands out samples and the collisions on
// the way.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>

#include "physics/gas.h"
#include "physics/particles.h"
#include "physics/run.h"
#include "physics/whereabouts.h"

namespace carom {

/// One collision, as it happened.
struct Collision {
    double time;
    std::int32_t first;  ///< particle
    std::int32_t
        second;  ///< particle, or -1 - side for a wall (sides: left 0, right 1, bottom 2, top 3)
    Eigen::Array2d first_position;   ///< centre of `first` at contact; y is 0 in 1-D
    Eigen::Array2d second_position;  ///< centre of `second` (in a periodic box of its image that
                                     ///< touches `first`), or the point of contact on the wall
    Eigen::Array2d first_before, second_before;  ///< velocities; y is 0 in 1-D, a wall's are 0
    Eigen::Array2d first_after, second_after;
};

/// How many collisions have happened since t = 0.
struct CollisionCounts {
    std::int64_t particle = 0;  ///< between two particles
    std::int64_t wall = 0;      ///< of a particle with a wall
    std::int64_t ties = 0;      ///< pairs that shared a particle and an instant with the pair just
                                ///< before: their order is by number, not by physics
};

/// Momentum that has changed hands since t = 0, and how well contacts were met.
struct Transfers {
    std::array<double, 4> wall{};  ///< outward momentum given to each side: left, right, bottom,
                                   ///< top; infinite after a hit by an infinite mass
    double virial = 0.0;  ///< sum over collisions of two particles of r . dp: r from the first
                          ///< to the second, dp what the second received
    double largest_overlap = 0.0;  ///< depth at a collision of two particles, in units of their
                                   ///< contact distance; 0 when none was ever too late
};

/// What happened on the way to a time.
struct Passage {
    CollisionCounts counts;  ///< since t = 0, at the end of the passage
    Transfers transfers;     ///< since t = 0, at the end of the passage
    int reversals = 0;       ///< reversals since t = 0, those at its end included
    std::span<const Collision>
        collisions;  ///< of this passage only, when recording; valid until the next advance
};

/// Told what time it is in a run, every some thousand events.
using TimeTold = std::function<void(double time)>;

/// A nudge that would push a particle into another or into a wall.
class NudgeError : public std::runtime_error {
  public:
    NudgeError(std::size_t event, const std::string& what)
        : std::runtime_error(what), event_(event) {}
    std::size_t event() const { return event_; }  ///< index in Run::events

  private:
    std::size_t event_;
};

class Simulation {
  public:
    /// Places the particles and runs `run.equilibrate`, of which `told` hears, in times before 0;
    /// `run.bits` must be there. Throws PlacementError, Interrupted.
    Simulation(const Gas& gas, const Run& run, const TimeTold& told = {});

    /// Starts from given particles at `start.time` = 0, or `run.equilibrate` before it. Overlapping
    /// particles are a programmer's error (assertion).
    Simulation(const Box& box, Particles particles, const Sample& start, const Run& run);

    ~Simulation();
    Simulation(Simulation&&) noexcept;
    Simulation& operator=(Simulation&&) noexcept;

    /// Processes all events with time <= `time` (inclusive; `run.events` too) and moves on to it.
    /// `time` must not lie in the past; not limited by `run.until`. Throws NudgeError.
    Passage advance_to(double time);

    /// State of all particles at the present time.
    const Sample& sample();

    /// Where all particles are at the present time, in full.
    Whereabouts whereabouts() const;

    /// Whether advance_to hands out the collisions themselves; off at first.
    void record_collisions(bool on);

    /// Bits of the numbers that it calculates with.
    int bits() const;

    const Box& box() const;
    const Particles& particles() const;

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace carom
