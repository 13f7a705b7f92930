// Contacts that coincide, against the slow, obvious simulators.
#include <doctest/doctest.h>

#include <cstdint>

#include "physics/events/event_loop.h"
#include "support/same_instants.h"
#include "support/slow_line.h"
#include "support/slow_simulator.h"
#include "support/tied_scenes.h"
#include "util/random.h"

using namespace carom;
using test::InstantComparison;
using test::InstantTally;

namespace {

template <class Loop>
void compare_disks(const test::TiedScene& scene, int bits, InstantTally& tally) {
    InstantComparison<2, test::SlowSimulator, Loop>(scene.box, scene.particles, scene.start,
                                                    {.bits = bits}, tally)
        .run(100.0, 20);
}

template <class Loop>
void compare_beads(const test::TiedScene& scene, int bits, InstantTally& tally) {
    InstantComparison<1, test::SlowLine, Loop>(scene.box, scene.particles, scene.start,
                                               {.bits = bits}, tally)
        .run(100.0, 20);
}

test::TiedScene tied_beads(std::uint64_t seed) {
    Random random(seed, "beads that meet at once");
    return test::tied_wire(random);
}

}  // namespace

TEST_CASE("disks that meet at once do what the slow, obvious simulator says") {
    InstantTally tally;
    for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
        CAPTURE(seed);
        const test::TiedScene scene = test::tied_scene(seed);
        compare_disks<EventLoop<2>>(scene, bits_of_double, tally);
        compare_disks<EventLoop<2, double, true>>(scene, bits_of_double, tally);
    }
    CHECK(tally.instants > 3'000);
    CHECK(tally.contacts > 10'000);
    CHECK(tally.doubtful < 100);
}

TEST_CASE("beads that meet at once do what the slow, obvious simulator says") {
    InstantTally tally;
    for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
        CAPTURE(seed);
        const test::TiedScene scene = tied_beads(seed);
        compare_beads<EventLoop<1>>(scene, bits_of_double, tally);
        compare_beads<EventLoop<1, double, true>>(scene, bits_of_double, tally);
    }
    CHECK(tally.instants > 3'000);
    CHECK(tally.contacts > 10'000);
    CHECK(tally.doubtful < 100);
}
