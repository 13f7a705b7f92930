// The plane: disks in two dimensions, who may touch whom and when. Finds neighbours in a grid of
// cells (cell_grid.h), times by pair_collision.h. Knows no queue order and no clock.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "physics/arena.h"
#include "physics/cell_grid.h"
#include "physics/event_queue.h"
#include "physics/pair_collision.h"

namespace carom {

class Plane {
  public:
    static constexpr int dimension = 2;

    /// All that a pair needs to be tested and to collide: one cache line.
    struct alignas(64) Body {
        std::array<double, 2> x;  ///< at the disk's own time; in a periodic box not wrapped until
                                  ///< it crosses the border
        std::array<double, 2> v;
        double time;  ///< local
        double radius;
        double inverse_mass;
        std::uint32_t collisions;
        Cell cell;
    };
    static_assert(sizeof(Body) == 64);
    using Bodies = std::vector<Body>;

    Plane(const Box& box, const Eigen::ArrayXd& radii);

    /// The order in which bodies shall lie in memory: disks near each other in the box near each
    /// other, along a Z-curve through the cells. Few stay as they are: they fit into the cache.
    std::vector<std::int32_t> order(const Bodies& bodies) const;

    /// Whether so many bodies are put in order again now and then.
    static bool sorts_again(std::size_t count);

    /// Takes the bodies as they are, in order, at time 0.
    void enter(Bodies& bodies);

    /// What happens next to a body.
    Event foresee(const Bodies& bodies, std::int32_t i, double now, const EventQueue& queue);

    /// The same when it has just crossed the side of a cell; `before` is what was foreseen until
    /// then, whose contact still holds.
    Event foresee_after_crossing(const Bodies& bodies, std::int32_t i, int side,
                                 const Event& before, double now, const EventQueue& queue);

    /// The body goes over to the next cell.
    void cross(Bodies& bodies, std::int32_t i, int side, double now);

    /// Changes the velocities of two disks in contact that are at one time, false if they do not
    /// approach (a graze, by round-off).
    bool collide(Bodies& bodies, std::int32_t i, std::int32_t j, Contact<2>& contact) const;

  private:
    struct Near {
        std::int32_t other;
        double shift_x, shift_y;
    };
    /// A disk that may be touched.
    struct Suitor {
        RelativeMotion<double> motion;
        double sigma;
        std::int32_t other;
    };

    void note_near(const Bodies& bodies, std::int32_t i, std::int32_t other, double shift_x,
                   double shift_y);
    Event first_event(const Bodies& bodies, const Body& a, double now, Event first);
    void consider(const Bodies& bodies, const Body& a, const Suitor& s, double now,
                  Event& first) const;
    void foresee_border(const Body& d, double x, double y, double now, Event& first) const;
    bool separation_at_contact(const Body& a, const Body& b, double& x, double& y) const;

    Box box_;
    CellGrid grid_;
    std::vector<Near> near_;           ///< scratch: the disks to be looked at
    std::vector<Suitor> suitors_;      ///< scratch, as many as near_
    bool narrow_[2] = {false, false};  ///< periodic and so narrow that two images may touch
};

}  // namespace carom
