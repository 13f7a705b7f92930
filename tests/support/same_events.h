// Compares the event loop with a slow, simple reference simulator, event by event.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "physics/box.h"
#include "physics/events/event_loop.h"
#include "physics/particles.h"

namespace carom::test {

/// Requires that the event loop finds the same collisions in the same order as `Slow`, a
/// SlowSimulator or SlowLine, for at most `most` collisions before the time `end`. The round-off of
/// the doubles grows with every collision of a particle (for disks by some 4 to 13 bits), so events
/// are compared only while it is small; a wrong event shows as a jump. Returns the number of
/// collisions compared.
template <int dimension, class Slow, class Scalar = double>
int require_same_events(const Box& box, const Particles& particles, const Sample& start, double end,
                        int most, const Arithmetic& arithmetic = {}) {
    EventLoop<dimension, Scalar> fast(box, particles, arithmetic);
    fast.start(start);
    Slow slow(box, particles, start);
    double deviation = 1e-14;
    int compared = 0;
    while (compared < most && deviation < 1e-9) {
        CAPTURE(compared);
        const auto expected = slow.next(end);
        Collision found{};
        REQUIRE(fast.advance_one(end, found) == expected.has_value());
        if (!expected) break;
        std::int32_t first = found.first;
        std::int32_t second =
            found.second.is_surface() ? -1 - found.second.surface() : found.second.particle();
        if (second >= 0 && second < first) std::swap(first, second);
        REQUIRE(first == expected->first);
        REQUIRE(second == expected->second);
        const double time = static_cast<double>(expected->time);
        const double off = std::abs(found.time - time) / std::max(1.0, time);
        REQUIRE(off <= 1e4 * deviation);
        deviation = std::max(deviation, off);
        ++compared;
    }
    return compared;
}

}  // namespace carom::test
