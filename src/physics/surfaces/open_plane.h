// The plane of plane.h for boxes with surfaces that act, obstacles or gravity: which disks may
// touch, which surfaces they reach, and when. Each cell lists the barriers at rest that a disk in
// it may touch; all moving ones are looked at always, as they are few. For doubles and for many
// bits. Knows no queue and no clock.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <type_traits>
#include <vector>

#include "physics/collision/loop_types.h"
#include "physics/gas.h"
#include "physics/particles.h"
#include "physics/plane/cell_grid.h"
#include "physics/plane/falling_disk.h"
#include "physics/plane/order_of_cells.h"
#include "physics/surfaces/surface_set.h"

namespace carom {

/// As a plane and a line with surfaces call back: whether a disk has no earlier event than `time`,
/// which is then scheduled for it.
template <typename Scalar>
using Earlier = std::function<bool(std::int32_t, const Scalar& time)>;

/// The bodies of these particles, with their species.
template <typename Scalar>
LargeVector<FallingDisk<Scalar>> falling_bodies_of(const Particles& particles) {
    auto bodies = PlainBodies<FallingDisk<Scalar>>::bodies_of(particles);
    for (std::size_t i = 0; i < bodies.size(); ++i)
        bodies[i].species = particles.species[static_cast<Eigen::Index>(i)];
    return bodies;
}

template <typename Scalar>
class OpenPlane : public PlainBodies<FallingDisk<Scalar>> {
  public:
    using Body = FallingDisk<Scalar>;
    using Bodies = LargeVector<Body>;

    OpenPlane(const Box& box, const Particles& particles, const Arithmetic& arithmetic = {});

    static Bodies bodies_of(const Particles& particles) {
        return falling_bodies_of<Scalar>(particles);
    }

    SurfaceSet<Scalar>& surfaces() { return surfaces_; }
    const SurfaceSet<Scalar>& surfaces() const { return surfaces_; }

    // As those of Plane.
    static bool is_resorted(std::size_t count) {
        return of_doubles && count >= least_in_order_of_cells;
    }
    std::vector<std::int32_t> order(const Bodies& bodies) const {
        return order_of_cells(grid_, bodies);
    }
    void renumber(Bodies& bodies, const std::vector<std::int32_t>& before);

    /// Takes the bodies as they are at the present, and the surfaces.
    void enter(Bodies& bodies);
    /// The same, of bodies that are where they were.
    void resettle(Bodies& bodies);

    /// Finds out what happens next to a body, which keeps it, and returns when (local time).
    Scalar predict(Bodies& bodies, std::int32_t i, const Scalar& now);
    /// The same for a body that has just crossed the side of a cell.
    Scalar predict_after_crossing(Bodies& bodies, std::int32_t i, int side, const Scalar& now);

    /// The body goes over to the next cell.
    void cross(Bodies& bodies, std::int32_t i, int side, const Scalar& now);

    /// Changes the velocities of two disks in contact that are at one time, false if they do not
    /// approach.
    bool collide(Bodies& bodies, std::int32_t i, std::int32_t j, Contact<2>& contact) const;

    /// After a mover has changed its motion, or was registered anew: gives the disks that it
    /// reaches before what was predicted that event.
    void look_for_hits(Bodies& bodies, std::size_t mover, const Scalar& now,
                       const Earlier<Scalar>& earlier);

  private:
    /// The first event found so far.
    struct First {
        Scalar time = never<double>;
        std::int32_t partner = 0;
        std::uint32_t partner_collisions = 0;
    };
    static constexpr bool of_doubles = std::is_same_v<Scalar, double>;
    void fill_grid(const Bodies& bodies);
    void list_barriers();
    double reach_of(std::size_t axis) const;
    Scalar pair_time(const Body& a, const Body& b, const std::array<double, 2>& shift,
                     const Scalar& now) const;
    void look_at_barriers(const Body& body, const Scalar& now, First& first) const;
    auto search_slots(const Bodies& bodies, std::int32_t i, const Scalar& now, First& first);
    Scalar next_event(Body& body, const Scalar& now, First& first);
    Scalar border_time(const Body& body, const Scalar& now, std::uint32_t& side) const;

    Box box_;
    CellGrid grid_;
    int bits_;
    double largest_;  ///< radius
    SurfaceSet<Scalar> surfaces_;
    std::vector<std::int32_t> moving_;        ///< barriers that may move
    std::vector<std::int32_t> listed_;        ///< barriers at rest, cell by cell
    std::vector<std::int32_t> first_listed_;  ///< of each cell, and one more
    std::vector<std::int32_t> near_ = std::vector<std::int32_t>(4 * CellGrid::spare);
};

extern template class OpenPlane<double>;
extern template class OpenPlane<Real>;

}  // namespace carom
