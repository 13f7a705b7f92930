// The plane: disks in two dimensions, which pairs may touch and when. Finds neighbours in a grid of
// cells (cell_grid.h), and the first of them to be touched by contact_search.h. Knows no queue and
// no clock.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "physics/collision/lanes.h"
#include "physics/collision/loop_types.h"
#include "physics/plane/cell_grid.h"
#include "physics/plane/contact_search.h"
#include "physics/plane/disk_state.h"

namespace carom {

class Plane {
  public:
    using Body = DiskState;
    using Bodies = DiskStates;

    Plane(const Box& box, const Particles& particles, const Arithmetic& = {});

    /// The bodies of these particles, and what the one or the other is.
    static Bodies bodies_of(const Particles& particles);
    const Properties& properties(const Bodies&, std::size_t i) const { return properties_[i]; }

    /// The order in which bodies shall lie in memory: disks near each other in the box near each
    /// other, along a Z-curve through the cells. Few stay as they are: they fit into the cache.
    /// What the plane itself knows of each is put in that order at once.
    std::vector<std::int32_t> order(const Bodies& bodies);

    /// Whether so many bodies are put in order again now and then.
    static bool is_resorted(std::size_t count);

    /// Takes the bodies as they are, in order, at time 0.
    void enter(Bodies& bodies);

    /// The same bodies in another order, at any times of their own: k is who was before[k].
    void renumber(Bodies& bodies, const std::vector<std::int32_t>& before);

    /// Finds out what happens next to a body, which keeps it, and returns when (local time).
    double predict(Bodies& bodies, std::int32_t i, double now);

    /// The same for two bodies that have just collided; false, and nothing is found, where one
    /// might meet the other again before it meets a third.
    bool predict_both(Bodies& bodies, std::int32_t i, std::int32_t j, double now,
                      std::array<double, 2>& when);

    /// The same for a body that has just crossed the side of a cell: the contact that was predicted
    /// before still holds.
    double predict_after_crossing(Bodies& bodies, std::int32_t i, int side, double now);

    /// The body goes over to the next cell.
    void cross(Bodies& bodies, std::int32_t i, int side, double now);

    /// Changes the velocities of two disks in contact that are at one time, false if they do not
    /// approach (a graze, by round-off).
    bool collide(Bodies& bodies, std::int32_t i, std::int32_t j, Contact<2>& contact) const;

    /// Prefetch what the event of disk i at `time` will need, in this order, each when the one
    /// before has arrived: the disk itself; then, by the same call, its partner; the cells about
    /// both; and the disks in these.
    void fetch_disk_ahead(const Bodies& bodies, std::int32_t i) const;
    void fetch_cells_ahead(const Bodies& bodies, std::int32_t i, double time) const;
    void fetch_neighbours_ahead(const Bodies& bodies, std::int32_t i, double time);

    /// The other disk of the event of disk i at `time`, or i where there is none.
    static std::int32_t partner_ahead(const Bodies& bodies, std::int32_t i, double time);

  private:
    void fill_grid(const Bodies& bodies);
    void fill_up_lanes(std::int32_t i);
    void search(const Bodies& bodies, std::int32_t i, double now, const Pairing& pairing,
                FirstContact& first);
    auto search_slots(const Bodies& bodies, std::int32_t i, double now, FirstContact& first);
    const Pairing& pairing_near(Cell cell) const;
    double next_event(Body& d, double radius, double now, const FirstContact& contact) const;
    bool separation_at_contact(const Body& a, const Body& b, double sigma, double& x,
                               double& y) const;
    bool separation_of_images(const Body& a, const Body& b, double sigma, double& x,
                              double& y) const;
    template <std::size_t usual>
    void fetch_listed(const Bodies& bodies);

    Box box_;
    CellGrid grid_;
    DiskProperties properties_;
    Pairing nearest_, only_;  ///< with several images, and with the only one
    std::vector<std::int32_t> near_ =
        std::vector<std::int32_t>(4 * CellGrid::spare);  ///< scratch: the disks to be looked at
    std::size_t near_count_ = 0;

    TwoLanes cell_size_{}, last_cell_{}, overhang_{};  ///< of the grid, as lanes
    TwoLanes box_size_{};
    TwoMasks solid_{};  ///< of the walls
    bool has_walls_ = false;
    std::array<double, 2> surely_nearest_{};  ///< a disk less far away is the image in contact
};

}  // namespace carom
