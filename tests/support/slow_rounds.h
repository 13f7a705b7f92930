// What contacts at one instant do to velocities, by the plainest means: each contact is a vector
// in the space of all velocities, scaled by the roots of the masses, where a collision is the
// reflection in the plane orthogonal to it, and several at once are that in the space orthogonal
// to all of them, found by the Gram-Schmidt process. In long double.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

#include "support/slow_numbers.h"

namespace carom::test {

/// How far apart two bodies that are in contact may be because of the round-off of doubles: the
/// distance that one moves relative to the other in 4 epsilon (|t| + length / |speed|).
inline long double distance_of_round_off(long double time, long double speed, long double length) {
    return 4.0L * std::numeric_limits<double>::epsilon() * (std::abs(time * speed) + length);
}

/// A particle or a surface. `inverse_mass`: along each axis, 0 if it is not pushed along it.
struct SlowParticipant {
    SlowVector v, inverse_mass;

    bool can_be_pushed() const { return largest(inverse_mass) > 0.0L; }
};

/// Two participants, and the direction of length 1 from the first to the second.
struct SlowTouch {
    std::size_t first, second;
    SlowVector normal;
    /// Distance from each other, which counts as none if it is not larger than `tolerance`.
    long double gap = 0.0L, tolerance = 0.0L;

    bool is_closed() const { return std::abs(gap) <= tolerance; }
    /// Whether round-off decides about that.
    bool is_doubtful() const {
        return std::abs(gap) > 0.25L * tolerance && std::abs(gap) < 16.0L * tolerance;
    }
};

/// The touches, of those that are closed, that are connected with a participant by others and by
/// participants that can be pushed.
std::vector<SlowTouch> connected_with(std::size_t participant,
                                      const std::vector<SlowTouch>& touches,
                                      const std::vector<SlowParticipant>& participants);

/// Thrown if there is no end of rounds.
struct EndlessRounds : std::runtime_error {
    EndlessRounds() : std::runtime_error("rounds without end") {}
};

/// Carries out rounds until no contact approaches, at most a thousand. Returns the number of
/// collisions. If one contact approaches and all others recede, which then have just been carried
/// out, only this one is carried out.
int carry_out_rounds(std::vector<SlowParticipant>& participants,
                     const std::vector<SlowTouch>& touches);

}  // namespace carom::test
