// The slow simulator of beads itself, against what is known without one.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "support/slow_line.h"
#include "util/random.h"

using namespace carom;
using carom::test::SlowEvent;
using carom::test::SlowLine;

namespace {

constexpr long double ever = std::numeric_limits<long double>::max();

struct Start {
    Particles particles;
    Sample sample;
};

Start beads(const std::vector<double>& x, const std::vector<double>& v,
            const std::vector<double>& mass, double radius) {
    const auto count = static_cast<Eigen::Index>(x.size());
    const auto column = [&](const std::vector<double>& values) {
        return Eigen::ArrayXd(Eigen::Map<const Eigen::ArrayXd>(values.data(), count));
    };
    return {{Eigen::ArrayXd::Constant(count, radius), column(mass).inverse(),
             Eigen::ArrayXi::Zero(count)},
            {0.0, column(x), column(v)}};
}

Box line(double length, Wall ends) { return {1, {length, 0.0}, {ends, Wall::solid}}; }

int collisions(SlowLine& simulator, long double end) {
    int count = 0;
    while (count < 10'000 && simulator.next(end)) ++count;
    return count;
}

}  // namespace

TEST_CASE("a wall, a light bead at rest and a heavy one count the digits of pi") {
    // Galperin (2003), Playing pool with pi. The line is so long that its other end is not reached.
    int digits[] = {3, 31, 314, 3141};
    for (int n = 0; n < 4; ++n) {
        const Start start =
            beads({1.0, 2.0}, {0.0, -1.0}, {1.0, std::pow(100.0, n)}, n % 2 == 0 ? 0.0 : 0.25);
        SlowLine simulator(line(1e9, Wall::solid), start.particles, start.sample);
        CHECK(collisions(simulator, 1e6L) == digits[n]);
    }
}

TEST_CASE("equal beads hand on their velocities: points fly freely, and are renumbered") {
    Random random(7, "equal beads");
    std::vector<double> x, v;
    for (int i = 0; i < 9; ++i) {
        x.push_back(random.uniform(0.0, 10.0));
        v.push_back(random.normal());
    }
    const Start start = beads(x, v, std::vector<double>(9, 2.0), 0.0);
    SlowLine simulator(line(10.0, Wall::solid), start.particles, start.sample);
    for (int k = 0; k < 500; ++k) {
        const SlowEvent event = *simulator.next(ever);
        std::vector<long double> flown, found;
        for (std::size_t i = 0; i < x.size(); ++i) {
            // Free flight between walls, unfolded: a triangle wave of period 2 L.
            const long double place = std::fmod(x[i] + v[i] * event.time, 20.0L);
            const long double wrapped = place < 0.0L ? place + 20.0L : place;
            flown.push_back(wrapped > 10.0L ? 20.0L - wrapped : wrapped);
            found.push_back(simulator.x(static_cast<std::int32_t>(i)));
        }
        std::sort(flown.begin(), flown.end());
        std::sort(found.begin(), found.end());
        for (std::size_t i = 0; i < flown.size(); ++i)
            REQUIRE(std::abs(flown[i] - found[i]) < 1e-14L);
    }
}

TEST_CASE("rods on a ring keep their order, energy and momentum") {
    const Start start =
        beads({0.5, 9.0, 3.0, 6.0}, {1.0, -0.3, 0.2, -2.0}, {1.0, 3.0, 0.1, 20.0}, 0.4);
    SlowLine simulator(line(10.0, Wall::periodic), start.particles, start.sample);
    const auto sum = [&](int power) {
        long double total = 0.0L;
        for (int i = 0; i < 4; ++i)
            total += std::pow(simulator.velocity(i).x, power) / start.particles.inverse_mass[i];
        return total;
    };
    const long double momentum = sum(1), energy = sum(2);
    for (int k = 0; k < 2000; ++k) {
        const SlowEvent event = *simulator.next(ever);
        REQUIRE(event.first < event.second);
        const int ring[] = {0, 2, 3, 1};
        for (int rank = 0; rank < 4; ++rank) {
            const long double apart = simulator.x(ring[(rank + 1) % 4]) - simulator.x(ring[rank]);
            REQUIRE((apart < 0.0L ? apart + 10.0L : apart) > 0.8L - 1e-15L);
        }
    }
    CHECK(std::abs(sum(1) - momentum) < 1e-14L * 45.0L);
    CHECK(std::abs(sum(2) / energy - 1.0L) < 1e-15L);
}

TEST_CASE("nothing happens at rest, alone on a ring, or between beads that part") {
    const Start rest = beads({1.0, 2.0}, {0.0, 0.0}, {1.0, 1.0}, 0.5);
    CHECK(!SlowLine(line(3.0, Wall::solid), rest.particles, rest.sample).next(ever));
    const Start alone = beads({1.0}, {2.0}, {1.0}, 0.5);
    CHECK(!SlowLine(line(3.0, Wall::periodic), alone.particles, alone.sample).next(ever));
    SlowLine bounces(line(3.0, Wall::solid), alone.particles, alone.sample);
    const SlowEvent right = *bounces.next(ever), left = *bounces.next(ever);
    CHECK(right.second == -2);
    CHECK(right.time == 0.75L);
    CHECK(left.second == -1);
    CHECK(left.time == 1.75L);
}
