// The plane of plane.h for boxes with surfaces that act, obstacles or gravity: which disks may
// touch, which surfaces they reach, and when. Each cell lists the barriers at rest that a disk in
// it may touch; all moving ones are looked at always, as they are few. Knows no queue and no clock.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "physics/collision/loop_types.h"
#include "physics/gas.h"
#include "physics/particles.h"
#include "physics/plane/cell_grid.h"
#include "physics/surface.h"
#include "physics/surfaces/barrier.h"
#include "physics/surfaces/mover.h"
#include "util/random.h"

namespace carom {

/// A disk that may fall.
struct FallingDisk {
    std::array<double, 2> x, v;  ///< at its own time
    std::array<double, 2> a{};   ///< 0 while it rests on a floor
    double time = 0.0;           ///< local
    double radius = 0.0, inverse_mass = 0.0;
    std::uint32_t collisions = 0;
    Cell cell{};
    std::int32_t species = 0;
    std::int32_t passing = -1;  ///< the barrier that it was let through by and has not left
    Prediction prediction{};    ///< partner < 0: barrier -1 - partner
};

inline double position_at(const FallingDisk& d, std::size_t axis, double time) {
    const double t = time - d.time;
    return d.x[axis] + t * (d.v[axis] + 0.5 * t * d.a[axis]);
}
inline double velocity_at(const FallingDisk& d, std::size_t axis, double time) {
    return d.v[axis] + d.a[axis] * (time - d.time);
}
inline void advance_body(FallingDisk& d, double now) {
    for (std::size_t k = 0; k < 2; ++k) {
        d.x[k] = position_at(d, k, now);
        d.v[k] = velocity_at(d, k, now);
    }
    d.time = now;
}

class OpenPlane : public PlainBodies<FallingDisk> {
  public:
    OpenPlane(const Box& box, const Particles& particles, const Arithmetic& = {});

    // As those of Plane.
    static Bodies bodies_of(const Particles& particles);

    /// Says what time it is, on the user's clock, at local time 0.
    void begin(double time);

    /// Takes the bodies as they are at time 0.
    void enter(Bodies& bodies);

    /// Finds out what happens next to a body, which keeps it, and returns when (local time).
    double predict(Bodies& bodies, std::int32_t i, double now);
    double predict_after_crossing(Bodies& bodies, std::int32_t i, int, double now) {
        return predict(bodies, i, now);
    }

    /// The body goes over to the next cell.
    void cross(Bodies& bodies, std::int32_t i, int side, double now);

    /// Changes the velocities of two disks in contact that are at one time, false if they do not
    /// approach.
    bool collide(Bodies& bodies, std::int32_t i, std::int32_t j, Contact<2>& contact) const;

    /// A disk is at a barrier, at the present: what the surface does. False if it is let through,
    /// or does not approach. Throws std::runtime_error where a driven wall crushes the gas.
    bool hit(Body& body, std::int32_t barrier, double now);

    const Barrier& barrier(std::int32_t k) const { return barriers_[static_cast<std::size_t>(k)]; }
    /// How often the motion of a barrier has changed, as predictions count it.
    std::uint32_t changes_of(const Barrier& barrier) const;

    /// How fast a barrier moves at a time, and where a body touches it.
    std::array<double, 2> velocity_of(const Barrier& barrier, double now) const;
    std::array<double, 2> contact_point(const Body& body, const Barrier& barrier, double now) const;

    /// Of each surface, at a time; with what has been done since the last call of forget().
    std::vector<SurfaceState> states(double now) const;
    void forget() { totals_.assign(totals_.size(), {}); }

    /// The surface that a body overlaps at a time, if any.
    std::optional<std::int32_t> overlapped(const Body& body, double now) const;

    const std::vector<Mover>& movers() const { return movers_; }

    /// When a mover changes its motion by itself, or must be registered anew.
    double mover_event(std::size_t k) const;
    /// Carries that out; returns the other mover that it changed, if any. Throws
    /// std::runtime_error where a driven surface reaches another.
    std::optional<std::size_t> process_mover(std::size_t k, double now);

    /// After a mover has changed its motion, or was registered anew: calls `earlier(i, time)` for
    /// the disks that it reaches before what was predicted, by `time_of(i)`.
    void look_for_hits(Bodies& bodies, std::size_t k, double now,
                       const std::function<double(std::int32_t)>& time_of,
                       const std::function<void(std::int32_t, double)>& earlier);

    /// Counts all times from `shift` later on.
    void shift_epoch(double shift);

    /// Makes a local time, to which all bodies have been advanced, the epoch.
    void move_epoch_to(double now);

    /// Reverses the velocities of all movers, at the epoch.
    void reverse();

  private:
    struct Candidate {
        double time = never<double>;
        std::int32_t partner = 0;
        std::uint32_t partner_collisions = 0;
    };
    void list_barriers();
    void register_mover(Mover& mover) const;
    double reach_of(std::size_t axis) const;
    std::array<double, 2> place_of(const Barrier& barrier, double now) const;
    BarrierMotion motion_of(const Body& body, const Barrier& barrier, double now) const;

    double pair_time(const Body& a, const Body& b, const std::array<double, 2>& shift,
                     double now) const;
    double barrier_time(const Body& body, std::int32_t barrier, double now) const;
    void look_at_barriers(const Body& body, double now, Candidate& first) const;
    double border_time(const Body& body, double now, std::uint32_t& side) const;
    void settle_at_rest(Body& body) const;
    double energy_of(const Bodies& bodies) const;
    void reflect(Body& body, const Barrier& barrier, double now);
    bool goes_through(const Body& body, const Barrier& barrier, const Membrane& membrane) const;
    void leave_bath(Body& body, const Barrier& barrier, double temperature, std::int64_t hit);
    double next_obstacle(const Mover& mover, std::int32_t& other) const;

    Box box_;
    CellGrid grid_;
    double largest_;                     ///< radius
    double least_radius_;                ///< that surfaces see, so that points have a side of them
    std::vector<Behaviour> behaviours_;  ///< of each surface
    std::vector<Barrier> barriers_;
    std::vector<Mover> movers_;
    std::vector<SurfaceTotals> totals_;
    double most_work_ = never<double>;
    std::vector<std::int32_t> moving_;        ///< barriers that move
    std::vector<std::int32_t> floors_;        ///< those at rest from wall to wall
    std::vector<std::int32_t> listed_;        ///< barriers at rest, cell by cell
    std::vector<std::int32_t> first_listed_;  ///< of each cell, and one more
    std::vector<std::int32_t> near_ = std::vector<std::int32_t>(4 * CellGrid::spare);
};

}  // namespace carom
