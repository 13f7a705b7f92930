// Trajectories that an independent program has calculated with many digits.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "support/slow_simulator.h"
#include "support/sphere_trajectories.h"

using namespace carom;

TEST_CASE("the slow simulator follows trajectories of many digits as far as its own digits reach") {
    int compared = 0;
    for (const test::Trajectory& reference : test::sphere_trajectories()) {
        CAPTURE(reference.name);
        const auto [particles, start] = test::start_of(reference.start);
        test::SlowSimulator slow(reference.box, particles, start);
        long double off = 1e-16L;  // of the doubles of the table; it grows with each collision
        std::int64_t number = 0;
        for (const test::Trajectory::Event& expected : reference.events) {
            if (expected.number != ++number || off > 1e-8L) break;
            CAPTURE(number);
            const test::SlowEvent found = slow.next(reference.end).value();
            REQUIRE(found.first == expected.first);
            REQUIRE(found.second == expected.second);
            const long double now = std::abs(found.time / expected.time - 1.0L);
            REQUIRE(now < 1e4L * off);
            off = std::max(off, now);
            ++compared;
        }
    }
    CHECK(compared > 120);
}
