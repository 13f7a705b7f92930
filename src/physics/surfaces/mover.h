// A surface that moves along its normal: where it is, and when it changes its motion by itself.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "physics/collision/pair_collision.h"
#include "physics/gas.h"

namespace carom {

struct Mover {
    std::int32_t surface = 0;
    std::size_t axis = 0;
    double place = 0.0, velocity = 0.0, acceleration = 0.0;  ///< at its own time
    double time = 0.0;                                       ///< local
    double inverse_mass = 0.0;                               ///< 0: driven
    double change_at = never<double>;  ///< local; a driven one has velocity `then` from then on
    double then = 0.0;
    double changed_at = -never<double>;  ///< when it has, and the velocity before
    double before = 0.0;
    double low = 0.0, high = 0.0;  ///< between these it may move without a new registration
    std::uint32_t changes = 0;     ///< of its velocity

    double place_at(double now) const;
    double velocity_at(double now) const { return velocity + acceleration * (now - time); }

    /// Moves it on to a time.
    void advance(double now);

    /// When it leaves the part of the box where it is registered.
    double registered_until() const;

    /// Carries out its own change, at that time.
    void change();

    /// Makes its own time, to which it has been advanced, the epoch.
    void move_epoch(double shift);

    /// Reverses its motion, at the epoch; what has changed before changes back.
    void reverse();
};

/// The movers of a box, in the order of surfaces. `change_at` is a time on the user's clock.
std::vector<Mover> movers_of(const Box& box);

}  // namespace carom
