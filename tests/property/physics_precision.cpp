// The event loop with numbers of many bits against the slow, obvious simulators.
#include <doctest/doctest.h>

#include <cstdint>

#include "physics/events/event_loop.h"
#include "physics/placement/placement.h"
#include "support/same_events.h"
#include "support/slow_line.h"
#include "support/slow_simulator.h"
#include "support/small_scenes.h"

using namespace carom;

TEST_CASE("with many bits the same events in the same order as the slow, obvious simulators") {
    int disks = 0, beads = 0;
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        CAPTURE(seed);
        const Arithmetic arithmetic{64 << (seed % 4), true};
        {
            const Gas gas = test::small_scene(seed);
            const auto [particles, start] = place(gas);
            disks += test::require_same_events<2, test::SlowSimulator, Real>(
                gas.box, particles, start, 1e5, 300, arithmetic);
        }
        const Gas gas = test::small_line(seed);
        const auto [particles, start] = place(gas);
        beads += test::require_same_events<1, test::SlowLine, Real>(gas.box, particles, start, 1e5,
                                                                    100, arithmetic);
    }
    CHECK(disks > 1000);
    CHECK(beads > 3000);
}
