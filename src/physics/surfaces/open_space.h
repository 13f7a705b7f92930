// The disks or spheres of plain_space.h in boxes with active surfaces, obstacles or gravity: which
// of them may touch, which surfaces they reach, and when. Each cell lists the barriers at rest that
// a body in it may touch; for each moving barrier the band of cells from which it may be touched is
// known. For doubles and for multiprecision. Independent of the event queue and the clock.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "physics/box.h"
#include "physics/cells/axis_lanes.h"
#include "physics/cells/falling_body.h"
#include "physics/cells/pair_search.h"
#include "physics/collision/loop_types.h"
#include "physics/particles.h"
#include "physics/surfaces/surface_set.h"

namespace carom {

/// The access of a geometry with surfaces to the event queue: the time until the next event of a
/// body, rounded up, and a function that replaces this event by an earlier one. The latter returns
/// false and does nothing if the new event is not earlier.
template <typename Scalar>
struct Agenda {
    std::function<double(std::int32_t)> time_left;
    std::function<bool(std::int32_t, const Scalar& time)> move_forward;
};

/// Creates the bodies of these particles, with their species.
template <typename Scalar, int Dimension>
LargeVector<FallingBody<Scalar, Dimension>> falling_bodies_of(const Particles& particles) {
    auto bodies = PlainBodies<FallingBody<Scalar, Dimension>>::bodies_of(particles);
    for (std::size_t i = 0; i < bodies.size(); ++i)
        bodies[i].species = particles.species[static_cast<Eigen::Index>(i)];
    return bodies;
}

extern template class PairSearch<FallingBody<double, 2>>;
extern template class PairSearch<FallingBody<double, 3>>;

template <typename Scalar, int Dimension>
class OpenSpace : public PairSearch<FallingBody<Scalar, Dimension>> {
  public:
    using Base = PairSearch<FallingBody<Scalar, Dimension>>;
    using Body = FallingBody<Scalar, Dimension>;
    using Bodies = LargeVector<Body>;
    using Set = SurfaceSet<Scalar, Dimension>;
    using Base::axes;
    using typename Base::Cell, typename Base::Grid, typename Base::Point;

    OpenSpace(const Box& box, const Particles& particles, const Arithmetic& arithmetic = {});

    static Bodies bodies_of(const Particles& particles) {
        return falling_bodies_of<Scalar, Dimension>(particles);
    }

    Set& surfaces() { return surfaces_; }
    const Set& surfaces() const { return surfaces_; }

    /// Enters bodies that have been advanced to the present, and registers the surfaces.
    void enter(Bodies& bodies);
    /// The same for bodies whose positions have not changed.
    void resettle(Bodies& bodies);

    /// Whether the grid still fits the part of space that the walls enclose at a time. If not,
    /// the bodies must be entered again at that time, which creates a new grid.
    bool fits_grid(const Scalar& now) const;

    /// Advances a body to a time, as advance_body().
    void advance(Body& body, const Scalar& now) const {
        if constexpr (of_doubles)
            if (all_fall()) return advance_body(body, now, gravity_);
        advance_body(body, now);
    }

    /// Predicts the next event of a body, stores it in the body, and returns its local time.
    Scalar predict(Bodies& bodies, std::int32_t i, const Scalar& now);
    /// As in PlainSpace.
    bool predict_both(Bodies& bodies, std::int32_t i, std::int32_t j, const Scalar& now,
                      std::array<Scalar, 2>& when);
    /// The same for a body that has just crossed the side of a cell.
    Scalar predict_after_crossing(Bodies& bodies, std::int32_t i, int side, const Scalar& now);

    /// Changes the velocities of two bodies in contact that have been advanced to the same time.
    /// Returns false if they do not approach.
    bool collide(Bodies& bodies, std::int32_t i, std::int32_t j, Contact<Dimension>& contact);

    /// To be called after a mover has changed its motion or was registered again: for each body
    /// that it reaches before the body's predicted event, the hit becomes the next event of the
    /// body.
    void look_for_hits(Bodies& bodies, std::size_t mover, const Scalar& now,
                       const Agenda<Scalar>& agenda);

    /// Calls see(k) for the barriers that a body in the cell of body i may touch.
    template <typename See>
    void for_each_barrier(const Bodies& bodies, std::int32_t i, const See& see) const {
        const Cell& cell_of_body = at(bodies, i).cell;
        const int cell = list_of(cell_of_body);
        for (std::int32_t k = at(first_listed_, cell); k < at(first_listed_, cell + 1); ++k)
            see(at(listed_, k));
        for (const Moving& moving : moving_)
            if (moving.first <= cell_of_body[moving.axis] &&
                cell_of_body[moving.axis] <= moving.last)
                see(moving.barrier);
    }

    template <class Archive>
    void archive(Archive& archive) {
        Base::archive(archive);
        archive(gridded_, surfaces_, moving_, listed_, first_listed_);
        note_ends_of_grid();
    }

  private:
    using Base::at, Base::box_, Base::coincidences_, Base::grid_, Base::near_, Base::properties_,
        Base::origin_, Base::of_doubles;

    /// The first event found so far.
    struct First {
        Scalar time = never<double>;
        std::int32_t partner = 0;
        std::uint32_t partner_collisions = 0;

        First() = default;
        First(Scalar at, std::int32_t who, std::uint32_t collisions)
            : time(std::move(at)), partner(who), partner_collisions(collisions) {}
        explicit First(const FirstContact& contact)
            : First(contact.time, contact.partner(), contact.collisions()) {}
    };
    struct Interval {
        double low = 0.0, high = 0.0;
        double length() const { return high - low; }

        template <class Archive>
        void archive(Archive& archive) {
            archive(low, high);
        }
    };
    /// A movable barrier, and the cells, from `first` to `last` along its axis, from which a body
    /// can reach it before its mover is registered again.
    struct Moving {
        std::int32_t barrier;
        std::size_t axis;
        int first = 0, last = 0;

        template <class Archive>
        void archive(Archive& archive) {
            archive(barrier, axis, first, last);
        }
    };
    using Enclosed = std::array<Interval, axes>;
    Enclosed enclosed(const Scalar& now) const;
    void fit_grid(const Scalar& now, std::size_t count);
    void note_ends_of_grid();
    void list_barriers();
    void list_reach(std::size_t mover);
    double reach_of(std::size_t axis) const;
    /// The number along an axis of the cells that contain a coordinate.
    std::uint16_t cell_number(std::size_t axis, double place) const {
        return grid_.cell_along(axis, place - origin_[axis]);
    }
    /// The list of barriers of a cell.
    int list_of(const Cell& cell) const {
        int list = cell[axes - 1];
        for (std::size_t a = axes - 1; a-- > 0;) list = list * (grid_.last_cell()[a] + 1) + cell[a];
        return list;
    }
    using View = BodyView<Dimension>;
    View view_of(const Body& body, const Scalar& now) const {
        if constexpr (of_doubles)
            if (all_fall()) return View(body, now, gravity_);
        return View(body, now);
    }
    bool all_fall() const { return of_doubles && surfaces_.count_at_rest() == 0; }
    Scalar pair_time(const Body& a, const Body& b, const Point& shift, const Scalar& now) const;
    void look_at_barriers(const Body& body, double radius, const View& view, const Scalar& now,
                          double within, First& first);
    void notice(const Scalar& time, const First& first) {
        const auto when = static_cast<double>(time);
        if (coincidences_.may_coincide(when, static_cast<double>(first.time)))
            coincidences_.note(when);
    }
    auto search_slots(const Bodies& bodies, std::int32_t i, const Scalar& now, First& first);
    Scalar next_event(Body& body, double radius, const Scalar& now, First first);
    double border_time(const Body& body, const View& view, std::uint32_t& side) const;

    int bits_;
    bool screened_;
    double largest_;      ///< largest radius of all bodies
    double image_reach_;  ///< distance up to which barriers have images beyond a periodic side
    Enclosed gridded_;    ///< the region for which the grid was made
    Point gravity_;
    Set surfaces_;
    /// For each axis the cells without a border at the lower and the upper end; -1 if the box is
    /// periodic along it.
    AxisLanes<Dimension> first_with_end_{}, last_with_end_{};
    std::vector<Moving> moving_;
    std::vector<std::int32_t> listed_;        ///< numbers of the barriers at rest, cell by cell
    std::vector<std::int32_t> first_listed_;  ///< first index in listed_ for each cell, plus the
                                              ///< end
};

extern template class OpenSpace<double, 2>;
extern template class OpenSpace<double, 3>;
extern template class OpenSpace<Real, 2>;
extern template class OpenSpace<Real, 3>;

}  // namespace carom
