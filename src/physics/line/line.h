// The line: beads in one dimension. The order of the beads never changes, so it is stored as state
// and not derived from positions, which round-off and contacts of points (of length 0) can leave
// ambiguous. For doubles and for multiprecision; multiprecision lines have so few beads that every
// time is computed with all bits. Independent of the event queue and the clock.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "physics/cells/falling_body.h"
#include "physics/collision/coincidences.h"
#include "physics/collision/loop_types.h"
#include "physics/multiprecision/multiprecision.h"
#include "physics/particles.h"
#include "util/memory/large_pages.h"

namespace carom {

template <typename Scalar>
struct Bead {
    std::array<Scalar, 1> x;  ///< at the bead's own time
    std::array<Scalar, 1> v;
    Scalar time;    ///< local
    double radius;  ///< half its length
    double inverse_mass;
    std::uint32_t collisions;
    std::int32_t turns;  ///< number of turns around a periodic line
    Prediction prediction;

    template <class Archive>
    void archive(Archive& archive) {
        archive(x, v, time, radius, inverse_mass, collisions, turns, prediction);
    }
};

/// A line of beads, or of beads that may fall (surfaces/open_line.h).
template <typename Scalar, typename BodyType = Bead<Scalar>>
class Line : public PlainBodies<BodyType> {
  public:
    using Body = BodyType;
    using Bodies = LargeVector<Body>;

    Line(const Box& box, const Particles& particles, const Arithmetic& = {});

    /// The numbers of the bodies from left to right.
    static std::vector<std::int32_t> order(const Bodies& bodies);

    /// Sets up the line for bodies that are in order and at time 0.
    void enter(Bodies& bodies);

    /// As the functions of PlainSpace.
    Scalar predict(Bodies& bodies, std::int32_t i, const Scalar& now);
    Scalar predict_after_crossing(Bodies& bodies, std::int32_t i, int, const Scalar& now) {
        return predict(bodies, i, now);
    }

    /// The body leaves a periodic line at one end and enters at the other.
    void cross(Bodies& bodies, std::int32_t i, int side, const Scalar& now);

    /// Changes the velocities of two neighbours that have been advanced to the same time. Returns
    /// false if they do not approach. Throws CollisionError if both have infinite mass, because
    /// then neither can pass nor yield.
    bool collide(Bodies& bodies, std::int32_t i, std::int32_t j, Contact<1>& contact) const;

    /// The neighbour that body i overlaps, if any, when all bodies are at the same time. A
    /// neighbour that it only touches, or overlaps by less than `slack` times the length, does not
    /// count.
    std::optional<std::int32_t> overlapped(const Bodies& bodies, std::int32_t i, const Scalar& now,
                                           double slack) const;

    /// As in PairSearch: see(j, shift, side) with side 1 for the neighbour to the right, -1 for
    /// that to the left.
    Coincidences& coincidences() { return coincidences_; }
    void set_margin(double margin) { coincidences_.reset(margin); }
    template <typename See>
    void for_each_neighbour(const Bodies& bodies, std::int32_t i, const See& see) const {
        if (!periodic_ || count_ > 1)
            for (const int side : {1, -1}) {
                const bool at_end = i == (side == 1 ? last() : 0);
                if (at_end && !periodic_) continue;
                const std::int32_t j = at_end ? last() - i : i + side;
                const double turns = bodies[static_cast<std::size_t>(j)].turns -
                                     bodies[static_cast<std::size_t>(i)].turns +
                                     (at_end ? side : 0);
                see(j, std::array<double, 2>{turns * length_, 0.0}, side);
            }
    }

    template <class Archive>
    void archive(Archive& archive) {
        archive(coincidences_);
    }

  protected:
    std::int32_t last() const { return count_ - 1; }
    bool is_periodic() const { return periodic_; }
    void predict_neighbours(const Bodies& bodies, std::int32_t i, const Scalar& now,
                            Event<Scalar>& first);
    void predict_end(const Bodies& bodies, std::int32_t i, const Scalar& now, Event<Scalar>& first);
    /// Stores the first event of a body, notes whether the second may coincide with it, and returns
    /// the time.
    [[gnu::always_inline]] Scalar take(Event<Scalar>& first, Body& body) {
        const auto when = static_cast<double>(first.time);
        if (first.second - when <= coincidences_.margin()) [[unlikely]]
            coincidences_.note(when);
        body.prediction = first;
        return std::move(first.time);
    }

    Coincidences coincidences_;

  private:
    Scalar gap(const Body& left, const Body& right, const Scalar& now, bool around) const;
    void predict_pair(const Bodies& bodies, std::int32_t i, bool to_the_right, const Scalar& now,
                      Event<Scalar>& first);

    double length_;
    bool periodic_;
    std::int32_t count_;
};

extern template class Line<double>;
extern template class Line<Real>;
extern template class Line<double, FallingBody<double>>;
extern template class Line<Real, FallingBody<Real>>;

}  // namespace carom
