// The position of a surface that moves, or may be set in motion, along its normal.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "physics/collision/pair_collision.h"
#include "physics/surfaces/barrier_contact.h"

namespace carom {

template <typename Scalar>
struct Mover {
    bool is_mobile = false;  ///< whether it has ever moved
    std::size_t axis = 0;
    Scalar place = 0.0, velocity = 0.0;  ///< at its own time
    Scalar acceleration = 0.0;
    Scalar time = 0.0;             ///< local
    double inverse_mass = 0.0;     ///< 0: its motion is not changed by collisions
    Scalar low = 0.0, high = 0.0;  ///< range in which it may move without a new registration
    std::uint32_t changes = 0;     ///< number of changes of its motion

    Scalar place_at(const Scalar& now) const {
        const Scalar t = now - time;
        return place + t * (velocity + 0.5 * t * acceleration);
    }
    Scalar velocity_at(const Scalar& now) const { return velocity + acceleration * (now - time); }

    /// Advances it to a time.
    void advance(const Scalar& now) {
        place = place_at(now);
        velocity = velocity_at(now);
        time = now;
    }

    template <class Archive>
    void archive(Archive& archive) {
        archive(is_mobile, axis, place, velocity, acceleration, time, inverse_mass, low, high,
                changes);
    }

    /// The time at which it leaves the range for which it is registered.
    Scalar registered_until() const {
        return time + std::min(fall_time<Scalar>(place - low, velocity, acceleration),
                               fall_time<Scalar>(high - place, -velocity, -acceleration));
    }
};

}  // namespace carom
