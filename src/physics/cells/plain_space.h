// Disks in the plane, or spheres in space, in a box with reflecting or periodic sides. Determines
// which pairs touch (pair_search.h) and when a body reaches a wall. Independent of the event queue
// and the clock.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "physics/cells/axis_lanes.h"
#include "physics/cells/body_state.h"
#include "physics/cells/pair_search.h"
#include "physics/collision/lanes.h"
#include "physics/collision/loop_types.h"
#include "util/threads/processors.h"

namespace carom {

extern template class PairSearch<BodyState<2>>;
extern template class PairSearch<BodyState<3>>;

template <int Dimension>
class PlainSpace : public PairSearch<BodyState<Dimension>> {
  public:
    using Base = PairSearch<BodyState<Dimension>>;
    using Base::axes;
    using typename Base::Body, typename Base::Bodies;

    PlainSpace(const Box& box, const Particles& particles, const Arithmetic& = {});

    /// Creates the bodies of these particles.
    static Bodies bodies_of(const Particles& particles);

    /// Predicts the next event of a body, stores it in the body, and returns its local time.
    CAROM_FOR_PROCESSORS_WITH_FMA double predict(Bodies& bodies, std::int32_t i, double now);

    /// The same for two bodies that have just collided. Returns false without a result if they
    /// might meet again before either meets a third.
    CAROM_FOR_PROCESSORS_WITH_FMA bool predict_both(Bodies& bodies, std::int32_t i, std::int32_t j,
                                                    double now, std::array<double, 2>& when);

    /// The same for a body that has just crossed the side of a cell: the contact predicted before
    /// remains valid.
    CAROM_FOR_PROCESSORS_WITH_FMA double predict_after_crossing(Bodies& bodies, std::int32_t i,
                                                                int side, double now);

    /// Changes the velocities of two bodies in contact that have been advanced to the same time.
    /// Returns false if they do not approach (a grazing contact, due to round-off).
    CAROM_FOR_PROCESSORS_WITH_FMA bool collide(Bodies& bodies, std::int32_t i, std::int32_t j,
                                               Contact<Dimension>& contact) const;

  private:
    using Base::at, Base::box_, Base::grid_, Base::coincidences_, Base::properties_;
    using Lanes = AxisLanes<Dimension>;
    using Masks = AxisMasks<Dimension>;

    double next_event(Body& b, double radius, double now, const FirstContact& contact);

    Lanes cell_size_{}, last_cell_{}, overhang_{};  ///< parameters of the grid, as lanes
    Lanes box_size_{};
    Masks solid_{};  ///< mask of the axes with solid walls
    bool has_walls_ = false;
};

extern template class PlainSpace<2>;
extern template class PlainSpace<3>;

}  // namespace carom
