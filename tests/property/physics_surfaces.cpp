// What holds in every box whose surfaces act.
#include <doctest/doctest.h>

#include <cstdint>

#include "support/share_of_cases.h"
#include "support/surface_account.h"
#include "support/surface_scenes.h"

using namespace carom;

TEST_CASE("the account of energy closes") {
    int whole = 0;
    const int scenes = 400 / test::every_nth(1, 4);
    for (int k = 1; k <= scenes; ++k) {
        const auto seed = static_cast<std::uint64_t>(k);
        CAPTURE(seed);
        const test::SurfaceScene scene =
            seed % 4 == 0 ? test::small_wire(seed) : test::small_box(seed);
        whole += test::check_account(scene) ? 1 : 0;
    }
    CHECK(whole > scenes * 5 / 8);
}

TEST_CASE("no disk sinks into a surface and no energy is lost, however late the clock") {
    for (const double clock : {0.0, 1e10}) {
        CAPTURE(clock);
        const auto found = test::long_run_of_surfaces(clock, 200'000, 50.0);
        CHECK(found.deepest < 1e-12);
        CHECK(found.error < 1e-12);
    }
}
