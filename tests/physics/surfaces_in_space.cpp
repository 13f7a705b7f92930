// Spheres and points among walls that act, in space, against what is known of them. Chance fails
// one comparison of a distribution in a million, and one mean in two million.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "physics/box.h"
#include "physics/events/event_loop.h"
#include "physics/mechanics.h"
#include "physics/multiprecision/multiprecision.h"
#include "physics/particles.h"
#include "support/blocks.h"
#include "support/goodness_of_fit.h"
#include "support/space.h"
#include "util/random.h"

using namespace carom;

namespace {

// Particles of one kind, at random places clear of the walls, with velocities of the temperature 1.
struct Gas {
    Particles particles;
    Sample start;

    Gas(const Box& box, Eigen::Index count, double radius, double mass) {
        Random random(5, "gas");
        particles = {Eigen::ArrayXd::Constant(count, radius),
                     Eigen::ArrayXd::Constant(count, 1.0 / mass), Eigen::ArrayXi::Zero(count)};
        start = {0.0, Eigen::ArrayXXd(count, 3), Eigen::ArrayXXd(count, 3)};
        for (Eigen::Index i = 0; i < count; ++i)
            for (int axis = 0; axis < 3; ++axis) {
                start.position(i, axis) = random.uniform(radius, box.length(axis) - radius);
                start.velocity(i, axis) = random.normal() / std::sqrt(mass);
            }
    }
};

using Loop = EventLoop<3, double, true>;

// The components of a velocity in the frame of a hit: along its normal, and along two directions
// across it, which are turned at random.
Vec in_frame_of(const Collision& hit, double radius, const Vec& v, Random& random) {
    const Vec normal = (hit.first_position - hit.second_position) / radius;
    CHECK(std::abs(length(normal) - 1.0) < 1e-9);
    const Vec any{random.normal(), random.normal(), random.normal()};
    const Vec first = cross(normal, any) / length(cross(normal, any));
    return {dot(v, normal), dot(v, first), dot(v, cross(normal, first))};
}

double below_normal(double x) { return 0.5 * std::erfc(-x / std::numbers::sqrt2); }
double uniform(double share) { return share; }

// A box with a window and a block of which each part is hit.
Box box_with_window(const Behaviour& behaviour) {
    Box box = test::space_of({7.0, 6.0, 5.0});
    for (std::size_t side = 0; side < 6; ++side) box.surfaces.sides[side] = behaviour;
    box.surfaces.partitions = {{.name = "window",
                                .axis = 1,
                                .at = 3.0,
                                .gaps = {{{2.0, 1.0}, {5.0, 3.5}}, {{5.0, 2.0}, {6.0, 5.0}}},
                                .behaviour = behaviour}};
    return box;
}

}  // namespace

TEST_CASE("a sphere leaves faces, edges and corners of a bath with the flux of its temperature") {
    constexpr double radius = 0.6, mass = 2.0, temperature = 1.5;
    Box box = box_with_window(Bath{temperature});
    box.surfaces.seed = 11;
    Gas gas(box, 1, radius, mass);
    put({1.0, 1.0, 1.0}, gas.start.position, 0);
    Loop loop(box, gas.particles, {});
    loop.start(gas.start);
    std::vector<Collision> hits;
    loop.advance(12'000.0, &hits);
    REQUIRE(hits.size() > 7'000);
    Random random(12, "frames");
    std::vector<double> away, first, second;
    int at_rims = 0;
    const double thermal = std::sqrt(temperature / mass);
    for (const Collision& hit : hits) {
        const Vec v = in_frame_of(hit, radius, hit.first_after, random);
        away.push_back(std::exp(-0.5 * v[0] * v[0] / (thermal * thermal)));
        first.push_back(v[1] / thermal);
        second.push_back(v[2] / thermal);
        CHECK(v[0] > 0.0);
        const Vec normal = (hit.first_position - hit.second_position) / radius;
        at_rims +=
            std::abs(normal[0]) < 0.99 && std::abs(normal[1]) < 0.99 && std::abs(normal[2]) < 0.99;
    }
    CHECK(at_rims > 300);
    CHECK(test::chance(away, uniform) > 1e-6);
    CHECK(test::chance(first, below_normal) > 1e-6);
    CHECK(test::chance(second, below_normal) > 1e-6);
    const double most = 5.0 / std::sqrt(static_cast<double>(hits.size()));
    for (const auto* values : {&away, &first, &second})
        CHECK(std::abs(test::correlation_with_next(*values)) < most);
    double product = 0.0;
    for (std::size_t k = 0; k < first.size(); ++k)
        product += first[k] * second[k] / static_cast<double>(first.size());
    CHECK(std::abs(product) < most);
}

TEST_CASE("a bath draws the velocity along the normal first, then those along the other axes") {
    Box box = test::space_of({4.0, 4.0, 4.0});
    box.surfaces.seed = 21;
    for (std::size_t side = 0; side < 6; ++side) box.surfaces.sides[side] = Bath{2.0};
    for (const std::int32_t side : {0, 1, 2, 3, 4, 5}) {
        const std::size_t axis = static_cast<std::size_t>(side / 2);
        const bool is_far = side % 2 == 1;
        Gas gas(box, 1, 0.5, 0.5);
        put({2.0, 2.0, 2.0}, gas.start.position, 0);
        Vec v;
        v[axis] = is_far ? 1.0 : -1.0;
        put(v, gas.start.velocity, 0);
        Loop loop(box, gas.particles, {});
        loop.start(gas.start);
        Collision hit;
        REQUIRE(loop.advance_one(10.0, hit));
        Random random(21, "hit 1 of surface " + std::to_string(side));
        const double away = 2.0 * std::sqrt(-2.0 * std::log1p(-random.uniform()));
        for (std::size_t k = 0; k < 3; ++k) {
            const double expected = k == axis ? (is_far ? -away : away) : 2.0 * random.normal();
            CHECK(hit.first_after[k] == expected);
        }
    }
}

TEST_CASE("a sphere leaves diffuse walls at its own speed, with an even spread of its shadow") {
    constexpr double radius = 0.6;
    Box box = box_with_window(Diffuse{});
    Gas gas(box, 1, radius, 1.0);
    put({1.0, 1.0, 1.0}, gas.start.position, 0);
    const double speed = length(vec_in(gas.start.velocity, 0));
    Loop loop(box, gas.particles, {});
    loop.start(gas.start);
    std::vector<Collision> hits;
    loop.advance(20'000.0 / speed, &hits);
    REQUIRE(hits.size() > 8'000);
    Random random(12, "frames");
    std::vector<double> squares, shares;
    for (const Collision& hit : hits) {
        CHECK(std::abs(length(hit.first_after) - speed) < 1e-12 * speed);
        const Vec v = in_frame_of(hit, radius, hit.first_after / speed, random);
        CHECK(v[0] > 0.0);
        // The density 2 sin cos of the angle makes the square of the sine uniform.
        squares.push_back(1.0 - v[0] * v[0]);
        shares.push_back(0.5 + std::atan2(v[1], v[2]) / (2.0 * std::numbers::pi));
    }
    CHECK(test::chance(squares, uniform) > 1e-6);
    CHECK(test::chance(shares, uniform) > 1e-6);
    const double most = 5.0 / std::sqrt(static_cast<double>(hits.size()));
    CHECK(std::abs(test::correlation_with_next(squares)) < most);
    // Without frames turned at random: no direction along a wall is preferred.
    std::vector<double> along;
    for (const Collision& hit : hits)
        if (hit.second.surface() == 2)
            along.push_back(0.5 + std::atan2(hit.first_after[0], hit.first_after[2]) /
                                      (2.0 * std::numbers::pi));
    REQUIRE(along.size() > 800);
    CHECK(test::chance(along, uniform) > 1e-6);
}

TEST_CASE("in many bits a diffuse wall in space keeps the speed in all of them") {
    const Box box = box_with_window(Diffuse{});
    Gas gas(box, 1, 0.6, 1.0);
    put({1.0, 1.0, 1.0}, gas.start.position, 0);
    put({0.5, 0.25, 1.0}, gas.start.velocity, 0);
    EventLoop<3, Real, true> loop(box, gas.particles, {.bits = 200});
    loop.start(gas.start);
    loop.advance(300.0, nullptr);
    CHECK(loop.counts().wall > 100);
    // From here to there and back again: positions differ by the speed times the time.
    const double before = 300.0, after = before + 1e-9;
    const auto a = loop.positions(before), b = loop.positions(after);
    Real square(0.0, 200);
    for (std::size_t k = 0; k < 3; ++k) square += (b[k] - a[k]) * (b[k] - a[k]);
    const Real step = Real(after, 200) - before;
    const Real wrong = square / (step * step) - Real(1.3125, 200);
    CHECK(std::abs(static_cast<double>(wrong)) < 1e-45);  // 2^-200 is 6e-61, over 3e-12
}

// The mean chord of a convex body is 4 V / S (Cauchy), and the cosine law keeps the even spread.
TEST_CASE("between diffuse walls a sphere flies 4 V / S on average") {
    constexpr double radius = 0.5;
    Box box = test::space_of({5.0, 4.0, 3.0});
    for (std::size_t side = 0; side < 6; ++side) box.surfaces.sides[side] = Diffuse{};
    Gas gas(box, 1, radius, 1.0);
    const double speed = length(vec_in(gas.start.velocity, 0));
    Loop loop(box, gas.particles, {});
    loop.start(gas.start);
    std::vector<double> means;
    std::vector<Collision> hits;
    double last = 0.0;
    constexpr std::size_t in_block = 1000;
    for (double time = 1000.0; means.size() < 40; time += 1000.0) {
        loop.advance(time, &hits);
        while (hits.size() >= in_block) {
            means.push_back((hits[in_block - 1].time - last) * speed / in_block);
            last = hits[in_block - 1].time;
            hits.erase(hits.begin(), hits.begin() + in_block);
        }
    }
    const double volume = 4.0 * 3.0 * 2.0, surface = 2.0 * (4.0 * 3.0 + 3.0 * 2.0 + 2.0 * 4.0);
    test::check_mean(means, 4.0 * volume / surface, 0.01);
}

// At rest walls would keep the energy along each axis apart; diffuse ones mix it. To the first
// order in the speed u of the wall the work exceeds that of a slow stroke by 2 sqrt(8 / pi) u /
// sqrt(T/m) of itself: that of a flux through a moving surface.
TEST_CASE("a slow stroke keeps T V^(2/3)") {
    constexpr double u = 0.002, until = 2500.0;
    constexpr int count = 200;
    for (const double direction : {-1.0, 1.0}) {
        Box box = test::space_of({10.0, 3.0, 3.0});
        box.surfaces.sides[0] = Diffuse{};
        box.surfaces.sides[1] = Driven{direction * u};
        const Gas gas(box, count, 0.0, 1.0);
        Loop loop(box, gas.particles, {});
        loop.start(gas.start);
        const double before = kinetic_energies(gas.particles, gas.start).sum();
        loop.advance(until, nullptr);
        Sample now;
        loop.sample(until, now);
        const double after = kinetic_energies(gas.particles, now).sum();
        const double stretch = 1.0 + direction * u * until / 10.0;
        CHECK(loop.driven_work() == doctest::Approx(after - before).epsilon(1e-9));
        // Scatter: 100 hits of each of 200 points, with their Poisson noise, make up 0.46 of ln T.
        const double ratio = after / before * std::pow(stretch, 2.0 / 3.0);
        CHECK(std::abs(ratio - 1.0) < 0.01);
        CHECK(std::abs(after / before - 1.0) > 0.2);
    }
}

// Positions h of a piston over N points of the energy E in all, whose 3 N + 1 squares of momenta
// share E - F h: p(h) ~ h^N (E - F h)^((3 N - 1) / 2).
TEST_CASE("a piston over points in space has the mean height E (N + 1) / (F (5 N / 2 + 3 / 2))") {
    constexpr int count = 3;
    constexpr double force = 1.0, mass = 2.0;
    Box box = test::space_of({2.0, 2.0, 100.0});
    box.surfaces.sides[4] = Diffuse{};  // mixes the energies along the axes
    box.surfaces.sides[5] = Piston{.mass = mass, .force = -force, .velocity = 0.0};
    Gas gas(box, count, 0.0, 1.0);
    for (int i = 0; i < count; ++i) put({1.0, 0.5 + 0.25 * i, 1.0}, gas.start.position, i);
    gas.start.velocity *= 0.0;
    for (int i = 0; i < count; ++i) put({1.0, -2.0 + i, 3.0}, gas.start.velocity, i);
    Loop loop(box, gas.particles, {});
    loop.start(gas.start);
    const double energy = kinetic_energies(gas.particles, gas.start).sum() + force * 100.0;
    std::vector<double> heights, shares;
    double time = 1000.0;
    loop.advance(time, nullptr);
    for (int block = 0; block < 40; ++block) {
        double height = 0.0, share = 0.0;
        constexpr int samples = 400;
        for (int k = 0; k < samples; ++k) {
            loop.advance(time += 11.0, nullptr);
            const auto motion = *loop.surfaces(time)[5].motion;
            height += motion.place / samples;
            share += 0.5 * mass * motion.velocity * motion.velocity / samples;
        }
        heights.push_back(height);
        shares.push_back(share);
    }
    const double mean = energy / force * (count + 1.0) / (2.5 * count + 1.5);
    test::check_mean(heights, mean, 0.03);
    test::check_mean(shares, (energy - force * mean) / (3.0 * count + 1.0), 0.05);
}

TEST_CASE("through a gap in space effuse n a sqrt(T / 2 pi m), of energy 2 T, by the cosine law") {
    constexpr double temperature = 1.0, mass = 2.0, width = 1.0, height = 1.5;
    constexpr int count = 40;
    const Vec size{6.0, 5.0, 4.0};
    Box box = test::space_of({size[0] + 1.0, size[1], size[2]});
    box.surfaces.sides[0] = Bath{temperature};
    // What comes through is counted by a bath just behind, which sends back what is alike.
    box.surfaces.partitions = {
        {.name = "gap",
         .axis = 0,
         .at = size[0],
         .gaps = {{{2.0, 1.0}, {2.0 + width, 1.0 + height}}}},
        {.name = "counter", .axis = 0, .at = size[0] + 1e-6, .behaviour = Bath{temperature}}};
    Gas gas(test::space_of(size), count, 0.0, mass);
    Loop loop(box, gas.particles, {});
    loop.start(gas.start);
    std::vector<double> rates, energies, squares;
    for (int block = 1; block <= 40; ++block) {
        constexpr double time = 300.0;
        std::vector<Collision> hits;
        loop.advance(time * block, &hits);
        double energy = 0.0, through = 0.0;
        for (const Collision& hit : hits) {
            if (hit.second.surface() != box.surfaces.first_partition() + 1) continue;
            const Vec& v = hit.first_before;
            energy += 0.5 * mass * square(v);
            squares.push_back(1.0 - v[0] * v[0] / square(v));
            through += 1.0;
        }
        rates.push_back(through / time);
        energies.push_back(energy / through);
    }
    const double density = count / (size[0] * size[1] * size[2]);
    test::check_mean(
        rates, density * width * height * std::sqrt(temperature / (2.0 * std::numbers::pi * mass)),
        0.03);
    test::check_mean(energies, 2.0 * temperature, 0.03);
    CHECK(test::chance(squares, uniform) > 1e-6);
}
