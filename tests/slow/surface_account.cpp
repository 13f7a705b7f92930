// Gases in boxes whose surfaces act, for many events: nothing sinks into a surface, no energy is
// lost, however late the clock.
#include "support/surface_account.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "physics/events/event_loop.h"
#include "physics/placement/placement.h"

using namespace carom;

TEST_CASE("1e8 events beside obstacles, gaps and a piston under gravity") {
    const auto found = test::long_run_of_surfaces(0.0, 100'000'000, 400.0);
    CHECK(found.deepest < 1e-12);
    CHECK(found.error < 1e-10);
}

TEST_CASE("1e6 events when the clock starts at 1e10") {
    const auto found = test::long_run_of_surfaces(1e10, 1'000'000, 100.0);
    CHECK(found.deepest < 1e-12);
    CHECK(found.error < 1e-12);
}
