// All surfaces of a box during a run: what each does at present, where those are that move, when a
// disk reaches one, and what that changes. For doubles and for many bits. Knows no cells, no queue
// and no other disks.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "physics/gas.h"
#include "physics/plane/falling_disk.h"
#include "physics/run.h"
#include "physics/surface.h"
#include "physics/surfaces/barrier.h"
#include "physics/surfaces/barrier_contact.h"
#include "physics/surfaces/mover.h"

namespace carom {

/// What events change of a surface, at one time.
template <typename Scalar>
struct SurfaceControl {
    Behaviour behaviour = Reflecting{};
    bool is_open = false;
    bool is_held = false;   ///< a piston that stands still
    Scalar velocity = 0.0;  ///< along its normal
};

template <typename Scalar>
class SurfaceSet {
  public:
    using Body = FallingDisk<Scalar>;
    using Vector = std::array<Scalar, 2>;

    /// Barriers have their images about a periodic box as far as `reach`. A mover is registered
    /// anew whenever it has moved by `registered` along its axis.
    SurfaceSet(const Box& box, double reach, const std::array<double, 2>& registered, int bits);

    /// All barriers, those of open partitions too, numbered from 0; the same in the whole run.
    const std::vector<Barrier>& barriers() const { return barriers_; }
    const Barrier& barrier(std::int32_t k) const { return barriers_[static_cast<std::size_t>(k)]; }

    /// Whether it is in the box at present, and whether it may move.
    bool is_there(const Barrier& barrier) const;
    bool is_mobile(const Barrier& barrier) const { return mover_of(barrier) != nullptr; }
    /// Along which its surface moves, if it does.
    std::size_t axis_of(const Barrier& barrier) const {
        return movers_[static_cast<std::size_t>(barrier.surface)].axis;
    }
    /// Whether it lets all disks of a species through.
    bool lets_pass(const Barrier& barrier, std::int32_t species) const;
    /// How often its motion has changed, as predictions count it.
    std::uint32_t changes_of(const Barrier& barrier) const;

    Vector velocity_of(const Barrier& barrier, const Scalar& now) const;
    /// Where a disk touches it.
    Vector contact_point(const Body& body, const Barrier& barrier, const Scalar& now) const;

    /// Whether a disk may touch a barrier from `now` until so much later: false only where it
    /// certainly does not.
    bool may_touch(const DiskView& disk, double radius, std::int32_t barrier, const Scalar& now,
                   double within) const;

    /// Time from `now` until a disk touches a barrier, `never` if it does not.
    Scalar time_to(const Body& body, std::int32_t barrier, const Scalar& now) const;

    /// A disk is at a barrier, at the present: what the surface does. False if it lets the disk
    /// through, or the disk does not approach. Throws std::runtime_error where a driven wall
    /// crushes the gas.
    bool hit(Body& body, std::int32_t barrier, const Scalar& now);

    /// Gives a disk its acceleration. One that lies on a wall and does not leave it does not fall:
    /// the wall carries it.
    void settle_at_rest(Body& body);
    /// To be called when a disk has met another: the same, and it has left what let it through.
    void path_has_changed(Body& body) {
        if (some_passed_) body.passing = 0;
        if (has_gravity_ && (at_rest_ > 0 || body.v[0] == 0.0 || body.v[1] == 0.0))
            settle_at_rest(body);
    }
    /// How many do not fall for that reason.
    std::int64_t count_at_rest() const { return at_rest_; }

    /// The surface that a disk overlaps at a time, if any; of `only`, if given.
    std::optional<std::int32_t> overlapped(const Body& body, const Scalar& now,
                                           std::optional<std::int32_t> only = {}) const;

    /// Sides and partitions may move, numbered as surfaces; obstacles may not.
    std::size_t mover_count() const { return movers_.size(); }
    const Mover<Scalar>& mover(std::size_t k) const { return movers_[k]; }

    /// When a mover reaches another surface, or must be registered anew.
    Scalar mover_event(std::size_t k) const;
    /// Carries that out; returns the other mover that it changed, if any. Throws
    /// std::runtime_error where a driven surface reaches another.
    std::optional<std::size_t> process_mover(std::size_t k, const Scalar& now);

    /// What events have set, and sets it from a time on.
    SurfaceControl<Scalar> control(std::int32_t surface, const Scalar& now) const;
    void set_control(std::int32_t surface, const SurfaceControl<Scalar>& control,
                     const Scalar& now);

    /// Registers all movers at the present and bounds the work that is not a crushed gas.
    void enter(const LargeVector<Body>& bodies, const Scalar& now);

    /// Moves all on to a time; counts all times from `shift` later on; reverses all motion.
    void advance(const Scalar& now);
    void shift_epoch(const Scalar& shift);
    void reverse();

    /// Of each surface, at a time; with what has been done since the last call of forget().
    std::vector<SurfaceState> states(const Scalar& now) const;
    /// The work of driven surfaces on disks and pistons since then, and of events on pistons.
    double driven_work() const { return driven_work_; }
    void forget();

    /// The surface that has done most work on disks since then, if any has done any.
    std::optional<std::int32_t> hardest_worker() const;

  private:
    const Mover<Scalar>* mover_of(const Barrier& barrier) const;
    Vector place_of(const Barrier& barrier, const Scalar& now) const;
    BarrierMotion<Scalar> motion_of(const Body& body, const Barrier& barrier,
                                    const Scalar& now) const;
    double energy_of_piston(std::size_t mover) const;
    void set_motion(std::size_t mover, const Scalar& velocity);
    void register_mover(Mover<Scalar>& mover) const;
    void keep_on_its_side(Body& body, const Barrier& line, const Scalar& now) const;
    void reflect(Body& body, const Barrier& barrier, const Scalar& now);
    void leave_bath(Body& body, const Barrier& barrier, double temperature, std::int64_t hit,
                    const Scalar& now);
    void account_for_hit(const Body& body, const Vector& before, const Barrier& barrier);
    double energy_of(const LargeVector<Body>& bodies) const;
    Scalar next_obstacle(const Mover<Scalar>& mover, std::int32_t& other) const;
    static void move_exactly_to(Mover<Scalar>& mover, const Scalar& place);
    void bounce_off(Mover<Scalar>& mover, std::int32_t other, const Scalar& now);

    Box box_;
    std::array<double, 2> registered_;
    int bits_;
    double size_of_box_;
    double least_radius_;                ///< that surfaces see, so that points have a side of them
    std::vector<Behaviour> behaviours_;  ///< of each surface
    std::vector<bool> is_open_, is_held_;
    std::vector<Barrier> barriers_;
    std::vector<std::int32_t> floors_;  ///< lines from wall to wall
    std::vector<Mover<Scalar>> movers_;
    std::vector<SurfaceTotals> totals_;
    bool has_gravity_;
    bool some_passed_ = false;
    std::int64_t at_rest_ = 0;
    double driven_work_ = 0.0;
    double most_work_ = never<double>;
};

extern template class SurfaceSet<double>;
extern template class SurfaceSet<Real>;

}  // namespace carom
