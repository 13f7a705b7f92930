// Boxes whose surfaces act against the slow, obvious simulator: more scenes.
#include <doctest/doctest.h>

#include <cstdint>

#include "support/same_surface_events.h"
#include "support/surface_scenes.h"

using namespace carom;

TEST_CASE("more scenes go as the slow, obvious simulator says") {
    test::SurfaceTally tally;
    for (std::uint64_t seed = 10'001; seed <= 50'000; ++seed) {
        CAPTURE(seed);
        test::require_same_surface_events<2>(test::small_box(seed), seed, tally, 150);
    }
    for (std::uint64_t seed = 10'001; seed <= 40'000; ++seed) {
        CAPTURE(seed);
        test::require_same_surface_events<1>(test::small_wire(seed), seed, tally, 80);
    }
    CHECK(tally.hits > 200'000);
}
