// Time-driven simulation with a fixed time step, as in many teaching programs: at the end of each
// step all pairs of particles that overlap and approach collide at their present positions.
// Particles overlap and may even pass through each other; a film next to an event-driven run shows
// the consequences. Replaces EventLoop (event_loop.h) in a Simulation. Each step costs O(N^(3/2)).
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "physics/advance_result.h"
#include "physics/box.h"
#include "physics/collision/velocity_changes.h"
#include "physics/particles.h"
#include "physics/run.h"
#include "physics/surfaces/surface_error.h"

namespace carom {

class FixedStepLoop {
  public:
    /// Disks, or spheres, in a box with plain walls; `step` > 0 is a time. After `most` collisions
    /// advance() throws CollisionError.
    FixedStepLoop(const Box& box, const Particles& particles, double step,
                  std::int64_t most = std::numeric_limits<std::int64_t>::max());

    /// The interface of EventLoop, as Simulation uses it. Between the ends of two steps particles
    /// are in free flight; a reversal or a displacement begins a new step.
    void start(Sample state);
    void advance(double time, std::vector<Collision>* record, const TimeCallback& on_progress = {},
                 VelocityLog* velocities = nullptr);
    void reverse(double time);
    std::optional<Partner> displace(std::int64_t particle, const Displacement& by, double time);
    void sample(double time, Sample& state) const;
    Sample sample_of_positions(double time) const;
    Sample sample_of_velocities(double time) const { return {time, {}, now_.velocity}; }
    std::vector<double> positions(double time) const;
    const CollisionCounts& counts() const { return counts_; }
    const ImpulseTotals& impulses() const { return impulses_; }
    void forget();
    std::vector<SurfaceState> surfaces(double) const { return {}; }
    double driven_work() const { return 0.0; }
    double heat_of_events() const { return 0.0; }
    SurfaceError at_present(const SurfaceError& error) const { return error; }

    template <class Archive>
    void archive(Archive& archive) {
        archive(step_, first_, steps_, now_, order_, counts_, impulses_, collisions_);
    }

  private:
    void move_to(double time);
    void reflect(std::vector<Collision>* record);
    void collide_overlapping(std::vector<Collision>* record);
    void collide(std::int32_t first, std::int32_t second, std::vector<Collision>* record);
    void count_collisions(std::int64_t in_step);
    Vec place(std::int32_t i) const { return vec_in(now_.position, i); }
    Vec velocity(std::int32_t i) const { return vec_in(now_.velocity, i); }

    Box box_;
    Particles particles_;
    double step_;
    double first_ = 0.0;               ///< the time from which steps are counted
    std::int64_t steps_ = 0;           ///< since then
    Sample now_;                       ///< periodic coordinates are not wrapped into the box
    std::vector<std::int32_t> order_;  ///< particles sorted by their x coordinate
    CollisionCounts counts_;
    ImpulseTotals impulses_;
    std::int64_t collisions_ = 0;  ///< since start()
    std::int64_t most_;
};

}  // namespace carom
