// What holds in every box whose surfaces act.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>

#include "physics/simulation.h"
#include "support/share_of_cases.h"
#include "support/surface_account.h"
#include "support/surface_scenes.h"

using namespace carom;

namespace {

double largest_term(const EnergyAccount& its) {
    return std::max({its.kinetic, std::abs(its.potential), its.pistons, std::abs(its.work),
                     std::abs(its.heat)});
}

}  // namespace

TEST_CASE("the account of energy closes") {
    int whole = 0;
    const int scenes = 400 / test::every_nth(1, 4);
    for (int k = 1; k <= scenes; ++k) {
        const auto seed = static_cast<std::uint64_t>(k);
        CAPTURE(seed);
        const test::SurfaceScene scene =
            seed % 4 == 0 ? test::small_wire(seed) : test::small_box(seed);
        Run run;
        run.events = scene.events;
        try {
            Simulation simulation(scene.gas, run);
            // A piston that is made to move evenly may have had much more energy on the way.
            double largest = 0.0;
            for (int time = 1; time <= 20; ++time) {
                simulation.advance_to(time);
                largest = std::max(largest, largest_term(simulation.energy_account()));
            }
            const EnergyAccount end = simulation.energy_account();
            CHECK(end.relative_error.value() * largest_term(end) < 1e-12 * largest);
            ++whole;
        } catch (const std::exception&) {
            continue;  // no room for the disks, a line that would close on one, a crushed gas
        }
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
