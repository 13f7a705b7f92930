// Time reversal: a gas whose velocities are reversed returns to its start, to as many digits as its
// numbers have bits for; and doubles do not.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "physics/events/event_loop.h"
#include "physics/placement/placement.h"
#include "support/csv.h"
#include "support/equal_disks.h"
#include "support/small_scenes.h"

using namespace carom;

namespace {

/// A run to a reversal and back, and what was seen.
struct Echo {
    double log10_distance = -1e9;  // of the coordinate farthest from its start, in diameters of 1
    CollisionCounts out, back;
    bool in_reverse_order = true;  // the partners of each particle
};

// The partners of each particle, in order of time.
std::vector<std::vector<Partner>> partners(const std::vector<Collision>& collisions,
                                           std::size_t count) {
    std::vector<std::vector<Partner>> of_each(count);
    for (const Collision& c : collisions) {
        of_each[static_cast<std::size_t>(c.first)].push_back(c.second);
        if (c.second.is_particle())
            of_each[static_cast<std::size_t>(c.second.particle())].emplace_back(c.first);
    }
    return of_each;
}

template <int Dimension, class Scalar>
Echo echo(const Box& box, const Particles& particles, const Sample& start, double out,
          const Arithmetic& arithmetic = {}) {
    EventLoop<Dimension, Scalar> loop(box, particles, arithmetic);
    loop.start(start);
    const std::vector<Scalar> origin = loop.positions(0.0);
    std::vector<Collision> there, back;
    loop.advance(out, &there);
    Echo result;
    result.out = loop.counts();
    loop.reverse(out);
    loop.forget();
    loop.advance(2.0 * out, &back);
    result.back = loop.counts();
    const std::vector<Scalar> end = loop.positions(2.0 * out);
    for (std::size_t k = 0; k < origin.size(); ++k) {
        const auto axis = static_cast<Eigen::Index>(k % Dimension);
        Scalar off = end[k] - origin[k];
        if (box.walls[k % Dimension] == Wall::periodic)
            off = off - box.size[axis] * std::round(static_cast<double>(off) / box.size[axis]);
        if (off != 0.0) result.log10_distance = std::max(result.log10_distance, log10(abs(off)));
    }
    std::reverse(back.begin(), back.end());
    const auto count = static_cast<std::size_t>(particles.count());
    result.in_reverse_order = partners(there, count) == partners(back, count);
    return result;
}

// Bits for a return within 1e-9 (a safe fit for equal disks).
int bits_for(double packing, double collisions_of_each) {
    const double lost = 3.85 * std::log2(1.0 + 0.115 / packing) * collisions_of_each;
    return static_cast<int>(std::ceil(30.0 + 16.0 + lost + 2.0 * std::sqrt(lost)));
}

// Equal disks between walls, off the lattice: one that begins at a wall returns to it, and the
// last bit would decide whether it hits it again.
struct Start {
    Box box;
    Particles particles;
    Sample state;
};
Start between_walls(double packing, int count, std::uint64_t seed) {
    Gas gas = test::equal_disks(packing, count);
    gas.box.walls = {Wall::solid, Wall::solid};
    gas.seed = seed;
    auto [particles, state] = place(gas);
    EventLoop<2> loop(gas.box, particles);
    loop.start(state);
    loop.advance(1.0, nullptr);
    loop.sample(1.0, state);
    state.time = 0.0;
    return {gas.box, particles, state};
}

// The time by which each of the disks has had so many collisions with others.
double time_of_collisions(const Start& gas, double of_each) {
    EventLoop<2> loop(gas.box, gas.particles);
    loop.start(gas.state);
    Collision collision;
    const double wanted = 0.5 * of_each * static_cast<double>(gas.particles.count());
    while (static_cast<double>(loop.counts().particle) < wanted) loop.advance_one(1e9, collision);
    return collision.time;
}

template <class Scalar>
Echo echo(const Start& gas, double out, const Arithmetic& arithmetic = {}) {
    return echo<2, Scalar>(gas.box, gas.particles, gas.state, out, arithmetic);
}

void check_home(const Echo& echo) {
    CHECK(echo.log10_distance < -9.0);
    CHECK(echo.out.particle == echo.back.particle);
    CHECK(echo.out.wall == echo.back.wall);
    CHECK(echo.in_reverse_order);
}

}  // namespace

TEST_CASE("with as many bits as the rule says every gas of equal disks returns") {
    for (const double packing : {0.1, 0.3, 0.5}) {
        for (const double of_each : {10.0, 50.0}) {
            CAPTURE(packing);
            CAPTURE(of_each);
            const Start gas = between_walls(packing, 50, 1);
            const double out = time_of_collisions(gas, of_each);
            const Echo there_and_back = echo<Real>(gas, out, {bits_for(packing, of_each), true});
            CHECK(static_cast<double>(there_and_back.out.particle) > 20.0 * of_each);
            check_home(there_and_back);
        }
    }
}

TEST_CASE("mixtures, all kinds of walls, fixed and moving infinite masses return") {
    std::int64_t collisions = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        CAPTURE(seed);
        const Gas gas = test::small_scene(seed);
        if (test::may_crush(gas)) continue;
        const auto [particles, start] = place(gas);
        const Echo there_and_back = echo<2, Real>(gas.box, particles, start, 6.0, {1024, true});
        collisions += there_and_back.out.particle;
        check_home(there_and_back);
    }
    CHECK(collisions > 300);
}

TEST_CASE("beads of any masses return on a line and on a ring") {
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        CAPTURE(seed);
        const Gas gas = test::small_line(seed);
        const auto [particles, start] = place(gas);
        check_home(echo<1, Real>(gas.box, particles, start, 100.0, {256, true}));
    }
}

TEST_CASE("more bits bring a gas nearer to its start, bit by bit") {
    const Start gas = between_walls(0.3, 50, 7);
    const double out = time_of_collisions(gas, 20.0);
    double before = 0.0;
    for (const int bits : {128, 256, 512, 4096}) {
        const Echo there_and_back = echo<Real>(gas, out, {bits, true});
        if (bits > 128)
            CHECK(before - there_and_back.log10_distance ==
                  doctest::Approx((bits == 4096 ? 3584.0 : bits / 2.0) * std::log10(2.0))
                      .epsilon(0.03));
        before = there_and_back.log10_distance;
    }
    CHECK(before < -1150.0);
}

TEST_CASE("a reversal at the very time of an event, and beside it") {
    const Start gas = between_walls(0.3, 50, 3);
    EventLoop<2, Real> loop(gas.box, gas.particles, {192, true});
    loop.start(gas.state);
    std::vector<Collision> events;
    loop.advance(time_of_collisions(gas, 8.0), &events);
    REQUIRE(events.size() > 200);
    for (std::size_t k = 0; k < 200; ++k) {
        CAPTURE(k);
        const double time = events[k].time;
        for (const double at : {time, std::nextafter(time, 0.0)})
            check_home(echo<Real>(gas, at, {192, true}));
    }
}

TEST_CASE("beads of one mass at exact times: reversed at each of their collisions") {
    // Positions and velocities are whole numbers of eighths, and so are the times of all events.
    const Box box{1, {16.0, 0.0}, {Wall::solid, Wall::solid}};
    constexpr int count = 7;
    Particles beads{Eigen::ArrayXd::Zero(count), Eigen::ArrayXd::Ones(count),
                    Eigen::ArrayXi::Zero(count)};
    Sample start{0.0, Eigen::ArrayXXd(count, 1), Eigen::ArrayXXd(count, 1)};
    start.position.col(0) << 1, 2.5, 4, 6, 9, 10.5, 13;
    start.velocity.col(0) << 1, -1, 1, -1, 1, 1, -1;
    EventLoop<1, Real> loop(box, beads, {64, true});
    loop.start(start);
    std::vector<Collision> events;
    loop.advance(200.0, &events);
    REQUIRE(events.size() >= 200);
    for (const Collision& event : events) {
        CAPTURE(event.time);
        const Echo there_and_back = echo<1, Real>(box, beads, start, event.time, {64, true});
        CHECK(there_and_back.log10_distance == -1e9);  // exactly
        CHECK(there_and_back.out.particle == there_and_back.back.particle);
        CHECK(there_and_back.out.wall == there_and_back.back.wall);
    }
}

TEST_CASE("doubles go astray where the table says") {
    // Of the columns: a distance in diameters, and the collisions of each after which it is passed,
    // the least of several gases and their median.
    struct Threshold {
        double log10_distance;
        std::size_t least, median;
    };
    const std::vector<Threshold> thresholds{{-9.0, 5, 6}, {-3.0, 7, 8}, {std::log10(0.5), 9, 10}};
    int rows = 0;
    for (const auto& row : test::reference_rows("reversal_echo_thresholds.csv")) {
        if (row[0] != "double" || row[3] == "400") continue;
        const double packing = std::stod(row[2]);
        const int count = std::stoi(row[3]);
        CAPTURE(packing);
        CAPTURE(count);
        ++rows;
        for (const Threshold& threshold : thresholds) {
            CAPTURE(threshold.log10_distance);
            int returned = 0, astray = 0;
            for (std::uint64_t seed = 1; seed <= 5; ++seed) {
                const Start gas = between_walls(packing, count, seed);
                const auto is_near = [&](double of_each) {
                    const double out = time_of_collisions(gas, of_each);
                    return echo<double>(gas, out).log10_distance < threshold.log10_distance;
                };
                returned += is_near(0.5 * std::stod(row[threshold.least])) ? 1 : 0;
                astray += is_near(2.0 * std::stod(row[threshold.median])) ? 0 : 1;
            }
            CHECK(returned >= 4);
            CHECK(astray == 5);
        }
    }
    CHECK(rows >= 5);
}
