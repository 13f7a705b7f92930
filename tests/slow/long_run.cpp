// A hundred million collisions: nothing overlaps, nothing is lost, however late the clock.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "physics/events/event_loop.h"
#include "physics/placement/placement.h"
#include "support/equal_disks.h"

using namespace carom;

namespace {

// How deep the deepest pair overlaps, by looking at all of them; in diameters of 1.
double deepest_overlap(const Box& box, const Sample& sample) {
    double nearest = 4.0;  // squared
    for (Eigen::Index i = 0; i < sample.position.rows(); ++i) {
        for (Eigen::Index j = 0; j < i; ++j) {
            double square = 0.0;
            for (int a = 0; a < 2; ++a) {
                const double d = sample.position(i, a) - sample.position(j, a);
                const double nearer = std::remainder(d, box.size[a]);
                square += nearer * nearer;
            }
            nearest = std::min(nearest, square);
        }
    }
    return 1.0 - std::sqrt(nearest);
}

void run_long(double clock) {
    const Gas gas = test::equal_disks(0.6, 1024);
    auto [particles, start] = place(gas);
    start.time = clock;
    EventLoop<2> disks(gas.box, particles);
    disks.start(start);
    const double energy = kinetic_energies(particles, start).sum();
    const double momentum = speeds(start).sum();
    Sample now;
    for (int k = 1; disks.counts().particle < 100'000'000; ++k) {
        const double time = clock + 250.0 * k;
        disks.advance(time, nullptr);
        disks.sample(time, now);
        REQUIRE(deepest_overlap(gas.box, now) < 1e-12);
    }
    CAPTURE(disks.impulses().largest_overlap);
    CHECK(disks.impulses().largest_overlap < 1e-12);
    const double error = kinetic_energies(particles, now).sum() / energy - 1.0;
    CAPTURE(error);
    CHECK(std::abs(error) < 1e-11);
    CHECK(std::abs(now.velocity.col(0).sum()) < 1e-11 * momentum);
    CHECK(std::abs(now.velocity.col(1).sum()) < 1e-11 * momentum);
}

}  // namespace

TEST_CASE("1e8 collisions at packing 0.6") { run_long(0.0); }

TEST_CASE("1e8 collisions at packing 0.6 when the clock starts at 1e10") { run_long(1e10); }
