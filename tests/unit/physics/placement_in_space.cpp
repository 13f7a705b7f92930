// Spheres in boxes of three lengths: their places, against looks at all pairs and exact
// probabilities.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "physics/gas.h"
#include "physics/mechanics.h"
#include "physics/placement/jam.h"
#include "physics/placement/lattice.h"
#include "physics/placement/overlap.h"
#include "physics/placement/placement.h"
#include "support/goodness_of_fit.h"
#include "support/placement_error.h"
#include "support/relative.h"
#include "support/space.h"
#include "util/random.h"

using namespace carom;
using test::placement_error;
using test::relative;

namespace {

constexpr Walls all_solid{Wall::solid, Wall::solid, Wall::solid};
constexpr Walls all_periodic{Wall::periodic, Wall::periodic, Wall::periodic};
constexpr double pi = std::numbers::pi;

Gas space_of(const Vec& size, std::vector<Species> species, const Walls& walls = all_solid) {
    Gas gas;
    gas.box = test::space_of(size, walls);
    gas.species = std::move(species);
    return gas;
}

/// A cube for equal spheres of radius 1/2 at this packing.
Gas cube_at(double packing, std::int64_t count, const Walls& walls = all_periodic) {
    const double side = std::cbrt(static_cast<double>(count) * pi / 6.0 / packing);
    return space_of({side, side, side}, {{.name = "", .count = count}}, walls);
}

/// The separation of the nearest images.
Vec apart(const Box& box, const Sample& sample, Eigen::Index i, Eigen::Index j) {
    Vec r = vec_in(sample.position, i) - vec_in(sample.position, j);
    for (int a = 0; a < 3; ++a)
        if (box.is_periodic(a)) r[a] = std::remainder(r[a], box.size[a]);
    return r;
}

// The least of distance / (sum of radii) over all pairs and images, and of room to the walls.
double least_clearance(const Gas& gas, const Particles& particles, const Sample& sample) {
    double least = std::numeric_limits<double>::infinity();
    for (Eigen::Index i = 0; i < particles.count(); ++i) {
        for (Eigen::Index j = 0; j < i; ++j) {
            const Vec r = apart(gas.box, sample, i, j);
            least = std::min(least, std::sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2]) /
                                        (particles.radius[i] + particles.radius[j]));
        }
        for (int a = 0; a < 3; ++a) {
            const double x = sample.position(i, a), radius = particles.radius[i];
            const double room = std::min(x, gas.box.size[a] - x);
            if (gas.box.is_periodic(a))
                CHECK(room >= 0.0);
            else
                least = std::min(least, room / radius);
        }
    }
    return least;
}

Walls walls_by_bits(int bits) {
    const auto wall = [&](int bit) {
        return (bits >> bit & 1) != 0 ? Wall::periodic : Wall::solid;
    };
    return {wall(0), wall(1), wall(2)};
}

}  // namespace

TEST_CASE("spheres at random places do not overlap, lie inside, and depend on the seed only") {
    for (const int bits : {0, 7, 2, 5}) {
        Gas gas =
            space_of({14.0, 10.0, 12.0},
                     {{.name = "small", .count = 300, .radius = UniformDistribution{0.2, 0.6}},
                      {.name = "large", .count = 3, .radius = 2.0}},
                     walls_by_bits(bits));
        const auto [particles, start] = place(gas);
        CHECK(particles.count() == 303);
        CHECK(start.position.cols() == 3);
        CHECK(least_clearance(gas, particles, start) >= 1.0 - 1e-12);
        CHECK((place(gas).second.position == start.position).all());
        gas.seed = 2;
        CHECK((place(gas).second.position != start.position).any());
    }
}

TEST_CASE("spheres find random places to packing 0.30 quickly and to 0.36 with patience") {
    for (const auto& [packing, count] : {std::pair(0.30, 20'000), std::pair(0.36, 400)}) {
        const Gas gas = cube_at(packing, count);
        const auto [particles, start] = place(gas);
        CHECK(particles.count() == count);
        CHECK(largest_relative_overlap(gas.box, particles, start) == 0.0);
        if (count < 1000) CHECK(least_clearance(gas, particles, start) >= 1.0);
    }
}

// Each of 64 equal parts has the same probability, so chi-square has 63 degrees of freedom, and
// exceeds 131 once in a million (Wilson and Hilferty 1931).
TEST_CASE("points are as many in each part of the box, but for chance") {
    for (const bool in_region : {false, true}) {
        Gas gas = space_of({4.0, 6.0, 8.0}, {{.name = "", .count = 64'000, .radius = 0.0}});
        Vec low, size = gas.box.size;
        if (in_region) {
            low = {1.0, 2.0, 3.0};
            size = {2.0, 3.0, 4.0};
            gas.species[0].position = WithinRegion{{low, low + size}};
        }
        const Sample start = place(gas).second;
        std::array<int, 64> counts{};
        for (Eigen::Index i = 0; i < start.position.rows(); ++i) {
            std::size_t part = 0;
            for (int a = 0; a < 3; ++a) {
                const double x = 4.0 * (start.position(i, a) - low[a]) / size[a];
                REQUIRE((x >= 0.0 && x <= 4.0));
                part = 4 * part + static_cast<std::size_t>(std::min(x, 3.9));
            }
            ++counts.at(part);
        }
        double chi_square = 0.0;
        for (const int count : counts) chi_square += (count - 1000.0) * (count - 1000.0) / 1000.0;
        CHECK(chi_square < 131.0);
        CHECK(chi_square > 20.0);  // 1e-8: more even than chance
    }
}

// The second of two spheres is anywhere but where it overlaps the first: within half a side, the
// volume of the shell between it and contact is uniform. One test: a p-value of 1e-6 is a failure.
TEST_CASE("two spheres have the distances of a uniform distribution outside of contact") {
    std::vector<double> volumes;
    Gas gas = space_of({4.0, 4.0, 4.0}, {{.name = "", .count = 2}}, all_periodic);
    for (gas.seed = 1; gas.seed <= 4000; ++gas.seed) {
        const Sample start = place(gas).second;
        const double distance = length(apart(gas.box, start, 0, 1));
        REQUIRE(distance >= 1.0);
        if (distance < 2.0) volumes.push_back((std::pow(distance, 3) - 1.0) / 7.0);
    }
    // the share of a shell from 1 to 2 of what is left of the box
    const double share = 28.0 / 3.0 * pi / (64.0 - 4.0 / 3.0 * pi);
    CHECK(std::abs(static_cast<double>(volumes.size()) - 4000.0 * share) <
          5.0 * std::sqrt(4000.0 * share * (1.0 - share)));
    CHECK(test::chance(volumes, [](double x) { return x; }) > 1e-6);
}

TEST_CASE("on a lattice each sphere has twelve neighbours, all equally far") {
    // as dense as spheres can be
    for (const int cells : {1, 2, 5}) {
        const double side = cells * std::sqrt(2.0);
        const std::int64_t count = 4 * cells * cells * cells;
        Gas gas = space_of({side, side, side}, {{.name = "", .count = count}}, all_periodic);
        gas.species[0].position = LatticePlaces{};
        const auto [particles, start] = place(gas);
        CHECK(static_cast<double>(count) * pi / 6.0 / gas.box.content() ==
              relative(pi / std::sqrt(18.0), 1e-14));
        CHECK(least_clearance(gas, particles, start) >= 1.0 - 1e-12);
        if (cells > 1)
            for (Eigen::Index i = 0; i < count; ++i) {
                int near = 0;
                for (Eigen::Index j = 0; j < count; ++j) {
                    const double distance = length(apart(gas.box, start, i, j));
                    near += i != j && std::abs(distance - 1.0) < 1e-12;
                    if (i != j) CHECK((distance < 1.0 + 1e-12 || distance > 1.4));
                }
                CHECK(near == 12);
            }
        gas.species[0].count = count + 1;
        CHECK(placement_error(gas) != "");
    }
    // between walls: as many planes along each axis, whose outermost spheres touch the walls
    const double side = 1.0 + 6.0 * 0.8;
    Gas gas = space_of({side, side, side}, {{.name = "", .count = (7 * 7 * 7 + 1) / 2}});
    gas.species[0].position = LatticePlaces{};
    const auto [particles, start] = place(gas);
    int inside = 0;
    for (Eigen::Index i = 0; i < particles.count(); ++i) {
        int near = 0;
        for (Eigen::Index j = 0; j < particles.count(); ++j)
            near += std::abs(length(apart(gas.box, start, i, j)) - 0.8 * std::sqrt(2.0)) < 1e-12;
        const auto along = start.position.row(i);
        if (along.minCoeff() < 0.6 || along.maxCoeff() > side - 0.6) continue;
        ++inside;
        CHECK(near == 12);
    }
    CHECK(inside == 5 * 5 * 5 / 2);
    CHECK(start.position.minCoeff() == 0.5);
    CHECK(start.position.maxCoeff() == relative(side - 0.5, 1e-15));
}

TEST_CASE("lattices are fitted to boxes of any shape") {
    for (int bits = 0; bits < 8; ++bits)
        for (const Vec& size : {Vec(9.0, 8.0, 7.0), Vec(3.0, 20.0, 2.0), Vec(1.0, 1.0, 60.0)})
            for (const int count : {1, 2, 7, 50, 300}) {
                CAPTURE(count);
                Gas gas =
                    space_of(size, {{.name = "", .count = count, .position = LatticePlaces{}}},
                             walls_by_bits(bits));
                const double volume = 0.3 * gas.box.content() / count;
                gas.species[0].radius =
                    std::min(std::cbrt(0.75 / pi * volume), 0.5 * gas.box.shortest_side());
                CAPTURE(size[0]);
                CAPTURE(bits);
                const std::string error = placement_error(gas);
                if (error != "") {
                    CHECK(error.starts_with("no face-centred cubic lattice holds "));
                    continue;
                }
                const auto [particles, start] = place(gas);
                CHECK(least_clearance(gas, particles, start) >= 1.0 - 1e-11);
            }
}

// Against all numbers of lines, with the distances of all sites.
TEST_CASE("no other lattice of its kind has its sites further apart") {
    for (int bits = 0; bits < 8; ++bits)
        for (const Vec& size : {Vec(5.0, 5.0, 5.0), Vec(4.0, 7.0, 5.5)})
            for (const std::int64_t count : {2, 9, 20}) {
                CAPTURE(bits);
                CAPTURE(count);
                Gas gas = space_of(size, {}, walls_by_bits(bits));
                const double radius = 0.1;
                const auto found = fitting_lattice(gas.box, count, radius);
                REQUIRE(found.has_value());
                CHECK(found->sites() >= count);
                const auto nearest_of = [&](const Lattice& lattice) {
                    const std::vector<Vec> sites = lattice_sites(gas.box, lattice, radius);
                    CHECK(std::ssize(sites) == lattice.sites());
                    double least = std::numeric_limits<double>::infinity();
                    for (std::size_t i = 0; i < sites.size(); ++i)
                        for (std::size_t j = 0; j < i; ++j) {
                            Vec r = sites[i] - sites[j];
                            for (int a = 0; a < 3; ++a)
                                if (gas.box.is_periodic(a)) r[a] = std::remainder(r[a], size[a]);
                            least = std::min(least, length(r));
                        }
                    return least;
                };
                const double best = nearest_of(*found);
                CHECK(best >= found->nearest * (1.0 - 1e-14));
                Lattice other{.dimension = 3};
                for (other.lines[0] = 1; other.lines[0] <= 8; ++other.lines[0])
                    for (other.lines[1] = 1; other.lines[1] <= 8; ++other.lines[1])
                        for (other.lines[2] = 1; other.lines[2] <= 8; ++other.lines[2]) {
                            bool is_possible = other.sites() >= count && other.sites() < 2 * count;
                            for (int a = 0; a < 3; ++a) {
                                const auto lines =
                                    static_cast<double>(other.lines[static_cast<std::size_t>(a)]);
                                const bool is_periodic = gas.box.is_periodic(a);
                                // An own image is as near as the box is long.
                                is_possible =
                                    is_possible && !(is_periodic && std::fmod(lines, 2.0) == 1.0);
                                other.step[a] = is_periodic ? size[a] / lines
                                                : lines > 1.0
                                                    ? (size[a] - 2.0 * radius) / (lines - 1.0)
                                                    : size[a];
                            }
                            if (is_possible) CHECK(nearest_of(other) <= best * (1.0 + 1e-14));
                        }
            }
}

TEST_CASE("species share a lattice in space, and others go around it, in regions and listed") {
    Gas gas = space_of({12.0, 12.0, 12.0},
                       {{.name = "a", .count = 60, .radius = 0.5, .position = LatticePlaces{}},
                        {.name = "b", .count = 60, .radius = 0.4, .position = LatticePlaces{}},
                        {.name = "listed", .count = 1, .radius = 2.0},
                        {.name = "within", .count = 10, .radius = 0.2}});
    gas.species[2].position = Places{{{6.0, 6.0, 6.0}}};
    gas.species[3].position = WithinRegion{{{2.0, 2.0, 7.0}, {8.0, 8.0, 10.0}}};
    const auto [particles, start] = place(gas);
    CHECK(least_clearance(gas, particles, start) >= 1.0 - 1e-12);
    CHECK(start.position(120, 2) == 6.0);
    const auto within = start.position.bottomRows(10);
    CHECK(within.leftCols(2).minCoeff() >= 2.2);
    CHECK(within.leftCols(2).maxCoeff() <= 7.8);
    CHECK(within.col(2).minCoeff() >= 7.2);
    CHECK(within.col(2).maxCoeff() <= 9.8);
    // both species are mixed on the lattice
    CHECK(start.position.col(2).topRows(60).mean() == relative(6.0, 0.2));
}

TEST_CASE("no room in space: the numbers of volumes and what to write instead") {
    CHECK(placement_error(space_of({10.0, 10.0, 10.0}, {{.name = "", .count = 10'000}})) ==
          "the spheres fill 5236 of the box's volume 1000 (packing fraction 5.236), more than the "
          "0.7405 of the densest packing; fewer or smaller spheres, or a box of about 25.9 by 25.9 "
          "by 25.9");
    CHECK(placement_error(cube_at(0.45, 10'000)) ==
          "10000 spheres at random places have packing fraction 0.45, and random placement ends at "
          "0.384; fewer spheres (6666 have packing fraction 0.3), smaller ones, a larger box, or "
          "places on a lattice");
    Gas gas = space_of({20.0, 20.0, 20.0}, {{.name = "w", .count = 1000}});
    gas.species[0].position = WithinRegion{{{1.0, 1.0, 1.0}, {11.0, 11.0, 11.0}}};
    CHECK(placement_error(gas) ==
          "1000 spheres at random places in its region have packing fraction 0.5236, and random "
          "placement ends at 0.384; fewer spheres (572 have packing fraction 0.3), smaller ones, "
          "or more room");
    gas.species[0].count = 2000;
    CHECK(placement_error(gas) ==
          "2000 spheres in its region have packing fraction 1.047, more than the 0.7405 of the "
          "densest packing; fewer or smaller spheres or more room");
    gas.species[0].count = 1;
    gas.species[0].position = WithinRegion{{{1.0, 1.0, 1.0}, {11.0, 11.0, 1.5}}};
    CHECK(placement_error(gas) ==
          "a sphere of radius 0.5 does not fit into its region, 10 by 10 by 0.5; smaller spheres "
          "or more room");
    gas.species[0].position = WithinRegion{{{1.0, 1.0, 1.0}, {11.0, 11.0, 21.0}}};
    CHECK(placement_error(gas) ==
          "its region reaches outside the box of 20 by 20 by 20; make it smaller, or the box "
          "larger");
    CHECK(placement_error(space_of({3.0, 3.0, 3.0}, {{.name = "x", .count = 25}})) ==
          "only 13 of 25 spheres of species \"x\" could be placed at packing fraction 0.485; fewer "
          "or smaller spheres, a larger box, or places on a lattice");
    CHECK(placement_error(
              space_of({64.0, 48.0, 20.0}, {{.name = "giant", .count = 1, .radius = 12.0}})) ==
          "a sphere of radius 12 does not fit into a box of 64 by 48 by 20; a smaller sphere or a "
          "larger box");
    gas = space_of({4.0, 4.0, 4.0}, {{.name = "l", .count = 64, .position = LatticePlaces{}}});
    CHECK(placement_error(gas) ==
          "no face-centred cubic lattice holds 64 spheres of radius 0.5 in a box of 4 by 4 by 4; "
          "use fewer spheres (63 fit, with room to move or without), smaller ones, or a larger "
          "box");
    gas.species = {{.name = "l", .count = 40, .position = LatticePlaces{}},
                   {.name = "p", .count = 1, .radius = 1.5, .position = Places{{{2, 2, 2}}}}};
    CHECK(placement_error(gas).starts_with("other spheres leave "));
    gas.species = {{.name = "p", .count = 2, .position = Places{{{0.6, 2.0, 2.0}, {3.9, 2, 2}}}}};
    CHECK(placement_error(gas) ==
          "particle 1 (p) of radius 0.5 is not inside the box of 4 by 4 by 4; its centre must have "
          "x from 0.5 to 3.5, y from 0.5 to 3.5 and z from 0.5 to 3.5");
    gas.box.walls[0] = Wall::periodic;
    CHECK(placement_error(gas) ==
          "particle 1 (p) overlaps particle 0 (p): 0.7 apart, at least 1 needed; move one of them, "
          "or make them smaller");
    gas.species[0].position = Places{{{0.6, 2.0, 2.0}, {3.9, 2.0, 2.8}}};
    CHECK(placement_error(gas) == "");
}

TEST_CASE("masses by density are by volume, and velocities have three components") {
    Gas gas = space_of({30.0, 30.0, 30.0},
                       {{.name = "dense", .count = 2, .radius = 2.0, .mass = Density{3.0}},
                        {.name = "warm",
                         .count = 3000,
                         .radius = 0.1,
                         .mass = ValueRule{4.0},
                         .velocity = Temperature{2.0}},
                        {.name = "exact", .count = 5, .velocity = Temperature{8.0, true}}},
                       {Wall::solid, Wall::periodic, Wall::solid});
    gas.species[0].velocity = Velocity{{{1.0, 0.0, 3.0}}};
    const auto [particles, start] = place(gas);
    CHECK(particles.inverse_mass[0] == relative(1.0 / (3.0 * 32.0 / 3.0 * pi), 1e-15));
    CHECK(vec_in(start.velocity, 1) == Vec(1.0, 0.0, 3.0));
    // <m v^2 / 2> = 3/2 T with a standard error of T sqrt(3/2 / 3000): five of them
    const auto warm = start.velocity.middleRows(2, 3000);
    CHECK(std::abs(2.0 * warm.square().rowwise().sum().mean() - 3.0) <
          5.0 * 2.0 * std::sqrt(1.5 / 3000.0));
    for (int a = 0; a < 3; ++a) {
        // of sqrt(T / m) = 0.707; where the box is periodic, each species is at rest
        const double drift = std::abs(warm.col(a).mean());
        if (a == 1)
            CHECK(drift < 1e-15);
        else
            CHECK((drift > 1e-5 && drift < 5.0 * std::sqrt(0.5 / 3000.0)));
    }
    std::vector<Eigen::Index> exact{3002, 3003, 3004, 3005, 3006};
    // Of sums of 3000 squares: within as many round-offs of what they are.
    CHECK(thermal_motion(gas.box, particles, start, exact).temperature() ==
          relative(8.0, 9000 * 2.2e-16));
    CHECK(thermal_motion(gas.box, particles, start).degrees_of_freedom ==
          relative(3.0 * 3007.0 - 1.0, 1e-14));
}

TEST_CASE("the deepest overlap of spheres is that which a look at all pairs finds") {
    Random random(5, "spheres");
    int overlapping = 0;
    for (int round = 0; round < 800; ++round) {
        // As many cells as spheres, and few of these overlap; or one is much larger.
        Gas gas = space_of({5.0, 4.0, 3.0}, {}, walls_by_bits(round % 8));
        const Eigen::Index count = 60;
        Particles particles{Eigen::ArrayXd(count), Eigen::ArrayXd::Ones(count),
                            Eigen::ArrayXi::Zero(count)};
        Sample sample{0.0, Eigen::ArrayXXd(count, 3), Eigen::ArrayXXd::Zero(count, 3)};
        for (Eigen::Index i = 0; i < count; ++i) {
            particles.radius[i] = i == 0 && round % 16 < 8 ? 1.3 : random.uniform(0.1, 0.2);
            for (int a = 0; a < 3; ++a) sample.position(i, a) = gas.box.size[a] * random.uniform();
        }
        double deepest = 0.0;
        for (Eigen::Index i = 0; i < count; ++i)
            for (Eigen::Index j = 0; j < i; ++j)
                deepest = std::max(deepest, 1.0 - length(apart(gas.box, sample, i, j)) /
                                                      (particles.radius[i] + particles.radius[j]));
        overlapping += deepest > 0.0;
        CHECK(std::abs(largest_relative_overlap(gas.box, particles, sample) - deepest) < 1e-14);
    }
    CHECK(overlapping > 700);
    CHECK(overlapping < 800);
}

TEST_CASE("a row of spheres without room is a jam, along each axis of space") {
    for (int axis = 0; axis < 3; ++axis) {
        CAPTURE(axis);
        Vec size(10.0, 10.0, 10.0);
        size[axis] = 4.0;
        const Box box = test::space_of(size);
        const auto jam_of = [&](double shift, double along, double other) {
            const Particles particles{Eigen::ArrayXd::Ones(3), Eigen::ArrayXd::Ones(3),
                                      Eigen::ArrayXi::Zero(3)};
            Sample start{0.0, Eigen::ArrayXXd::Constant(3, 3, 5.0), Eigen::ArrayXXd::Zero(3, 3)};
            start.position(0, axis) = 3.0;
            start.position(1, axis) = 1.0;
            start.position(2, axis) = 1.0;
            start.position(1, (axis + 1) % 3) += shift;  // out of the row
            start.position(2, (axis + 2) % 3) += 3.0;
            start.velocity(1, axis) = along;
            start.velocity(1, (axis + 2) % 3) = other;
            const auto jam = first_jam(box, particles, start);
            return jam ? jam->particle : -1;
        };
        CHECK(jam_of(0.0, 1.0, 0.0) >= 0);
        CHECK(jam_of(0.0, 0.0, 1.0) == -1);  // it moves along its free sides
        CHECK(jam_of(0.5, 1.0, 0.0) == -1);
    }
    Gas gas = space_of({4.0, 2.0, 2.0}, {{.name = "row", .count = 2, .radius = 1.0}});
    gas.species[0].velocity = Speed{1.0};
    gas.species[0].position = LatticePlaces{};
    const auto [particles, start] = place(gas);
    CHECK(first_jam(gas.box, particles, start).has_value());
}
