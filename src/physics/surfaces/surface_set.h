// The surfaces of a box during a run and their interaction with a single particle: when it reaches
// one, and how that changes its motion. For doubles and for multiprecision. Independent of cells,
// the event queue and other particles.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "physics/box.h"
#include "physics/cells/falling_body.h"
#include "physics/run.h"
#include "physics/surface.h"
#include "physics/surfaces/barrier.h"
#include "physics/surfaces/barrier_contact.h"
#include "physics/surfaces/moving_surfaces.h"
#include "util/random.h"

namespace carom {

/// `Dimension` is 2 in the plane and on a line, whose beads have a second coordinate 0, and 3 in
/// space.
template <typename Scalar, int Dimension>
class SurfaceSet : public MovingSurfaces<Scalar, Dimension> {
  public:
    using Base = MovingSurfaces<Scalar, Dimension>;
    using Body = FallingBody<Scalar, Dimension>;
    using Base::axes;
    using typename Base::Barrier, typename Base::Lengths, typename Base::Vector;

    /// As for MovingSurfaces; `bits`: precision of the scalar.
    SurfaceSet(const Box& box, double reach, const Lengths& registered, int bits);

    /// The point at which a body touches a barrier.
    Vector contact_point(const Body& body, const Barrier& barrier, const Scalar& now) const;

    /// Whether a body may touch a barrier between `now` and `now` + `within`; false only if it
    /// certainly does not.
    bool may_touch(const BodyView<Dimension>& view, double radius, std::int32_t barrier,
                   const Scalar& now, double within) const;

    /// Time from `now` until a body touches a barrier, or `never`.
    Scalar time_to(const Body& body, std::int32_t barrier, const Scalar& now) const;

    /// Processes a body that has reached a barrier at the present. Returns false if the surface
    /// lets it through or it does not approach. Throws SurfaceError if a driven wall
    /// crushes the gas.
    bool hit(Body& body, std::int32_t barrier, const Scalar& now);

    /// How a body touches a barrier at a time.
    struct Touch {
        Scalar gap;
        Vector normal;  ///< of length 1, from the body to the barrier
    };
    /// Empty if it does not face the barrier, if that lets it through, or if particles leave it
    /// in random directions, which do not show how it was hit.
    std::optional<Touch> touch(const Body& body, std::int32_t barrier, const Scalar& now) const;
    /// To be called when a body that touches a barrier has been reflected by one of several
    /// contacts at the present: counts the hit. `normal`: as in Touch; `before`: its velocity
    /// before. Throws SurfaceError if a driven wall crushes the gas.
    void count_hit(Body& body, std::int32_t barrier, const Vector& normal, const Vector& before,
                   const Scalar& now);

    bool has_gravity() const { return has_gravity_; }

    /// Sets the acceleration of a body. One that lies on a wall and does not leave it does not
    /// fall, because the wall supports it.
    void settle_at_rest(Body& body);
    /// To be called after a body has collided with another or with a surface: updates its
    /// acceleration in the same way.
    void path_has_changed(Body& body) {
        if (has_gravity_ && (at_rest_ > 0 || stands_along_an_axis(body))) settle_at_rest(body);
    }
    /// The number of bodies that do not fall for that reason.
    std::int64_t count_at_rest() const { return at_rest_; }

    /// The surface that a body overlaps at a time, if any; with `only`, only that surface is
    /// tested.
    std::optional<std::int32_t> overlapped(const Body& body, const Scalar& now,
                                           std::optional<std::int32_t> only = {}) const;

    /// Registers all movers at the present and sets the limit on the work above which the gas
    /// counts as crushed.
    void enter(const LargeVector<Body>& bodies, const Scalar& now);

    /// The state of each surface at a time, with the totals since the last call of forget().
    std::vector<SurfaceState> states(const Scalar& now) const;
    /// The work of driven surfaces on bodies and pistons since then, and of events on pistons.
    double driven_work() const { return driven_work_; }
    void forget();

    /// The surface that has done the most work on bodies since then, if any has done positive work.
    std::optional<std::int32_t> hardest_worker() const;

    template <class Archive>
    void archive(Archive& archive) {
        Base::archive(archive);
        archive(totals_, at_rest_);
    }

  private:
    using Motion = BarrierMotion<Scalar, Dimension>;
    using Kind = typename Barrier::Kind;

    Motion motion_of(const Body& body, const Barrier& barrier, const Scalar& now) const;
    /// Whether a component of its velocity is 0, as it is if the body lies on a floor.
    static bool stands_along_an_axis(const Body& body) {
        bool stands = false;
        for (const Scalar& v : body.v) stands |= v == 0.0;
        return stands;
    }
    bool is_point(const Body& body) const { return body.radius < slack_; }
    double side_of_origin(const Body& body, const Barrier& flat, const Motion& m) const;
    bool put_on_side(Body& body, const Barrier& flat, double side, const Motion& m) const;
    static Vector separation_from(const Barrier& barrier, const Vector& x);
    void reflect(Body& body, const Barrier& barrier, const Motion& m, const Scalar& now);
    void leave_bath(Body& body, const Barrier& barrier, double temperature, std::int64_t hit,
                    const Vector& from);
    void scatter(Body& body, const Barrier& barrier, std::int64_t hit, const Vector& from);
    Random random_of_hit(std::int32_t surface, std::int64_t hit) const;
    void account_for_hit(const Body& body, const Vector& before, const Barrier& barrier);
    double energy_of(const LargeVector<Body>& bodies) const;

    using Base::at, Base::barriers_, Base::behaviours_, Base::box_, Base::driven_work_,
        Base::is_held_, Base::is_open_, Base::most_work_, Base::movers_, Base::slack_;

    int bits_;
    double clearance_;  ///< the distance from a line or a face that a point keeps where its side
                        ///< would otherwise be lost in round-off, and the radius of edges and
                        ///< corners for points: a few units in the last place of a coordinate
    double size_of_box_;
    std::vector<std::int32_t> floors_;  ///< what runs from wall to wall, where bodies can rest
    std::vector<SurfaceTotals> totals_;
    bool has_gravity_;
    std::int64_t at_rest_ = 0;
};

extern template class SurfaceSet<double, 2>;
extern template class SurfaceSet<double, 3>;
extern template class SurfaceSet<Real, 2>;
extern template class SurfaceSet<Real, 3>;

}  // namespace carom
