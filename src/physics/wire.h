// The wire: beads in one dimension. Which bead is next to which never changes, so the order is kept
// as state and not read from positions, which round-off and contacts of points (of length 0) leave
// undecided. For doubles, and for numbers of more bits, of which there are so few here that all is
// worked out in full. Knows no queue and no clock.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <vector>

#include "physics/arena.h"
#include "physics/event_queue.h"
#include "physics/exact_queue.h"
#include "util/large_pages.h"

namespace carom {

template <typename Scalar>
class Wire {
  public:
    struct Body {
        std::array<Scalar, 1> x;  ///< at the body's own time
        std::array<Scalar, 1> v;
        Scalar time;    ///< local
        double radius;  ///< half its length
        double inverse_mass;
        std::uint32_t collisions;
        std::int32_t turns;  ///< how often it has gone round a periodic wire
    };
    using Bodies = LargeVector<Body>;
    using Queue = std::conditional_t<std::is_same_v<Scalar, double>, EventQueue, ExactQueue>;
    using Event = std::conditional_t<std::is_same_v<Scalar, double>, carom::Event, ExactEvent>;

    Wire(const Box& box, const Eigen::ArrayXd& radii, const Arithmetic& = {});

    /// The order in which bodies shall lie in memory: along the wire.
    static std::vector<std::int32_t> order(const Bodies& bodies);

    /// Whether bodies are put in order again now and then.
    static bool sorts_again(std::size_t) { return false; }

    /// Takes the bodies as they are, in order, at time 0.
    void enter(Bodies& bodies);

    Event foresee(const Bodies& bodies, std::int32_t i, const Scalar& now, const Queue& queue);
    Event foresee_after_crossing(const Bodies& bodies, std::int32_t i, int side,
                                 const Event& before, const Scalar& now, const Queue& queue);

    /// The body leaves a periodic wire at one end and enters at the other.
    void cross(Bodies& bodies, std::int32_t i, int side, const Scalar& now);

    /// Changes the velocities of two neighbours that are at one time, false if they do not
    /// approach. Throws std::runtime_error when both have infinite mass: neither can pass nor
    /// yield.
    bool collide(Bodies& bodies, std::int32_t i, std::int32_t j, Contact<1>& contact) const;

    /// The neighbour that body i overlaps, when all are at one time, if there is one; not one that
    /// it touches, or overlaps by less than `slack` times the length.
    std::optional<std::int32_t> overlapped(const Bodies& bodies, std::int32_t i, const Scalar& now,
                                           double slack) const;

  private:
    std::int32_t last() const { return count_ - 1; }
    Scalar gap(const Body& left, const Body& right, const Scalar& now, bool around) const;
    void foresee_pair(const Bodies& bodies, std::int32_t i, bool to_the_right, const Scalar& now,
                      Event& first) const;
    void foresee_end(const Bodies& bodies, std::int32_t i, const Scalar& now, Event& first) const;

    double length_;
    bool periodic_;
    std::int32_t count_;
};

extern template class Wire<double>;
extern template class Wire<Real>;

}  // namespace carom
