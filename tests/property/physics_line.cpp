// The event loop in one dimension against the slow, obvious line.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "physics/events/event_loop.h"
#include "physics/placement/placement.h"
#include "support/relative.h"
#include "support/same_events.h"
#include "support/slow_line.h"
#include "support/small_scenes.h"
#include "util/random.h"

using namespace carom;
using test::relative;
using test::small_line;

TEST_CASE("on a line the same events in the same order as the slow, obvious simulator") {
    int compared = 0;
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        CAPTURE(seed);
        const Gas gas = small_line(seed);
        const auto [particles, start] = place(gas);
        compared +=
            test::require_same_events<1, test::SlowLine>(gas.box, particles, start, 1e5, 300);
    }
    CHECK(compared > 20'000);
}

TEST_CASE("beads keep their order, their energy and on a ring their momentum") {
    for (std::uint64_t seed = 1001; seed <= 1100; ++seed) {
        CAPTURE(seed);
        const Gas gas = small_line(seed);
        const auto [particles, start] = place(gas);
        EventLoop<1> beads(gas.box, particles);
        beads.start(start);
        Sample sample;
        Collision collision{};
        const double scale = gas.box.size[0] + speeds(start).sum();
        for (int k = 0; k < 500 && beads.advance_one(1e5, collision); ++k) {
            CAPTURE(k);
            if (collision.second.is_surface()) continue;
            beads.sample(collision.time, sample);
            const double sigma =
                particles.radius[collision.first] + particles.radius[collision.second.particle()];
            // Positions and the time are rounded.
            const double apart =
                std::abs(collision.second_position[0] - collision.first_position[0]);
            REQUIRE(std::abs(apart - sigma) <= 1e-15 * scale);
            double distance = std::abs(sample.position(collision.first, 0) -
                                       sample.position(collision.second.particle(), 0));
            if (gas.box.is_periodic(0)) distance = std::min(distance, gas.box.size[0] - distance);
            REQUIRE(std::abs(distance - sigma) <= 1e-14 * scale * (1.0 + collision.time));
        }
        beads.sample(collision.time, sample);
        CHECK(kinetic_energies(particles, sample).sum() ==
              relative(kinetic_energies(particles, start).sum(), 1e-12));
        if (!gas.box.is_periodic(0) || (particles.inverse_mass == 0.0).any()) continue;
        const Eigen::ArrayXd masses = particles.inverse_mass.inverse();
        const double change = (masses * (sample.velocity - start.velocity).col(0)).sum();
        CHECK(std::abs(change) <= 1e-12 * (masses * speeds(start)).sum());
    }
}

TEST_CASE("beads that touch at the moment of a reversal keep their order") {
    // Two points, listed from right to left, are at one place when they turn round.
    for (const Wall ends : {Wall::solid, Wall::periodic}) {
        const Box box{1, {10.0, 0.0}, {ends, Wall::solid}};
        Particles particles{Eigen::ArrayXd::Zero(3), Eigen::ArrayXd::Zero(3),
                            Eigen::ArrayXi::Zero(3)};
        particles.inverse_mass << 1.0, 0.5, 0.25;
        Sample start{0.0, Eigen::ArrayXXd(3, 1), Eigen::ArrayXXd(3, 1)};
        start.position << 6.0, 4.0, 8.0;
        start.velocity << -1.0, 1.0, 0.0;
        EventLoop<1> beads(box, particles);
        beads.start(start);
        beads.advance(1.0, nullptr);
        CHECK(beads.counts().particle == 1);
        beads.reverse(1.0);
        beads.advance(2.0, nullptr);
        CHECK(beads.counts().particle == 2);
        Sample end;
        beads.sample(2.0, end);
        CHECK((end.position - start.position).abs().maxCoeff() <= 1e-14);
        CHECK((end.velocity + start.velocity).abs().maxCoeff() <= 1e-15);
    }
}

TEST_CASE("two infinite masses that meet are refused") {
    const Box box{1, {10.0, 0.0}, {Wall::solid, Wall::solid}};
    Particles particles{Eigen::ArrayXd::Zero(2), Eigen::ArrayXd::Zero(2), Eigen::ArrayXi::Zero(2)};
    Sample start{0.0, Eigen::ArrayXXd(2, 1), Eigen::ArrayXXd(2, 1)};
    start.position << 2.0, 5.0;
    start.velocity << 1.0, 0.0;
    EventLoop<1> beads(box, particles);
    beads.start(start);
    CHECK_NOTHROW(beads.advance(2.9, nullptr));
    CHECK_THROWS_AS(beads.advance(3.1, nullptr), std::runtime_error);
}
