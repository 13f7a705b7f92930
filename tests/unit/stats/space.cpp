// Statistics of spheres in space: by hand, by sums over points, and against published numbers.
#include "support/space.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "physics/mechanics.h"
#include "stats/cell_averages.h"
#include "stats/displacements.h"
#include "stats/entropy.h"
#include "stats/pairs/bond_order.h"
#include "stats/pairs/near_pairs.h"
#include "stats/pairs/pair_correlation.h"
#include "stats/paths/free_flights.h"
#include "stats/paths/line_crossings.h"
#include "stats/paths/time_averages.h"
#include "stats/pressure.h"
#include "stats/run_statistics.h"
#include "support/bodies.h"
#include "support/relative.h"
#include "support/spheres.h"
#include "util/random.h"

using namespace carom;
using std::numbers::pi;
using test::equal_spheres;
using test::relative;
using test::space_of;
using test::Sphere;

namespace {

constexpr Walls solid_walls{Wall::solid, Wall::solid, Wall::solid};
constexpr Walls periodic_walls{Wall::periodic, Wall::periodic, Wall::periodic};

Sample space_sample(double time, const std::vector<Sphere>& spheres) {
    Sample sample = test::start_of(spheres).second;
    sample.time = time;
    return sample;
}

// The places of a crystal: cells of these sides, each with these places in units of its sides.
std::vector<Sphere> crystal(const Vec& side, const std::vector<Vec>& basis, int cells) {
    std::vector<Sphere> all;
    for (int x = 0; x < cells; ++x)
        for (int y = 0; y < cells; ++y)
            for (int z = 0; z < cells; ++z)
                for (const Vec& at : basis)
                    all.push_back(
                        {{side[0] * (x + at[0]), side[1] * (y + at[1]), side[2] * (z + at[2])}});
    return all;
}

}  // namespace

TEST_CASE("shells in a solid box are known in closed form, in a periodic one whole") {
    const test::NearPlaces places{6.0, 4.0, 5.0};  // of centres, between walls
    const Box box = space_of({7.0, 5.0, 6.0}, solid_walls);
    for (const auto& [low, high] : {std::pair{0.0, 0.2}, {1.0, 1.1}, {3.3, 3.9}})
        CHECK(ring_probability(box, sides_of(box), {0.5, 0.5}, low, high) ==
              relative((places.volume(high) - places.volume(low)) / places.all(), 1e-9));
    const Box whole = space_of({7.0, 5.0, 6.0}, periodic_walls);
    CHECK(ring_probability(whole, sides_of(whole), {0.5, 0.5}, 1.0, 2.0) ==
          relative(4.0 / 3.0 * pi * 7.0 / 210.0, 1e-12));
    // All distances there are, of spheres of one size and of two: beyond the sides, too.
    for (const double other : {0.5, 1.0, 1.4}) {
        CAPTURE(other);
        double all = 0.0;
        for (int k = 0; k < 90; ++k)
            all += ring_probability(box, sides_of(box), {0.5, other}, 0.1 * k, 0.1 * (k + 1));
        CHECK(all == relative(1.0, 1e-6));
    }
}

TEST_CASE("shells between spheres of two sizes are those of random points") {
    const Box box = space_of({6.0, 4.0, 5.0}, {Wall::solid, Wall::periodic, Wall::solid});
    Random random(7, "points in space");
    constexpr int draws = 300'000, shells = 12;
    std::array<double, shells> counts{};
    for (int k = 0; k < draws; ++k) {
        const double x = random.uniform(0.2, 5.8) - random.uniform(1.1, 4.9);
        double y = random.uniform(0.0, 4.0) - random.uniform(0.0, 4.0);
        y -= 4.0 * std::round(y / 4.0);
        const double z = random.uniform(0.2, 4.8) - random.uniform(1.1, 3.9);
        const double r = std::sqrt(x * x + y * y + z * z);
        if (r < 2.0) counts[static_cast<std::size_t>(r * shells / 2.0)] += 1.0;
    }
    for (int k = 0; k < shells; ++k) {
        const double expected = draws * ring_probability(box, sides_of(box), {0.2, 1.1},
                                                         2.0 * k / shells, 2.0 * (k + 1) / shells);
        CAPTURE(k);
        // One of twelve counts is beyond 4.5 standard deviations once in 12,000 trials.
        CHECK(std::abs(counts[static_cast<std::size_t>(k)] - expected) < 4.5 * std::sqrt(expected));
    }
}

TEST_CASE("two spheres that pass each other are in each shell as long as it takes") {
    const Box box = space_of({100.0, 100.0, 100.0}, periodic_walls);
    PairCorrelation pairs(box, equal_spheres(2, 0.1), {.to = 5.0, .rings = 5}, {});
    // At a distance of 3 with relative velocity 2, from x = -4 to 4.
    pairs.see(space_sample(0.0, {{{50, 50, 50}, {1, 0, 0}}, {{54, 51.8, 52.4}, {-1, 0, 0}}}), {},
              sides_of(box));
    pairs.see(space_sample(4.0, {{{54, 50, 50}, {1, 0, 0}}, {{50, 51.8, 52.4}, {-1, 0, 0}}}), {},
              sides_of(box));
    const Eigen::ArrayXd g = pairs.values();
    const double nearer = 2.0 * std::sqrt(16.0 - 9.0) / 2.0;  // than 4
    const auto points = [](double low, double high) {
        return 4.0 * 4.0 / 3.0 * pi * (std::pow(high, 3) - std::pow(low, 3)) / 1e6;
    };
    CHECK(g.head(3).maxCoeff() == 0.0);
    CHECK(g[3] == relative(nearer / points(3.0, 4.0), 1e-9));
    CHECK(g[4] == relative((4.0 - nearer) / points(4.0, 5.0), 1e-9));
    // Across the front, the image that comes near: moved by a box in a time of 1.
    const Box small = space_of({10.0, 10.0, 10.0}, periodic_walls);
    for (const std::optional<double> window : {std::optional<double>{}, std::optional(50.0)}) {
        // In a window flights are not cut, so that further images than the nearest come near.
        PairCorrelation images(small, equal_spheres(2, 0.1),
                               {.to = 4.0, .rings = 4, .window = window}, {});
        for (const double time : {0.0, 1.0})
            images.see(space_sample(time, {{{5, 5, 1}}, {{5, 5, 4.5}, {0, 0, 10}}}), {},
                       sides_of(small));
        for (int k = 0; k < 4; ++k)  // a length of 1 on either side, each passed in 0.1
            CHECK(images.values()[k] ==
                  relative(0.2 / (4.0 / 3.0 * pi * (3.0 * k * k + 3.0 * k + 1.0) / 1000.0), 1e-9));
    }
}

TEST_CASE("a side of space that moves takes the points with it") {
    const Box box = space_of({6.0, 5.0, 8.0}, solid_walls);
    const Particles spheres = equal_spheres(2, 0.5);
    for (const std::size_t axis : {0U, 1U, 2U}) {
        CAPTURE(axis);
        PairCorrelation pairs(box, spheres, {.to = 2.0, .rings = 1}, {});
        const Sample at_rest = space_sample(0.0, {{{1, 1, 1}}, {{2, 2, 1}}});
        Sample later = at_rest;
        later.time = 1.0;
        // In between, the side is half way.
        BoxSides start = sides_of(box), between = start, end = start;
        between[axis].second -= 0.5;
        end[axis].second -= 1.0;
        pairs.see(at_rest, {}, start);
        pairs.see(later, {}, end);
        CHECK(pairs.values()[0] ==
              relative(1.0 / ring_probability(box, between, {0.5, 0.5}, 0.0, 2.0), 1e-12));
    }
}

TEST_CASE("a cubic crystal has its neighbours in their shells, whether it flies or rests") {
    const Box box = space_of({6.0, 6.0, 6.0}, periodic_walls);
    std::vector<Sphere> rows = crystal({1, 1, 1}, {{0.5, 0.5, 0.5}}, 6);
    for (Sphere& row : rows) row.velocity = {0.3, 0.1, -0.2};
    for (const std::optional<double> window : {std::optional<double>{}, std::optional(0.0)}) {
        PairCorrelation pairs(box, equal_spheres(rows.size(), 0.2),
                              {.to = 2.2, .rings = 11, .window = window}, {});
        pairs.see(space_sample(0.0, rows), {}, sides_of(box));
        std::vector<Sphere> later = rows;
        for (Sphere& row : later)
            for (const int axis : {0, 1, 2})
                row.place[axis] = box.wrapped(axis, row.place[axis] + row.velocity[axis]);
        pairs.see(space_sample(1.0, later), {}, sides_of(box));
        const Eigen::ArrayXd g = pairs.values();
        const auto neighbours = [&](int k) {
            return g[k] * 215.0 * 4.0 / 3.0 * pi * 0.008 * (3.0 * k * k + 3.0 * k + 1.0) / 216.0;
        };
        // Distances of 1 and 2 lie on the border of two shells.
        CHECK(neighbours(4) + neighbours(5) == relative(6.0, 1e-9));
        CHECK(neighbours(7) == relative(12.0, 1e-9));  // sqrt 2
        CHECK(neighbours(8) == relative(8.0, 1e-9));   // sqrt 3
        CHECK(neighbours(9) + neighbours(10) == relative(6.0, 1e-9));
        CHECK(g.head(4).maxCoeff() == 0.0);
        CHECK(g[6] == 0.0);
    }
}

TEST_CASE("in space pairs are near neighbours, each seen once") {
    for (const Walls& walls :
         {solid_walls, periodic_walls, Walls{Wall::solid, Wall::periodic, Wall::periodic}})
        for (const double distance : {0.4, 1.1, 3.0}) {
            CAPTURE(distance);
            const Box box = space_of({6.0, 4.0, 5.0}, walls);
            Random random(3, "near pairs in space");
            Eigen::ArrayXXd place(150, 3);
            for (Eigen::Index i = 0; i < 150; ++i)
                for (int axis = 0; axis < 3; ++axis)
                    place(i, axis) = random.uniform(0.0, box.size[axis]);
            std::set<std::pair<Eigen::Index, Eigen::Index>> seen;
            NearPairs(box, place, distance).for_each([&](Eigen::Index i, Eigen::Index j) {
                CHECK(i < j);
                CHECK(seen.emplace(i, j).second);
            });
            int near = 0;
            for (Eigen::Index i = 0; i < 150; ++i)
                for (Eigen::Index j = i + 1; j < 150; ++j) {
                    if (length(box.nearest(vec_in(place, j) - vec_in(place, i))) > distance)
                        continue;
                    ++near;
                    CHECK(seen.contains({i, j}));
                }
            CHECK(near > 5);
            if (distance == 0.4) CHECK(seen.size() < 150 * 149 / 4);
        }
}

TEST_CASE("crystals have the q6 of Steinhardt, turned or not, and a gas has none") {
    struct Crystal {
        Vec side;
        std::vector<Vec> basis;
        double radius, q6;
    };
    // Steinhardt, Nelson and Ronchetti (1983), figure 2; three digits in Mickel et al., J. Chem.
    // Phys. 138, 044501 (2013), table I. The neighbours of a body-centred cubic one are 14.
    const double c = std::sqrt(8.0 / 3.0);
    const std::vector<Crystal> crystals{
        {{1, 1, 1}, {{0, 0, 0}}, 0.5, 0.35355},
        {{std::sqrt(2.0), std::sqrt(2.0), std::sqrt(2.0)},
         {{0, 0, 0}, {0.5, 0.5, 0}, {0.5, 0, 0.5}, {0, 0.5, 0.5}},
         0.5,
         0.57452},
        {{1, 1, 1}, {{0, 0, 0}, {0.5, 0.5, 0.5}}, 0.25 * std::sqrt(3.0), 0.51069},
        {{1, std::sqrt(3.0), c},
         {{0, 0, 0}, {0.5, 0.5, 0}, {0.5, 1.0 / 6.0 + 2.0 / 3.0, 0.5}, {0, 1.0 / 3.0, 0.5}},
         0.5,
         0.48476}};
    for (const Crystal& one : crystals) {
        CAPTURE(one.q6);
        constexpr int cells = 5;
        const std::vector<Sphere> rows = crystal(one.side, one.basis, cells);
        const Particles particles = equal_spheres(rows.size(), one.radius);
        const Box box = space_of(double(cells) * one.side, periodic_walls);
        const Eigen::ArrayXXcd order = bond_order(box, particles, space_sample(0, rows).position);
        CHECK(local_order(order) == relative(one.q6, 2e-5));
        CHECK(order.matrix().rowwise().norm().minCoeff() == relative(one.q6, 2e-5));
        // The whole is as ordered as each, where all have the same surroundings but for inversion.
        CHECK(global_order(order) == relative(one.q6, 2e-5));
        // The middle of a turned patch.
        std::vector<Sphere> turned = rows;
        Eigen::Index inner = 0;
        const Vec middle = 0.5 * box.size;
        const double s = std::sin(0.7), t = std::cos(0.7), u = std::sin(1.9), w = std::cos(1.9);
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const Vec at = rows[i].place - middle;
            if (length(at) < length(rows[static_cast<std::size_t>(inner)].place - middle))
                inner = static_cast<Eigen::Index>(i);
            const Vec once{t * at[0] - s * at[1], s * at[0] + t * at[1], at[2]};
            turned[i].place = Vec{50, 50, 50} +
                              Vec{once[0], w * once[1] - u * once[2], u * once[1] + w * once[2]};
        }
        const Eigen::ArrayXXcd patch = bond_order(space_of({100, 100, 100}, solid_walls), particles,
                                                  space_sample(0, turned).position);
        CHECK(patch.row(inner).matrix().norm() == relative(one.q6, 2e-5));
    }
    // Twelve directions of an icosahedron: 0.66332. A single neighbour has 1, none 0.
    const double golden = 0.5 * (1.0 + std::sqrt(5.0)),
                 scale = 1.0 / std::sqrt(1.0 + golden * golden);
    std::vector<Sphere> rows{{{50, 50, 50}}};
    for (const double a : {-1.0, 1.0})
        for (const double b : {-golden, golden})
            for (int axis = 0; axis < 3; ++axis) {
                Vec at;
                at[axis] = a;
                at[(axis + 1) % 3] = b;
                rows.push_back({Vec{50, 50, 50} + scale * at});
            }
    const Box wide = space_of({100, 100, 100}, solid_walls);
    CHECK(bond_order(wide, equal_spheres(13, 0.5), space_sample(0, rows).position)
              .row(0)
              .matrix()
              .norm() == relative(0.66332, 1e-5));
    rows = {{{10, 10, 10}}, {{10.3, 10.6, 9.5}}, {{80, 80, 80}}};
    const Eigen::ArrayXXcd few =
        bond_order(wide, equal_spheres(3, 0.5), space_sample(0, rows).position);
    CHECK(few.row(1).matrix().norm() == relative(1.0, 1e-12));
    CHECK(few.row(2).matrix().norm() == 0.0);
    CHECK(local_order(few) == relative(2.0 / 3.0, 1e-12));
}

TEST_CASE(
    "cells in space are numbered along x, y and z, and spheres are as long in each as they are") {
    const Box box = space_of({8.0, 4.0, 6.0}, solid_walls);
    const Cells cells = square_cells(box, 4);
    CHECK(cells.count[0] == 4);
    CHECK(cells.count[1] == 2);
    CHECK(cells.count[2] == 3);
    CHECK(cells.content() == relative(8.0, 1e-14));
    const Region region = cells.region(1 + 4 * (1 + 2 * 2));
    CHECK(region.low == Vec{2.0, 2.0, 4.0});
    CHECK(region.high == Vec{4.0, 4.0, 6.0});
    // Along z at 1 from 1 to 5, in the column of x = 3 and y = 1.
    CellAverages averages(box, equal_spheres(1, 0.1), cells, {}, {});
    averages.see(space_sample(0.0, {{{3, 1, 1}, {0, 0, 1}}}), {});
    averages.see(space_sample(4.0, {{{3, 1, 5}, {0, 0, 1}}}), {});
    const CellSums sums = averages.sums();
    for (const auto& [level, time] : {std::pair{0, 1.0}, {1, 2.0}, {2, 1.0}}) {
        const Eigen::Index cell = 1 + 4 * (2 * level);
        CHECK(sums.particles[cell] == relative(time, 1e-12));
        CHECK(sums.velocity(cell, 2) == relative(time, 1e-12));
    }
    CHECK(sums.particles.sum() == relative(4.0, 1e-12));
    // Two in a cell with opposite velocities: 2 m v^2 by three degrees of freedom of n - 1 = 1.
    CellAverages moment(box, equal_spheres(2, 0.1), slabs(box, 2, 2),
                        {.window = 0.0, .temperature = true}, {});
    moment.see(space_sample(0.0, {{{3, 1, 1}, {1, 2, 2}}, {{3, 2, 1}, {-1, -2, -2}}}), {});
    CHECK(moment.sums().temperature()[0] == relative(6.0, 1e-12));
    CHECK(std::isnan(moment.sums().temperature()[1]));
}

TEST_CASE("the entropy of places in space grows by ln 8 from an eighth of the box") {
    const Box box = space_of({8.0, 8.0, 8.0}, solid_walls);
    const Particles particles = equal_spheres(512, 0.1);
    const PositionEntropy entropy(box, particles, 4);
    CHECK(entropy.cells().all() == 64);
    const Sample even = space_sample(0, crystal({1, 1, 1}, {{0.5, 0.5, 0.5}}, 8));
    const Sample corner = space_sample(0, crystal({0.5, 0.5, 0.5}, {{0.5, 0.5, 0.5}}, 8));
    CHECK(entropy.of(even.position) == relative(std::log(64.0), 1e-12));
    CHECK(entropy.of(corner.position) == relative(std::log(8.0), 1e-12));
    // Five spheres in a cell, about, and an even number of cells along the longest side.
    const Box long_box = space_of({16.0, 8.0, 4.0}, solid_walls);
    const PositionEntropy usual(long_box, particles, {});
    CHECK(usual.cells().count[0] == 8);
    CHECK(usual.cells().count[1] == 4);
    CHECK(usual.cells().count[2] == 2);
}

TEST_CASE("what crosses a plane, or a window in it, is counted with its energy") {
    const Box box = space_of({10.0, 10.0, 10.0}, {Wall::solid, Wall::periodic, Wall::solid});
    const auto totals = [&](const CrossedLine& line, const Sphere& one) {
        LineCrossings crossings(box, equal_spheres(1, 0.1), line, {0}, {});
        crossings.see(space_sample(0.0, {one}), {});
        Vec to = one.place + 4.0 * one.velocity;
        for (const int axis : {0, 1, 2}) to[axis] = box.wrapped(axis, to[axis]);
        return crossings.see(space_sample(4.0, {{to, one.velocity}}), {});
    };
    // Crosses z = 5 at x = 5, y = 9 + 2 - 10 = 1.
    const Sphere up{{3, 9, 4}, {1, 1, 0.5}};
    CrossedLine line{.axis = 2, .at = 5.0};
    CHECK(totals(line, up).count == std::array<std::int64_t, 2>{1, 0});
    CHECK(totals(line, up).energy[0] == relative(0.5 * 2.25, 1e-12));
    CHECK(totals(line, {{3, 9, 6}, {1, 1, -0.5}}).count == std::array<std::int64_t, 2>{0, 1});
    line.between = Gap({4.5, 0.5}, {5.5, 1.5});
    CHECK(totals(line, up).count[0] == 1);
    for (const Gap& beside : {Gap({4.5, 1.5}, {5.5, 2.5}), Gap({5.5, 0.5}, {6.5, 1.5})}) {
        line.between = beside;
        CHECK(totals(line, up).count[0] == 0);
    }
    // The same across y, whose other axes are x and z: three times around in this time.
    line = {.axis = 1, .at = 5.0, .between = Gap({3.0, 4.0}, {3.5, 5.0})};
    CHECK(totals(line, {{3.2, 4, 4.5}, {0, 7, 0}}).count[0] == 3);
    line.between = Gap({3.0, 4.6}, {3.5, 5.0});
    CHECK(totals(line, {{3.2, 4, 4.5}, {0, 7, 0}}).count[0] == 0);
}

TEST_CASE("pressures in space are momenta by area, and the virial by volume") {
    const Box box = space_of({5.0, 4.0, 3.0}, {Wall::solid, Wall::periodic, Wall::solid});
    ImpulseTotals impulses;
    impulses.wall = {6.0, 7.0, 100.0, 100.0, 8.0, 9.0};
    // The walls across x have 12 each, those across z 20 each.
    CHECK(*wall_pressure(box, impulses, 2.0) == relative(30.0 / (2.0 * 64.0), 1e-12));
    // The mean over the axes of L'_i times the area across it: radius 0.5.
    impulses.virial = 11.0;
    const double volume = (4.0 * 12.0 + 4.0 * 15.0 + 2.0 * 20.0) / 3.0;
    CHECK(*virial_pressure(box, equal_spheres(2, 0.5), 7.0, impulses, 2.0) ==
          relative((14.0 + 5.5) / (3.0 * volume), 1e-12));
    const Box whole = space_of({5.0, 4.0, 3.0}, periodic_walls);
    CHECK(*virial_pressure(whole, equal_spheres(2, 0.5), 7.0, impulses, 2.0) ==
          relative((14.0 + 5.5) / (3.0 * 60.0), 1e-12));
    CHECK_FALSE(wall_pressure(whole, impulses, 2.0));
}

TEST_CASE("averages, ways and displacements in space have three components") {
    const Box box = space_of({10.0, 10.0, 10.0}, periodic_walls);
    const Particles particles = equal_spheres(2, 0.1);
    const Sample start = space_sample(0.0, {{{1, 1, 1}, {1, 2, 2}}, {{5, 5, 5}, {-1, -2, -2}}});
    const Sample later = space_sample(7.0, {{{8, 5, 5}, {1, 2, 2}}, {{8, 1, 1}, {-1, -2, -2}}});
    TimeAverages averages(box, particles, 1, {});
    averages.see(start, {});
    averages.see(later, {});
    CHECK(averages.averages().speed[0] == relative(3.0, 1e-12));
    CHECK(averages.averages().energy[0] == relative(4.5, 1e-12));
    CHECK(averages.averages().temperature == relative(6.0, 1e-12));  // 2 * 9 / (6 - 3)
    FreeFlights flights(box, false, {});
    flights.see(start, {});
    flights.see(later, {});
    CHECK(flights.totals()[1].way == relative(21.0, 1e-12));
    Displacements displacements(box, 0.0);
    displacements(start, {});
    const Eigen::ArrayXXd moved = displacements(later, {});
    CHECK(vec_in(moved, 0) == Vec{7.0, 14.0, 14.0});
    RunStatistics statistics(box, particles, 1, 2);
    AdvanceResult advanced;
    statistics.see(space_sample(0.0, {{{1, 1, 1}, {1, 2, 3}}, {{5, 5, 5}, {1, 2, -5}}}), advanced);
    const RunSummary summary = statistics.summary(advanced);
    REQUIRE(summary.momentum_final.size() == 3);
    CHECK(*summary.momentum_final[0] == 2.0);
    CHECK(*summary.momentum_final[2] == -2.0);
    CHECK(*summary.temperature == relative(2.0 * 16.0 / 3.0, 1e-12));  // without the drift
}
