// Compares the event loop with a slow, simple reference simulator where contacts coincide: instant
// by instant, by the velocities after each.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "physics/box.h"
#include "physics/collision_error.h"
#include "physics/events/event_loop.h"
#include "physics/particles.h"
#include "support/slow_rounds.h"

namespace carom::test {

/// What has been compared.
struct InstantTally {
    int collisions = 0;  ///< ordinary ones
    int instants = 0;    ///< at which contacts coincided
    int contacts = 0;    ///< carried out at these
    int doubtful = 0;    ///< where round-off decides which coincide, so that the comparison ended
    int refused = 0;     ///< by both, because there is no end
};

/// Compares at most `most` instants before the time `end` with `Slow`, a SlowSimulator or SlowLine,
/// which then takes over the state of the event loop. Unconnected contacts at one time may come in
/// any order.
template <int dimension, class Slow, class Loop>
class InstantComparison {
  public:
    InstantComparison(const Box& box, const Particles& particles, const Sample& start,
                      const Arithmetic& arithmetic, InstantTally& tally)
        : box_(box),
          fast_(box, particles, arithmetic),
          slow_(box, particles, start),
          tally_(tally) {
        fast_.start(start);
    }

    void run(double end, int most) {
        for (int k = 0; k < most; ++k) {
            CAPTURE(k);
            try {
                if (!go_on(end)) return;
            } catch (const EndlessRounds&) {
                REQUIRE_THROWS_AS(fast_.advance(end, nullptr), CollisionError);
                ++tally_.refused;
                return;
            }
        }
    }

  private:
    // Through all instants at the time of the next collision.
    bool go_on(double end) {
        Collision found{};
        auto event = slow_.next(end);
        if (!event) {
            REQUIRE(!fast_.advance_one(end, found));
            return false;
        }
        const auto time = static_cast<double>(event->time);
        const double until = time + 1e-12 * std::max(1.0, time);
        int expected = 0;
        for (; event; event = slow_.next(until)) {
            if (event->is_doubtful || ++expected > 10'000) return ++tally_.doubtful, false;
        }
        const Ties before = fast_.counts().ties;
        int carried_out = 0;
        while (fast_.advance_one(until, found)) ++carried_out;
        CAPTURE(time);
        require_same_velocities(until);
        const Ties after = fast_.counts().ties;
        tally_.instants += static_cast<int>(after.instants - before.instants);
        tally_.contacts += static_cast<int>(after.contacts - before.contacts);
        tally_.collisions += carried_out - static_cast<int>(after.contacts - before.contacts);
        slow_.adopt(sample_);
        return true;
    }

    void require_same_velocities(double time) {
        fast_.sample(time, sample_);
        constexpr long double round_off = 1e-7L;  // of a grazing contact: its root
        const double fastest = std::max(1e-300, speeds(sample_).maxCoeff());
        for (Eigen::Index i = 0; i < sample_.velocity.rows(); ++i) {
            CAPTURE(i);
            const auto number = static_cast<std::int32_t>(i);
            for (int axis = 0; axis < dimension; ++axis) {
                const long double expected = slow_.velocity(number)[axis];
                CAPTURE(axis);
                CAPTURE(sample_.velocity(i, axis));
                CAPTURE(static_cast<double>(expected));
                REQUIRE(std::abs(sample_.velocity(i, axis) - expected) < round_off * fastest);
            }
        }
    }

    Box box_;
    Loop fast_;
    Slow slow_;
    Sample sample_;
    InstantTally& tally_;
};

}  // namespace carom::test
