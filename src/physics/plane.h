// The plane: disks in two dimensions, who may touch whom and when. Finds neighbours in a grid of
// cells (cell_grid.h), and the first of them to be touched by contact_search.h. Knows no queue
// order and no clock.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "physics/arena.h"
#include "physics/cell_grid.h"
#include "physics/contact_search.h"
#include "physics/event_queue.h"
#include "physics/flying_disk.h"
#include "physics/lanes.h"

namespace carom {

class Plane {
  public:
    using Body = FlyingDisk;
    using Bodies = FlyingDisks;

    Plane(const Box& box, const Eigen::ArrayXd& radii, const Arithmetic& = {});

    /// The order in which bodies shall lie in memory: disks near each other in the box near each
    /// other, along a Z-curve through the cells. Few stay as they are: they fit into the cache.
    std::vector<std::int32_t> order(const Bodies& bodies) const;

    /// Whether so many bodies are put in order again now and then.
    static bool sorts_again(std::size_t count);

    /// Takes the bodies as they are, in order, at time 0.
    void enter(Bodies& bodies);

    /// The same bodies in another order, at any times of their own.
    void renumber(const Bodies& bodies);

    /// What happens next to a body.
    Event foresee(const Bodies& bodies, std::int32_t i, double now, const EventQueue& queue);

    /// What happens next to two bodies that have just collided; false, and nothing is found, where
    /// one might meet the other again before it meets a third.
    bool foresee_both(const Bodies& bodies, std::int32_t i, std::int32_t j, double now,
                      const EventQueue& queue, std::array<Event, 2>& next);

    /// The same when it has just crossed the side of a cell; `before` is what was foreseen until
    /// then, whose contact still holds.
    Event foresee_after_crossing(const Bodies& bodies, std::int32_t i, int side,
                                 const Event& before, double now, const EventQueue& queue);

    /// The body goes over to the next cell.
    void cross(Bodies& bodies, std::int32_t i, int side, double now);

    /// Changes the velocities of two disks in contact that are at one time, false if they do not
    /// approach (a graze, by round-off).
    bool collide(Bodies& bodies, std::int32_t i, std::int32_t j, Contact<2>& contact) const;

    /// Asks the processor for what the event of a disk will need: the disks that it changes; when
    /// these are there, the cells about them; and when these are, the disks in them.
    void fetch_disks_ahead(const Bodies& bodies, std::int32_t i, const EventQueue& queue) const;
    void fetch_cells_ahead(const Bodies& bodies, std::int32_t i, const EventQueue& queue) const;
    void fetch_neighbours_ahead(const Bodies& bodies, std::int32_t i, const EventQueue& queue);

  private:
    void fill_up_lanes(std::int32_t i);
    void search(const Bodies& bodies, std::int32_t i, double now, const Pairing& pairing,
                const EventQueue& queue, FirstContact& first);
    auto search_slots(const Bodies& bodies, std::int32_t i, double now, const EventQueue& queue,
                      FirstContact& first);
    const Pairing& pairing_near(Cell cell) const;
    Cell next_cell(Cell cell, int side) const;
    Event next_event(const Body& d, double now, const FirstContact& contact) const;
    bool separation_at_contact(const Body& a, const Body& b, double& x, double& y) const;

    Box box_;
    CellGrid grid_;
    Pairing nearest_, only_;  ///< with several images, and with the only one
    std::vector<std::int32_t> near_ =
        std::vector<std::int32_t>(2 * CellGrid::spare);  ///< scratch: the disks to be looked at
    std::size_t near_count_ = 0;

    std::array<int, 2> last_cell_{};
    std::array<unsigned, 2> first_inner_{}, inner_cells_{};  ///< with no other image around
    TwoLanes cell_size_{}, box_size_{};
    TwoLanes last_cells_{};  ///< last_cell_, as numbers to compare with
    TwoMasks solid_{};       ///< of the walls
    bool has_walls_ = false;
    std::array<bool, 2> narrow_{};            ///< periodic and so narrow that two images may touch
    std::array<double, 2> surely_nearest_{};  ///< a disk less far away is the image in contact
};

}  // namespace carom
