// The velocities, collisions and paths of hard spheres in space, against published numbers, exact
// integrals, independent counts and runs of a slow simulator.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "physics/gas.h"
#include "physics/theory/barometric_law.h"
#include "physics/theory/billiard.h"
#include "physics/theory/collision_rate.h"
#include "physics/theory/law.h"
#include "physics/theory/laws/symmetry.h"
#include "physics/theory/piston_law.h"
#include "support/csv.h"
#include "support/gas_states.h"
#include "support/relative.h"
#include "support/space.h"
#include "support/spheres.h"
#include "util/random.h"

using namespace carom;
using std::numbers::pi;
using test::cube_of;
using test::GasState;
using test::NearPlaces;
using test::relative;
using test::spheres_of;
using test::state_named;
using test::summed;

TEST_CASE("spheres collide at Enskog's rate, two of them at an exact one") {
    // 4 n d^2 chi sqrt(pi T / m) for each, less one of N, with the factor of finite numbers.
    const GasState s = state_named("space-fluid");
    const double t = s.value_of(LawOf::temperature), density = 2.653, d = 0.6,
                 eta = density * pi * d * d * d / 6.0;
    const double chi = (1.0 - 0.5 * eta) / std::pow(1.0 - eta, 3);
    CHECK(packing_fraction(s.gas.box, s.particles) == relative(eta, 1e-6));
    const double enskog = 4.0 * density * d * d * chi * std::sqrt(pi * t);
    CHECK(s.value_of(LawOf::collision_rate) ==
          relative(enskog * 2652.0 / 2653.0 * (1.0 + 0.25 / (3.0 * 2652.0)), 2e-6));
    // The mean free path of a dilute gas is V / (sqrt 2 pi N d^2).
    CHECK(s.value_of(LawOf::mean_free_path) ==
          relative(dilute_free_path(1000.0, cross_sections(s.particles.radius, 3)) / chi, 5e-4));
    CHECK(dilute_free_path(1000.0, cross_sections(s.particles.radius, 3)) ==
          relative(1.0 / (std::numbers::sqrt2 * pi * density * d * d), 1e-12));

    // Two whose momentum is conserved are one point among spheres: pi d^2 v / (V - 4 pi d^3 / 3).
    const GasState two = state_named("space-two-free");
    const Eigen::ArrayXd apart = two.start.velocity.row(0) - two.start.velocity.row(1);
    CHECK(two.value_of(LawOf::collision_rate) ==
          relative(
              pi * d * d * std::sqrt(apart.square().sum()) / (3600.0 - 4.0 / 3.0 * pi * d * d * d),
              0.001));

    // Two between walls: a quarter of the mean relative speed, which six degrees of freedom share,
    // times how fast the room of near places grows with the distance, over the room of the others.
    GasState closed = state_named("space");
    closed.gas.box.size = {5.0, 6.0, 7.0};
    closed.particles = spheres_of({0.3, 0.3});
    closed.start.position = closed.start.position.topRows(2).eval();
    closed.start.velocity = closed.start.velocity.topRows(2).eval();
    const NearPlaces places{5.0 - d, 6.0 - d, 7.0 - d};
    const double energy = 0.5 * closed.start.velocity.square().sum();
    // |u| of the three components of the relative velocity among six that share the energy.
    const double relative_speed = std::sqrt(2.0) * std::sqrt(2.0 * energy) *
                                  std::exp(std::lgamma(2.0) - std::lgamma(1.5)) *
                                  std::exp(std::lgamma(3.0) - std::lgamma(3.5));
    const double rate =
        0.25 * relative_speed * places.growth(d) / (places.all() - places.volume(d));
    // The effect of walls is of first order in d over the sides: 12 %, of which 1.5 % are left.
    CHECK(closed.value_of(LawOf::collision_rate) == relative(rate, 0.015));
}

TEST_CASE("a Maxwell gas in space has <v> = sqrt(8/3pi) v_rms and fluxes n <v> / 4 of 2 T each") {
    const GasState s = state_named("space-fluid");
    const double t = s.value_of(LawOf::temperature), speed = s.value_of(LawOf::mean_speed);
    const double energy = s.value_of(LawOf::mean_energy);
    CHECK(speed / std::sqrt(2.0 * energy) == relative(0.92132, 5e-5));  // and 1/N
    CHECK(squared_mean_length(3) / 3.0 == relative(0.92132 * 0.92132, 1e-5));
    GasState wide = s;
    wide.gas.box.size = {60.0, 60.0, 60.0};
    wide.asked.axis = 2;
    wide.asked.at = 30.0;
    const Law flux = law(wide.boxed(), LawOf::flux, wide.asked);
    REQUIRE(flux);
    CHECK(flux.value == relative(0.25 * speed * 2653.0 / 60.0, 1e-9));
    CHECK(flux.energy / flux.value == relative(2.0 * t, 1e-3));  // but for 1/N
    // By integration over Maxwell's distribution of the velocity along the axis.
    const auto maxwell = [](double v) { return std::exp(-0.5 * v * v) / std::sqrt(2.0 * pi); };
    const double each = summed(0.0, 12.0, [&](double v) { return v * maxwell(v); });
    const double carried =
        summed(0.0, 12.0, [&](double v) { return v * (0.5 * v * v + 1.0) * maxwell(v); });
    CHECK(each == relative(0.25 * std::sqrt(squared_mean_length(3)), 1e-6));
    CHECK(carried / each == relative(2.0, 1e-6));
}

TEST_CASE("shares of energy in space are Beta distributed") {
    for (const double count : {2.0, 3.0, 20.0}) {
        CAPTURE(count);
        const EquilibriumGas gas{9.0, 1.5, 1.5 * (count - 1.0), {{2.0, count}}};
        CHECK(gas.dimension() == 3);
        const auto moment = [&](int power) {
            // x = sin^2 of an angle, smooth at both ends.
            return summed(0.0, 0.5 * pi, [&](double angle) {
                const double share = std::pow(std::sin(angle), 2);
                return std::pow(share, power) * energy_density(gas, 9.0 * share) * 9.0 *
                       std::sin(2.0 * angle);
            });
        };
        CHECK(moment(0) == relative(1.0, 1e-6));
        CHECK(moment(1) == relative(1.0 / count, 1e-6));
        CHECK(moment(2) == relative(2.5 / (count * (1.5 * count + 1.0)), 1e-6));
        const auto speed_moment = [&](int power) {
            return summed(0.0, 0.5 * pi, [&](double angle) {
                const double v = 3.0 * std::sin(angle);
                return std::pow(v, power) * speed_density(gas, v) * 3.0 * std::cos(angle);
            });
        };
        CHECK(speed_moment(0) == relative(1.0, 1e-6));
        CHECK(speed_moment(1) == relative(mean_speed(gas), 1e-6));
        CHECK(speed_moment(2) == relative(9.0 / count, 1e-6));
        // A component has a third of it.
        const double along = summed(-0.5 * pi, 0.5 * pi, [&](double angle) {
            const double v = 3.0 * std::sin(angle);
            return v * v * velocity_density(gas, v) * 3.0 * std::cos(angle);
        });
        CHECK(along == relative(3.0 / count, 1e-6));
        CHECK(energy_density(gas, 0.0) == 0.0);
    }
    // The density of a Maxwell gas is the limit: v^2 exp(-v^2 / 2) sqrt(2/pi).
    const EquilibriumGas many{1.5e6, 1.5, 1.5e6 - 1.5, {{1.0, 1e6}}};
    for (const double v : {0.3, 1.4, 3.0})
        CHECK(speed_density(many, v) ==
              relative(std::sqrt(2.0 / pi) * v * v * std::exp(-0.5 * v * v), 1e-4));
}

TEST_CASE("motion along some of the axes has its part of the energy") {
    const auto moment = [](const EquilibriumGas& part, double fastest, int power) {
        return summed(0.0, 0.5 * pi, [&](double angle) {
            const double v = fastest * std::sin(angle);
            return std::pow(v, power) * speed_density(part, v) * fastest * std::cos(angle);
        });
    };
    // Five spheres of mass 2 and the energy 9, between walls: each component has a fifteenth of it.
    const EquilibriumGas gas{9.0, 1.5, 6.0, {{2.0, 5.0}}};
    for (const std::vector<int>& axes : {std::vector{0}, {2}, {0, 1}, {1, 2}, {0, 1, 2}}) {
        const auto count = static_cast<double>(axes.size());
        CAPTURE(count);
        const EquilibriumGas part = motion_along(gas, axes);
        CHECK(moment(part, 3.0, 0) == relative(1.0, 1e-6));
        CHECK(moment(part, 3.0, 2) == relative(9.0 * count / 15.0, 1e-6));
        CHECK(moment(part, 3.0, 1) == relative(mean_speed(part), 1e-6));
    }
    // Momentum is conserved along x alone, or along y and z: a single axis is the density of a
    // component, on both sides of 0, and two have the sum of the squares of both.
    for (const std::array<double, 3>& shares :
         {std::array{0.7, 1.0, 1.0}, {1.0, 0.6, 0.6}, {0.8, 0.8, 0.8}}) {
        const EquilibriumGas some{9.0, 1.5, 6.0, {{2.0, 3.0, shares}, {4.0, 2.0, shares}}};
        for (int axis = 0; axis < 3; ++axis)
            for (const double v : {0.1, 0.9, 1.8})
                CHECK(speed_density(motion_along(some, {axis}), v) ==
                      relative(2.0 * velocity_density(some, v, axis), 1e-12));
        for (const auto& [a, b] : {std::pair{0, 1}, {0, 2}, {1, 2}}) {
            const double of_a = moment(motion_along(some, {a}), 3.0, 2),
                         of_b = moment(motion_along(some, {b}), 3.0, 2);
            CHECK(moment(motion_along(some, {a, b}), 3.0, 2) == relative(of_a + of_b, 1e-4));
        }
    }
    // The limits of Maxwell: exp(-v^2 / 2) sqrt(2/pi) along an axis, v exp(-v^2 / 2) in a plane.
    const EquilibriumGas many{1.5e6, 1.5, 1.5e6 - 1.5, {{1.0, 1e6}}};
    for (const double v : {0.3, 1.4, 3.0}) {
        CHECK(speed_density(motion_along(many, {1}), v) ==
              relative(std::sqrt(2.0 / pi) * std::exp(-0.5 * v * v), 1e-4));
        CHECK(speed_density(motion_along(many, {0, 2}), v) ==
              relative(v * std::exp(-0.5 * v * v), 1e-4));
    }
}

TEST_CASE("each side of a closed partition in space has an equilibrium of its own") {
    GasState s = state_named("space-divided");
    s.asked.of = {{0, 1, 2, 3, 4, 5, 6}};
    s.asked.thermal = ThermalMotion{.energy = 9.0, .degrees_of_freedom = 21.0};
    const Law found = law(s.boxed(), LawOf::side_distribution, s.asked);
    REQUIRE(found);
    const auto moment = [&](int power) {
        return summed(0.0, 9.0, [&](double e) {
            return std::pow(e / 9.0, power) * energy_density(*found.equilibrium, e);
        });
    };
    // Beta(3/2, 18/2) of seven spheres: 1/7 and 1/7 of (5/2) / (23/2).
    CHECK(moment(1) == relative(1.0 / 7.0, 1e-4));
    CHECK(moment(2) == relative(5.0 / (7.0 * 23.0), 1e-4));
}

TEST_CASE("a column of spheres has the exponent of its degrees of freedom") {
    // (1 - m g h / E)^((5 N - k) / 2 - 2) with k momenta along the floor that are conserved.
    for (const int conserved : {0, 1, 2})
        for (const int count : {2, 5, 50}) {
            CAPTURE(count);
            CAPTURE(conserved);
            const double energy = 2.2 * count, power = 0.5 * (5.0 * count - conserved) - 2.0;
            const BarometricLaw law(3.0 * count - conserved, energy, 0.8,
                                    {{1.5, double(count), 1e3}}, 0);
            for (const double h : {0.1, 0.5, 1.0, 2.5}) {
                const double left = std::max(0.0, 1.0 - 1.5 * 0.8 * h / energy);
                CHECK(law.share_below(h) ==
                      doctest::Approx(1.0 - std::pow(left, power + 1.0)).epsilon(0.002));
            }
        }
    // The same law by drawing states: heights and momenta are uniform on a simplex and a sphere.
    GasState s = state_named("space-gravity");
    s.gas.box.size = {20.0, 400.0, 12.0};
    const BoxedGas gas = s.boxed();
    const double energy = gas.thermal.energy + gas.falling_energy;
    s.asked.cells = 400;
    const Law heights = law(gas, LawOf::heights, s.asked);
    REQUIRE(heights);
    double all = 0.0, mean = 0.0;
    for (std::size_t k = 0; k < heights.curve.size(); ++k) {
        const double there = heights.curve[k] * 20.0 * 12.0;
        all += there;
        mean += there * (double(k) + 0.5 - 0.3) / 20.0;
    }
    CHECK(all == relative(20.0, 1e-9));
    // E / (m g) over N + 3 N / 2 equal shares; slabs are 1 high.
    CHECK(mean == relative(energy / (0.2 * 50.0), 0.01));
}

TEST_CASE("a piston over spheres stands at E / F (N + 1) / (5 N / 2 + 3 / 2)") {
    for (const double count : {1.0, 4.0, 100.0}) {
        const PistonLaw law{.count = count, .energy = 7.0, .force = 2.0, .dimension = 3};
        CHECK(law.mean() == relative(3.5 * (count + 1.0) / (2.5 * count + 1.5), 1e-14));
        const auto weight = [&](double h) {
            return std::exp(count * std::log(h / 3.5) +
                            0.5 * (3.0 * count - 1.0) * std::log1p(-h / 3.5));
        };
        const double all = summed(0.0, 3.5, weight);
        CHECK(summed(0.0, 3.5, [&](double h) { return h * weight(h); }) / all ==
              relative(law.mean(), 1e-5));
        CHECK(law.density(1.1) == relative(weight(1.1) / all, 1e-5));
    }
    CHECK(law(state_named("space-piston").boxed(), LawOf::piston, {.surface = 5}));
}

TEST_CASE("the mean free path of a sphere among spheres is four volumes over the surface") {
    Box box = cube_of(4.0, Wall::periodic);
    box.surfaces.obstacles = {{"ball", Obstacle::Ball{{2.0, 2.0, 2.0}, 1.3}}};
    const double reach = 1.5, volume = 64.0 - 4.0 / 3.0 * pi * std::pow(reach, 3);
    // (V - V_b) / (pi R^2).
    CHECK(*mean_path_of_billiard(box, 0.2, false) ==
          relative(volume / (pi * reach * reach), 1e-12));
    // Rays from all places of the sphere, by Lambert's law, to the next of its images.
    Random random(8, "rays between spheres");
    double sum = 0.0, squares = 0.0;
    constexpr int rays = 20'000;
    for (int k = 0; k < rays; ++k) {
        Vec normal{random.normal(), random.normal(), random.normal()};
        normal /= length(normal);
        Vec way{random.normal(), random.normal(), random.normal()};
        way = normal + way / length(way);  // uniform on a sphere that touches the origin
        way /= length(way);
        const Vec from = reach * normal;  // seen from the centre
        double nearest = 1e9;
        for (int cells = 3; nearest > 1e8; cells *= 2)
            for (int x = -cells; x <= cells; ++x)
                for (int y = -cells; y <= cells; ++y)
                    for (int z = -cells; z <= cells; ++z) {
                        const Vec to = Vec{4.0 * x, 4.0 * y, 4.0 * z} - from;
                        const double along = dot(to, way);
                        const double inside = along * along - square(to) + reach * reach;
                        if (along > 1e-9 && inside > 0.0 && (x != 0 || y != 0 || z != 0))
                            nearest = std::min(nearest, along - std::sqrt(inside));
                    }
        sum += nearest;
        squares += nearest * nearest;
    }
    const double mean = sum / rays, error = std::sqrt((squares / rays - mean * mean) / rays);
    CHECK(std::abs(mean - *mean_path_of_billiard(box, 0.2, false)) < 4.0 * error);
    CHECK(error < 0.03 * mean);
    // Between walls the sides count; the volume by counting points.
    const GasState s = state_named("space-billiard");
    double inside = 0.0;
    constexpr int points = 200'000;
    for (int k = 0; k < points; ++k) {
        const Vec at{random.uniform(0.0, 20.0), random.uniform(0.0, 15.0),
                     random.uniform(0.0, 12.0)};
        const bool is_free =
            on_each_axis(3, [&](int a) { return at[a] > 0.3 && at[a] < s.gas.box.size[a] - 0.3; });
        inside += is_free && length(at - Vec{10.0, 7.0, 6.0}) > 1.8 ? 1.0 : 0.0;
    }
    const double surface = 2.0 * (19.4 * 14.4 + 14.4 * 11.4 + 11.4 * 19.4) + 4.0 * pi * 1.8 * 1.8;
    const double share = inside / points;
    CHECK(
        s.value_of(LawOf::free_flight) ==
        relative(4.0 * 3600.0 * share / surface, 4.0 * std::sqrt((1.0 - share) / share / points)));
    // Too near to a wall or to each other for the sphere to pass.
    box.surfaces.obstacles.push_back({"other", Obstacle::Ball{{0.0, 0.0, 0.0}, 1.9}});
    CHECK_FALSE(mean_path_of_billiard(box, 0.2, false));
    CHECK(mean_path_of_billiard(box, 0.05, false));
    CHECK_FALSE(mean_path_of_billiard(cube_of(4.0, Wall::solid), 0.2, false));
    CHECK(*mean_path_of_billiard(cube_of(4.0, Wall::solid), 0.5, true) == relative(2.0, 1e-12));
}

TEST_CASE("spheres diffuse as in runs of a slow simulator") {
    int rows = 0;
    for (const auto& row : test::reference_rows("diffusion_hard_sphere.csv")) {
        const double density = std::stod(row[0]), count = std::stod(row[1]);
        CAPTURE(density);
        CAPTURE(count);
        ++rows;
        const double side = std::cbrt(count / density);
        // The 5 % that the function states, and the standard error of the run.
        CHECK(diffusion_of_spheres(density, 1.0, 1.0, 1.0, side) ==
              relative(std::stod(row[2]), 0.05 + std::stod(row[3])));
    }
    CHECK(rows == 5);
    // Dilute: Chapman and Enskog's 3/8 sqrt(T / (pi m)) / (n d^2) times 1.019, in other units.
    CHECK(diffusion_of_spheres(1e-6, 2.0, 3.0, 5.0, 1e12) ==
          relative(1.01896 * 0.375 * std::sqrt(3.0 / (5.0 * pi)) / 4e-6, 1e-4));
    const GasState s = state_named("space-fluid");
    CHECK(s.value_of(LawOf::diffusion) ==
          relative(diffusion_of_spheres(2.653, 0.6, s.value_of(LawOf::temperature), 1.0, 10.0),
                   1e-12));
}

TEST_CASE("all places are alike along axes of space along which nothing differs") {
    Gas gas{.box = cube_of(10.0, Wall::solid),
            .species = {{.name = "a", .count = 60, .radius = 0.3, .velocity = Temperature{1.0}}}};
    using Even = std::array<bool, 3>;
    CHECK(even_axes(gas, {}) == Even{true, true, true});
    gas.box.surfaces.gravity = {0.0, 0.0, -1.0};
    CHECK(even_axes(gas, {}) == Even{true, true, false});
    gas.box.surfaces.sides[0] = Bath{1.0};
    CHECK(even_axes(gas, {}) == Even{false, true, false});
    gas.box.surfaces.partitions = {{.name = "p", .axis = 1, .at = 5.0}};
    CHECK(even_axes(gas, {}) == Even{});
    // So many that they may freeze: 0.492 of the volume, by the mean of their cubes.
    gas.box = cube_of(10.0, Wall::solid);
    const auto freezes = [&](const ValueRule& radius, double mean_cube) {
        gas.species[0].radius = radius;
        const double most = 0.492 * 1000.0 / (4.0 / 3.0 * pi * mean_cube);
        gas.species[0].count = static_cast<std::int64_t>(0.999 * most);
        const bool before = even_axes(gas, {}) == Even{true, true, true};
        gas.species[0].count = static_cast<std::int64_t>(1.001 * most) + 1;
        return before && even_axes(gas, {}) == Even{};
    };
    CHECK(freezes(0.3, 0.027));
    CHECK(freezes(UniformDistribution{0.1, 0.4},
                  summed(0.1, 0.4, [](double r) { return r * r * r / 0.3; })));
    CHECK(freezes(NormalDistribution{0.3, 0.05}, summed(0.0, 0.6, [](double r) {
                      const double u = (r - 0.3) / 0.05;
                      return r * r * r * std::exp(-0.5 * u * u) / (0.05 * std::sqrt(2.0 * pi));
                  })));
}
