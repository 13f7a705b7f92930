// Cases in which round-off decides: grazing, touching, very slow and very fast.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "support/bodies.h"
#include "support/relative.h"
#include "util/random.h"

using namespace carom;
using test::simulation_of;

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

}  // namespace

TEST_CASE("whether a disk grazes another a thousand diameters away is told to 1 in 1e13") {
    for (const Wall walls : {Wall::solid, Wall::periodic}) {
        for (const double missing : {0x1p-38, 0x1p-43}) {
            CAPTURE(missing);
            const Box box{2, {2048.0, 8.0}, {walls, walls}};
            for (const double offset : {1.0 - missing, 1.0 + missing}) {
                Simulation pair =
                    simulation_of(box, {{1.5, 3.0, 1.0, 0.0}, {1025.5, 3.0 + offset, 0.0, 0.0}});
                const AdvanceResult advanced = pair.advance_to(1025.0);
                REQUIRE(advanced.counts.particle == (offset < 1.0 ? 1 : 0));
                if (offset > 1.0) continue;
                // The struck disk leaves along the line of centres with this part of the speed.
                const double along = std::sqrt((1.0 - offset) * (1.0 + offset));
                // The place of the contact is rounded at coordinates of 1024.
                const double error = 1024.0 * epsilon / along;
                CHECK(pair.sample().velocity(1, 1) == test::relative(along * offset, 4.0 * error));
                CHECK(pair.sample().velocity(1, 0) == test::relative(along * along, 8.0 * error));
            }
        }
    }
}

TEST_CASE("the same along a slope, where coordinates and products are rounded") {
    // Radii 2.5, so that the offset (-4, 3) and the velocity (3, 4) are exact.
    for (const double missing : {0x1p-30, 0x1p-36}) {
        for (const double offset : {1.0 - missing, 1.0 + missing}) {
            CAPTURE(offset);
            Simulation pair = simulation_of(
                Box{2, {4096.0, 4096.0}, {}},
                {{64.0, 64.0, 3.0, 4.0, 2.5},
                 {64.0 + 2400.0 - 4.0 * offset, 64.0 + 3200.0 + 3.0 * offset, 0.0, 0.0, 2.5}});
            CHECK(pair.advance_to(801.0).counts.particle == (offset < 1.0 ? 1 : 0));
        }
    }
}

TEST_CASE("disks that nearly touch meet after gap over approach, those that touch at once") {
    for (const double gap : {0.0, 0x1p-49, 0x1p-40, 0x1p-20}) {
        for (const double approach : {1e-12, 1.0, 1e6}) {
            CAPTURE(gap);
            CAPTURE(approach);
            Simulation pair = simulation_of(
                Box{2, {16.0, 16.0}, {}}, {{4.5, 3.0, 0.0, 0.0}, {5.5 + gap, 3.0, -approach, 0.0}});
            pair.record_collisions(true);
            const AdvanceResult advanced = pair.advance_to(2.0 * gap / approach + 1.0 / approach);
            REQUIRE(advanced.collisions.size() == 1);
            const double wait = gap / approach;
            CHECK(std::abs(advanced.collisions[0].time - wait) <= 4.0 * epsilon * wait);
            CHECK(pair.sample().velocity(0, 0) == -approach);
            CHECK(pair.sample().velocity(1, 0) == 0.0);
        }
    }
}

TEST_CASE("two disks that slide past each other in touch collide once at most, and go on") {
    Random random(2, "sliding");
    int collided = 0;
    constexpr int pairs = 20'000;
    for (int i = 0; i < pairs; ++i) {
        CAPTURE(i);
        const double angle = random.uniform(0.0, 2.0 * std::numbers::pi);
        const double nx = std::cos(angle), ny = std::sin(angle);
        // Across the line of centres, but for round-off or a little more; and drifting together.
        const double into = std::exp(random.uniform(-45.0, -20.0)) * (i % 3 - 1);
        const double vx = random.uniform(-1.0, 1.0), vy = random.uniform(-1.0, 1.0);
        const double mass = std::exp(random.uniform(-10.0, 10.0));
        Simulation pair = simulation_of(
            Box{2, {20.0, 20.0}, {}},
            {{10.0, 10.0, vx, vy},
             {10.0 + nx, 10.0 + ny, vx - ny - into * nx, vy + nx - into * ny, 0.5, 1.0 / mass}});
        const double before = kinetic_energies(pair.particles(), pair.sample()).sum();
        const AdvanceResult advanced = pair.advance_to(2.0);
        REQUIRE(advanced.counts.particle <= 1);
        collided += static_cast<int>(advanced.counts.particle);
        CHECK(kinetic_energies(pair.particles(), pair.sample()).sum() ==
              test::relative(before, 8.0 * epsilon));
        // Without a collision worth the name they part at the relative speed 1.
        const Eigen::ArrayXXd& x = pair.sample().position;
        CHECK(std::hypot(x(1, 0) - x(0, 0), x(1, 1) - x(0, 1)) ==
              test::relative(std::sqrt(5.0), 1e-7));
    }
    CHECK(collided > pairs / 10);
    CHECK(collided < pairs);
}

TEST_CASE("a disk at 1e-12 beside one at 1e6, each as if it were alone, until they meet") {
    const double slow = 1e-12, fast = 1e6, time = 0.1;
    Simulation apart =
        simulation_of(Box{2, {16.0, 16.0}, {}}, {{5.0, 4.0, slow, -slow}, {3.0, 9.0, fast, 0.0}});
    const AdvanceResult advanced = apart.advance_to(time);
    const double way = 3.0 - 0.5 + fast * time;  // from the left wall, unfolded
    CHECK(advanced.counts.wall == static_cast<std::int64_t>(way / 15.0));
    const Eigen::ArrayXXd& x = apart.sample().position;
    CHECK(std::abs(x(0, 0) - (5.0 + slow * time)) <= 8.0 * epsilon);
    CHECK(std::abs(x(0, 1) - (4.0 - slow * time)) <= 8.0 * epsilon);
    const double turn = std::fmod(way, 30.0), place = 0.5 + (turn < 15.0 ? turn : 30.0 - turn);
    // Each bounce rounds the time, which counts 1e6 times, and a coordinate.
    const double bounces = static_cast<double>(advanced.counts.wall);
    CHECK(std::abs(x(1, 0) - place) <= bounces * epsilon * (16.0 + fast * time));

    Simulation meeting =
        simulation_of(Box{2, {16.0, 16.0}, {}}, {{5.0, 4.0, slow, 0.0}, {9.0, 4.0, -fast, 0.0}});
    CHECK(meeting.advance_to(3.1e-6).counts.particle == 1);
    CHECK(std::abs(meeting.sample().velocity(0, 0) + fast) <= epsilon * fast);
    CHECK(std::abs(meeting.sample().velocity(1, 0) - slow) <= epsilon * fast);
}

TEST_CASE("a disk of 1e15 times the mass is a wall, and pays for it") {
    for (const double heavy : {1e3, 1e9, 1e15}) {
        CAPTURE(heavy);
        Simulation pair =
            simulation_of(Box{2, {16.0, 16.0}, {}},
                          {{4.0, 4.0, 1.0, 0.0}, {8.0, 4.6, 0.0, 0.0, 0.5, 1.0 / heavy}});
        CHECK(pair.advance_to(4.5).counts.particle == 1);
        // n: the line of centres at contact, 0.8 along and 0.6 across; it gets 2 m/(m + M) of n . v
        const double part = 2.0 * 0.8 / (1.0 + heavy);
        const Eigen::ArrayXXd& v = pair.sample().velocity;
        CHECK(v(1, 0) == test::relative(part * 0.8, 8.0 * epsilon));
        CHECK(v(1, 1) == test::relative(part * 0.6, 8.0 * epsilon));
        CHECK(std::abs(v(0, 0) - (1.0 - heavy * part * 0.8)) <= 8.0 * epsilon);
        CHECK(std::abs(v(0, 1) + heavy * part * 0.6) <= 8.0 * epsilon);
    }
}
