// g(r): rings by hand and by sums over points, times at a distance by hand and over many samples.
#include "stats/pairs/pair_correlation.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "physics/gas.h"
#include "physics/simulation.h"

using namespace carom;
using std::numbers::pi;

namespace {

Box box_of(double width, double height, Wall across_x, Wall across_y) {
    Box box;
    box.size = {width, height};
    box.walls = {across_x, across_y};
    return box;
}

Particles particles_of(const std::vector<double>& radii) {
    const auto n = static_cast<Eigen::Index>(radii.size());
    return {Eigen::Map<const Eigen::ArrayXd>(radii.data(), n), Eigen::ArrayXd::Ones(n),
            Eigen::ArrayXi::Zero(n)};
}

Sample sample_of(double time, const std::vector<std::array<double, 4>>& rows) {
    const auto n = static_cast<Eigen::Index>(rows.size());
    Sample sample{time, Eigen::ArrayXXd(n, 2), Eigen::ArrayXXd(n, 2)};
    for (Eigen::Index i = 0; i < n; ++i) {
        const auto& row = rows[static_cast<std::size_t>(i)];
        sample.position.row(i) << row[0], row[1];
        sample.velocity.row(i) << row[2], row[3];
    }
    return sample;
}

}  // namespace

TEST_CASE("rings in a solid box are known in closed form, in a periodic one whole") {
    // All directions of a distance r in a rectangle a x b: r (2 pi a b - 4 (a + b) r + 2 r^2).
    const auto solid = [](double a, double b, double low, double high) {
        const auto whole = [&](double r) {
            return pi * a * b * r * r - 4.0 / 3.0 * (a + b) * r * r * r + 0.5 * r * r * r * r;
        };
        return (whole(high) - whole(low)) / (a * a * b * b);
    };
    const Box box = box_of(7.0, 5.0, Wall::solid, Wall::solid);
    for (const auto& [low, high] : {std::pair{0.0, 0.2}, {1.0, 1.1}, {3.3, 3.9}})
        CHECK(ring_probability(box, sides_of(box), {0.5, 0.5}, low, high) ==
              doctest::Approx(solid(6.0, 4.0, low, high)).epsilon(1e-9));
    const Box ring = box_of(7.0, 5.0, Wall::periodic, Wall::periodic);
    CHECK(ring_probability(ring, sides_of(ring), {0.5, 0.5}, 1.0, 2.0) ==
          doctest::Approx(pi * 3.0 / 35.0).epsilon(1e-12));
    // All distances there are.
    double all = 0.0;
    for (int k = 0; k < 800; ++k)
        all += ring_probability(box, sides_of(box), {0.5, 1.0}, 0.01 * k, 0.01 * (k + 1));
    CHECK(all == doctest::Approx(1.0).epsilon(1e-5));
    Box line;
    line.dimension = 1;
    line.size = {5.0, 0.0};
    CHECK(ring_probability(line, sides_of(line), {0.5, 0.5}, 1.0, 2.0) ==
          doctest::Approx((2.0 * 4.0 - 3.0) / 16.0));
}

TEST_CASE("rings between disks of two sizes are those of random points") {
    const Box box = box_of(6.0, 4.0, Wall::solid, Wall::periodic);
    const std::pair<double, double> radii{0.2, 1.1};
    std::mt19937_64 random(7);
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
    };
    constexpr int draws = 400'000, rings = 10;
    std::array<double, rings> counts{};
    for (int k = 0; k < draws; ++k) {
        const double x = uniform(0.2, 5.8) - uniform(1.1, 4.9);
        double y = uniform(0.0, 4.0) - uniform(0.0, 4.0);
        y -= 4.0 * std::round(y / 4.0);
        const double r = std::hypot(x, y);
        if (r < 2.0) counts[static_cast<std::size_t>(r / 0.2)] += 1.0;
    }
    for (int k = 0; k < rings; ++k) {
        const double expected =
            draws * ring_probability(box, sides_of(box), radii, 0.2 * k, 0.2 * (k + 1));
        CAPTURE(k);
        CHECK(std::abs(counts[static_cast<std::size_t>(k)] - expected) < 4.5 * std::sqrt(expected));
    }
}

TEST_CASE("two disks that pass each other are at each distance as long as it takes") {
    const Box box = box_of(100.0, 100.0, Wall::periodic, Wall::periodic);
    PairCorrelation pairs(box, particles_of({0.1, 0.1}), {.to = 5.0, .rings = 5}, {});
    // Past each other at a distance of 3, with relative velocity 2, from x = -4 to 4.
    pairs.see(sample_of(0.0, {{50.0, 50.0, 1.0, 0.0}, {54.0, 53.0, -1.0, 0.0}}), {}, sides_of(box));
    pairs.see(sample_of(4.0, {{54.0, 50.0, 1.0, 0.0}, {50.0, 53.0, -1.0, 0.0}}), {}, sides_of(box));
    const Eigen::ArrayXd g = pairs.values();
    const double nearer = 2.0 * std::sqrt(16.0 - 9.0) / 2.0;  // than 4
    const double in_4_of_points = 4.0 * pi * (16.0 - 9.0) / 1e4;
    const double in_5_of_points = 4.0 * pi * (25.0 - 16.0) / 1e4;
    CHECK(g.head(3).maxCoeff() == 0.0);
    CHECK(g[3] == doctest::Approx(nearer / in_4_of_points));
    CHECK(g[4] == doctest::Approx((4.0 - nearer) / in_5_of_points));
}

TEST_CASE("through a periodic side the image counts that comes near") {
    const Box box = box_of(10.0, 10.0, Wall::periodic, Wall::periodic);
    PairCorrelation pairs(box, particles_of({0.1, 0.1}), {.to = 4.0, .rings = 4}, {});
    // At a distance of 3.5 to the right in the beginning, moved by a box in a time of 1: until the
    // nearest is the next image at 3.5.
    pairs.see(sample_of(0.0, {{1.0, 5.0, 0.0, 0.0}, {4.5, 5.0, 10.0, 0.0}}), {}, sides_of(box));
    pairs.see(sample_of(1.0, {{1.0, 5.0, 0.0, 0.0}, {4.5, 5.0, 10.0, 0.0}}), {}, sides_of(box));
    const Eigen::ArrayXd g = pairs.values();
    for (int k = 0; k < 4; ++k)  // a length of 1 on either side, each passed in 0.1
        CHECK(g[k] == doctest::Approx(0.2 / (pi * (2.0 * k + 1.0) / 100.0)));
}

TEST_CASE("a lattice has its neighbours at their distances, and only there") {
    const Box box = box_of(8.0, 8.0, Wall::periodic, Wall::periodic);
    std::vector<std::array<double, 4>> rows;
    for (int i = 0; i < 8; ++i)
        for (int k = 0; k < 8; ++k) rows.push_back({i + 0.5, k + 0.5, 0.3, 0.1});
    const Particles particles = particles_of(std::vector<double>(64, 0.2));
    for (const std::optional<double> window : {std::optional<double>{}, std::optional(0.0)}) {
        PairCorrelation pairs(box, particles, {.to = 2.5, .rings = 25, .window = window}, {});
        pairs.see(sample_of(0.0, rows), {}, sides_of(box));
        std::vector<std::array<double, 4>> later = rows;
        for (auto& row : later) {
            row[0] = box.wrapped(0, row[0] + 0.3);
            row[1] = box.wrapped(1, row[1] + 0.1);
        }
        pairs.see(sample_of(1.0, later), {}, sides_of(box));
        const Eigen::ArrayXd g = pairs.values();
        // Four neighbours at 1, four at sqrt 2, four at 2, eight at sqrt 5, of 63.
        for (int k = 0; k < 25; ++k) {
            const double low = 0.1 * k, high = low + 0.1;
            double there = 0.0;
            for (const auto& [distance, count] :
                 {std::pair{1.0, 4.0}, {std::sqrt(2.0), 4.0}, {2.0, 4.0}, {std::sqrt(5.0), 8.0}})
                if (distance > low - 1e-9 && distance < high - 1e-9) there += count;
            CAPTURE(k);
            // Distances of exactly 1 and 2 lie on the border of two rings.
            if (k == 9 || k == 10 || k == 19 || k == 20) continue;
            CHECK(g[k] == doctest::Approx(there / (63.0 * pi * (high * high - low * low) / 64.0)));
        }
        const auto pairs_in = [&](int k) {
            return g[k] * 63.0 * pi * 0.01 * (2.0 * k + 1.0) / 64.0;
        };
        CHECK(pairs_in(9) + pairs_in(10) == doctest::Approx(4.0));
        CHECK(pairs_in(19) + pairs_in(20) == doctest::Approx(4.0));
    }
}

TEST_CASE("points have a g of 1, whatever the walls, gravity aside") {
    for (const Wall wall : {Wall::solid, Wall::periodic}) {
        Gas gas;
        gas.box = box_of(6.0, 5.0, wall, Wall::solid);
        gas.species = {{.name = "a", .count = 40, .radius = 0.0, .velocity = Temperature{1.0}}};
        PairCorrelation pairs(gas.box, particles_of(std::vector<double>(40, 0.0)),
                              {.to = 2.5, .rings = 5}, {});
        Simulation simulation(gas, Run{});
        simulation.record_collisions(true);
        for (int k = 0; k <= 1000; ++k) {
            const AdvanceResult advanced = simulation.advance_to(5.0 * k);
            pairs.see(simulation.sample(), advanced.collisions, sides_of(gas.box));
        }
        // Paths of points in a box are ergodic in places, each at its own speed.
        for (const double value : pairs.values())
            CHECK(value == doctest::Approx(1.0).epsilon(0.02));
    }
}

TEST_CASE("times at a distance are sums over a fine grid of moments") {
    for (const auto& [wall, gravity] :
         {std::pair{Wall::solid, -0.6}, {Wall::periodic, 0.0}, {Wall::solid, 0.0}}) {
        Gas gas;
        gas.box = box_of(6.0, 5.0, wall, wall);
        gas.box.surfaces.gravity = {0.0, gravity};
        gas.species = {{.name = "a", .count = 6, .radius = 0.4, .velocity = Temperature{2.0}},
                       {.name = "b", .count = 5, .radius = 0.2, .velocity = Temperature{2.0}}};
        Simulation coarse(gas, Run{}), fine(gas, Run{});
        const Particles particles = coarse.particles();
        PairCorrelation::Wanted wanted{.to = 2.4, .rings = 6};
        for (const int species : particles.species) {
            wanted.first.push_back(species == 0);
            wanted.second.push_back(true);
        }
        PairCorrelation pairs(gas.box, particles, wanted, {});
        coarse.record_collisions(true);
        for (int k = 0; k <= 5; ++k) {
            const AdvanceResult advanced = coarse.advance_to(k);
            pairs.see(coarse.sample(), advanced.collisions, sides_of(gas.box));
        }
        constexpr int steps = 20'000;
        Eigen::ArrayXd counts = Eigen::ArrayXd::Zero(6);
        for (int k = 0; k < steps; ++k) {
            fine.advance_to(5.0 * (k + 0.5) / steps);
            const Eigen::ArrayXXd& place = fine.sample().position;
            for (Eigen::Index i = 0; i < 11; ++i)
                for (Eigen::Index j = i + 1; j < 11; ++j) {
                    if (particles.species[i] != 0 && particles.species[j] != 0) continue;
                    const double r = length(gas.box.nearest(vec_in(place, j) - vec_in(place, i)));
                    if (r < 2.4) counts[static_cast<Eigen::Index>(r / 0.4)] += 1.0 / steps;
                }
        }
        const Eigen::ArrayXd g = pairs.values();
        for (Eigen::Index k = 0; k < 6; ++k) {
            const auto points = [&](double a, double b) {
                return ring_probability(gas.box, sides_of(gas.box), {a, b}, 0.4 * double(k),
                                        0.4 * double(k + 1));
            };
            const double expected = 15.0 * points(0.4, 0.4) + 30.0 * points(0.4, 0.2);
            CAPTURE(k);
            CHECK(std::abs(g[k] * expected - counts[k]) < 1e-3);
        }
    }
}

// Work is counted in relative flights. Cut at every frame, it would grow a hundredfold.
TEST_CASE("neither the pair correlation nor the work for it depends on the number of frames") {
    for (const Wall wall : {Wall::solid, Wall::periodic}) {
        CAPTURE(wall);
        Gas gas;
        gas.box = box_of(24.0, 20.0, wall, wall);
        gas.species = {{.name = "a", .count = 120, .radius = 0.4, .velocity = Temperature{1.0}}};
        struct Seen {
            Eigen::ArrayXd g;
            double flights;
        };
        const auto seen = [&](int frames) {
            Simulation simulation(gas, Run{});
            simulation.record_collisions(true);
            PairCorrelation pairs(gas.box, simulation.particles(), {.to = 4.0, .rings = 20}, {});
            for (int k = 0; k <= frames; ++k) {
                const AdvanceResult advanced = simulation.advance_to(20.0 * k / frames);
                pairs.see(simulation.sample(), advanced.collisions, sides_of(gas.box));
            }
            return Seen{pairs.values(), pairs.flights_added()};
        };
        const Seen one = seen(1), few = seen(300), many = seen(30'000);
        CHECK((few.g - one.g).abs().maxCoeff() < 1e-10);
        CHECK((many.g - one.g).abs().maxCoeff() < 1e-10);
        CHECK(one.flights > 1000.0);
        CHECK(few.flights < 1.5 * one.flights);
        CHECK(many.flights < 1.5 * one.flights);
        CHECK(one.flights < 1.5 * many.flights);
    }
}

TEST_CASE("a window forgets, and sides that move take their points with them") {
    const Box box = box_of(100.0, 100.0, Wall::solid, Wall::solid);
    PairCorrelation pairs(box, particles_of({0.0, 0.0}), {.to = 4.0, .rings = 2, .window = 3.2},
                          {});
    BoxSides sides = sides_of(box);
    for (int k = 0; k <= 20; ++k) {  // 1 apart until 10, then 3
        const double apart = k <= 10 ? 1.0 : 3.0;
        if (k > 10) sides[0].second = 50.0;
        pairs.see(sample_of(k, {{10.0, 50.0, 0.0, 0.0}, {10.0 + apart, 50.0, 0.0, 0.0}}), {},
                  sides);
    }
    CHECK(pairs.values()[0] == 0.0);
    CHECK(pairs.values()[1] ==
          doctest::Approx(1.0 / ring_probability(box, sides, {0.0, 0.0}, 2.0, 4.0)));
}

TEST_CASE("pairs are of the particles that are chosen at the time") {
    const Box box = box_of(20.0, 20.0, Wall::solid, Wall::solid);
    const Particles particles = particles_of({0.5, 0.5, 0.5});
    const std::vector<bool> one{true, false, false}, second{false, true, false},
        third{false, false, true};
    // From the first particle the second is 2 away, the third 4; all rest.
    const auto at = [](double time) {
        return sample_of(time, {{8, 10, 0, 0}, {10, 10, 0, 0}, {12, 10, 0, 0}});
    };
    const auto see = [&](const std::vector<bool>& of, std::optional<double> window, bool changes) {
        PairCorrelation pairs(box, particles,
                              {.first = one, .second = of, .to = 5.0, .rings = 5, .window = window},
                              {});
        for (const double time : {0.0, 1.0, 2.0, 3.0, 4.0}) {
            pairs.see(at(time), {}, sides_of(box));
            if (time != 1.0 || !changes) continue;
            pairs.choose(one, third);
            pairs.see(at(time), {}, sides_of(box));
        }
        return pairs.values();
    };
    const std::optional<double> all, moment = 0.0;
    const Eigen::ArrayXd near = see(second, all, false), far = see(third, all, false);
    CHECK(near[2] > 0.0);
    CHECK(near[4] == 0.0);
    CHECK(see(second, moment, true).isApprox(far));
    CHECK(see(second, all, true).isApprox(0.25 * near + 0.75 * far));
    CHECK(see(second, 2.0, true).isApprox(far));
}
