// The surfaces of a box during a run, and a disk: when it reaches one, and what that changes. For
// doubles and for many bits. Knows no cells, no queue and no other disks.
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
#include "physics/surfaces/moving_surfaces.h"

namespace carom {

template <typename Scalar>
class SurfaceSet : public MovingSurfaces<Scalar> {
  public:
    using Base = MovingSurfaces<Scalar>;
    using Body = FallingDisk<Scalar>;
    using typename Base::Vector;

    /// As for MovingSurfaces; with so many bits.
    SurfaceSet(const Box& box, double reach, const std::array<double, 2>& registered, int bits);

    /// Where a disk touches a barrier.
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

    bool has_gravity() const { return has_gravity_; }

    /// Gives a disk its acceleration. One that lies on a wall and does not leave it does not fall:
    /// the wall carries it.
    void settle_at_rest(Body& body);
    /// To be called when a disk has met another or a surface: the same.
    void path_has_changed(Body& body) {
        if (has_gravity_ && (at_rest_ > 0 || body.v[0] == 0.0 || body.v[1] == 0.0))
            settle_at_rest(body);
    }
    /// How many do not fall for that reason.
    std::int64_t count_at_rest() const { return at_rest_; }

    /// The surface that a disk overlaps at a time, if any; of `only`, if given.
    std::optional<std::int32_t> overlapped(const Body& body, const Scalar& now,
                                           std::optional<std::int32_t> only = {}) const;

    /// Registers all movers at the present and bounds the work that is not a crushed gas.
    void enter(const LargeVector<Body>& bodies, const Scalar& now);

    /// Of each surface, at a time; with what has been done since the last call of forget().
    std::vector<SurfaceState> states(const Scalar& now) const;
    /// The work of driven surfaces on disks and pistons since then, and of events on pistons.
    double driven_work() const { return driven_work_; }
    void forget();

    /// The surface that has done most work on disks since then, if any has done any.
    std::optional<std::int32_t> hardest_worker() const;

    template <class Archive>
    void archive(Archive& archive) {
        Base::archive(archive);
        archive(totals_, at_rest_);
    }

  private:
    BarrierMotion<Scalar> motion_of(const Body& body, const Barrier& barrier,
                                    const Scalar& now) const;
    void keep_on_its_side(Body& body, const Barrier& line, const Scalar& now) const;
    void reflect(Body& body, const Barrier& barrier, const Scalar& now);
    void leave_bath(Body& body, const Barrier& barrier, double temperature, std::int64_t hit,
                    const Scalar& now);
    void account_for_hit(const Body& body, const Vector& before, const Barrier& barrier);
    double energy_of(const LargeVector<Body>& bodies) const;

    using Base::at, Base::barriers_, Base::behaviours_, Base::box_, Base::driven_work_,
        Base::is_held_, Base::is_open_, Base::least_radius_, Base::most_work_, Base::movers_;

    int bits_;
    double size_of_box_;
    std::vector<std::int32_t> floors_;  ///< lines from wall to wall
    std::vector<SurfaceTotals> totals_;
    bool has_gravity_;
    std::int64_t at_rest_ = 0;
};

extern template class SurfaceSet<double>;
extern template class SurfaceSet<Real>;

}  // namespace carom
