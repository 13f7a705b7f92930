// Averages over exact paths of particles: by hand, and against sums over many samples.
#include "stats/paths/paths.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>

#include "physics/gas.h"
#include "physics/theory/billiard.h"
#include "stats/pairs/bond_order.h"
#include "stats/pairs/near_pairs.h"
#include "stats/paths/free_flights.h"
#include "stats/paths/lag_averages.h"
#include "stats/paths/line_crossings.h"

using namespace carom;
using std::numbers::pi;

namespace {

Gas gas_of(std::int64_t count, Wall wall, double gravity = 0.0) {
    Gas gas;
    gas.box.size = {12.0, 9.0};
    gas.box.walls = {wall, wall};
    gas.box.surfaces.gravity = {0.0, gravity};
    gas.species = {{.name = "a", .count = count, .radius = 0.4, .velocity = Temperature{2.0}}};
    return gas;
}

// A run that is seen at some times.
template <class Seen>
void see(const Gas& gas, double until, int frames, Seen&& seen) {
    Simulation simulation(gas, Run{});
    simulation.record_collisions(true);
    for (int k = 0; k <= frames; ++k) {
        const AdvanceResult advanced = simulation.advance_to(until * k / frames);
        seen(simulation.sample(), advanced.collisions);
    }
}

std::vector<Eigen::Index> all_of(Eigen::Index count) {
    std::vector<Eigen::Index> all(static_cast<std::size_t>(count));
    std::iota(all.begin(), all.end(), 0);
    return all;
}

}  // namespace

TEST_CASE("pieces of paths follow one another without a gap, whatever the frames") {
    for (const double gravity : {0.0, -0.7}) {
        const Gas gas = gas_of(20, Wall::solid, gravity);
        Paths paths(gas.box, {});
        std::vector<PathPiece> last(20);
        int collisions = 0;
        double time = 0.0;
        see(gas, 6.0, 7, [&](const Sample& sample, std::span<const Collision> all) {
            paths(sample, all, [&](const PathPiece& piece) {
                PathPiece& before = last[static_cast<std::size_t>(piece.particle)];
                if (before.to > 0.0) {
                    const Vec end = before.place_after(before.span());
                    CHECK(piece.from == before.to);
                    CHECK(length(piece.place - end) < 1e-12);
                }
                collisions += piece.ended_by != nullptr ? 1 : 0;
                time += piece.span();
                before = piece;
            });
        });
        CHECK(collisions > 100);
        CHECK(time == doctest::Approx(20 * 6.0));
    }
}

TEST_CASE("a reversal between two samples is on the path") {
    Box box;
    box.size = {10.0, 10.0};
    Paths paths(box, {0.75});
    Sample sample{0.0, Eigen::ArrayXXd(1, 2), Eigen::ArrayXXd(1, 2)};
    sample.position << 1.0, 1.0;
    sample.velocity << 2.0, 0.0;
    std::vector<PathPiece> pieces;
    const auto keep = [&](const PathPiece& piece) { pieces.push_back(piece); };
    paths(sample, {}, keep);
    sample.time = 1.0;
    sample.position << 2.0, 1.0;  // to 2.5 and back
    sample.velocity << -2.0, 0.0;
    paths(sample, {}, keep);
    REQUIRE(pieces.size() == 2);
    CHECK(pieces[0].to == 0.75);
    CHECK(pieces[1].place[0] == doctest::Approx(2.5));
    CHECK(pieces[1].velocity[0] == -2.0);
}

TEST_CASE("a bead that runs to and fro is autocorrelated as a square wave") {
    // Speed 2 on a free length of 3: a period of 3, and <v(0) v(t)> falls linearly from 4 to -4.
    Gas gas;
    gas.box.dimension = 1;
    gas.box.size = {4.0, 0.0};
    gas.species = {{.name = "a",
                    .count = 1,
                    .radius = 0.5,
                    .velocity = Velocity{{{2.0, 0.0}}},
                    .position = Places{{{1.1, 0.0}}}}};
    LagAverages velocities(gas.box, LagAverages::Of::velocities, {{0}}, 0.0, 3.0, 13, {});
    LagAverages ways(gas.box, LagAverages::Of::displacements, {{0}}, 0.0, 3.0, 13, {});
    see(gas, 303.0, 100, [&](const Sample& sample, std::span<const Collision> collisions) {
        velocities.see(sample, collisions);
        ways.see(sample, collisions);
    });
    for (int k = 0; k <= 12; ++k) {
        const double lag = 0.25 * k, share = std::min(lag, 3.0 - lag) / 1.5;
        CHECK(velocities.lag(k) == doctest::Approx(lag));
        // Of 100 periods the last one lacks the lag.
        CHECK(velocities.averages()(0, k) ==
              doctest::Approx(4.0 * (1.0 - 2.0 * share)).epsilon(0.02));
        // For a triangle wave of height h: (2 v s)^2 (1 - 4 s / 3 h ...), integrated by hand:
        const double s = std::min(lag, 3.0 - lag);
        const double square = 4.0 * s * s * (1.0 - 4.0 * s / 9.0);
        CHECK(std::abs(ways.averages()(0, k) - square) < 0.02 * 3.0);
    }
}

TEST_CASE("averages over lags are sums over a fine grid of times") {
    for (const Wall wall : {Wall::solid, Wall::periodic}) {
        const Gas gas = gas_of(6, wall, wall == Wall::solid ? -0.5 : 0.0);
        constexpr int lags = 5, frames = 9, fine = 8000;
        constexpr double until = 5.0, from = 0.6, longest = 1.6;
        LagAverages velocities(gas.box, LagAverages::Of::velocities, {all_of(6), {2}}, from,
                               longest, lags, {});
        LagAverages ways(gas.box, LagAverages::Of::displacements, {all_of(6), {2}}, from, longest,
                         lags, {});
        see(gas, until, frames, [&](const Sample& sample, std::span<const Collision> collisions) {
            velocities.see(sample, collisions);
            ways.see(sample, collisions);
        });
        // Unwrapped by small steps.
        std::vector<Eigen::ArrayXXd> place, velocity;
        see(gas, until, fine, [&](const Sample& sample, std::span<const Collision>) {
            Eigen::ArrayXXd now = sample.position;
            if (!place.empty() && wall == Wall::periodic)
                for (int axis = 0; axis < 2; ++axis)
                    now.col(axis) -= gas.box.size[axis] *
                                     ((now - place.back()).col(axis) / gas.box.size[axis]).round();
            place.push_back(now);
            velocity.push_back(sample.velocity);
        });
        const int first = static_cast<int>(from / until * fine);
        for (int k = 0; k < lags; ++k) {
            const int steps = static_cast<int>(std::lround(velocities.lag(k) / until * fine));
            double products = 0.0, squares = 0.0, products_of_one = 0.0;
            int count = 0;
            for (int i = first; i + steps <= fine; ++i, ++count) {
                const auto one = static_cast<std::size_t>(i), other = one + std::size_t(steps);
                products += (velocity[one] * velocity[other]).sum() / 6.0;
                products_of_one += (velocity[one] * velocity[other]).row(2).sum();
                squares += (place[other] - place[one]).square().sum() / 6.0;
            }
            CAPTURE(k);
            // The grid misses a part of a step at each of some hundred collisions.
            CHECK(std::abs(velocities.averages()(0, k) - products / count) < 0.02);
            CHECK(std::abs(velocities.averages()(1, k) - products_of_one / count) < 0.05);
            CHECK(std::abs(ways.averages()(0, k) - squares / count) < 0.02);
        }
    }
}

TEST_CASE("whole flights end at collisions alone, however many samples are taken") {
    for (const double gravity : {0.0, -0.7}) {
        CAPTURE(gravity);
        const Gas gas = gas_of(20, Wall::solid, gravity);
        constexpr double until = 6.0;
        for (const int samples : {1, 7, 500}) {
            Paths paths(gas.box, {});
            int ended = 0, open = 0;
            std::int64_t hits = 0;
            double time = 0.0;
            see(gas, until, samples, [&](const Sample& sample, std::span<const Collision> all) {
                for (const Collision& one : all) hits += one.second.is_particle() ? 2 : 1;
                paths.see_whole(sample, all, [&](const PathPiece& piece) {
                    ended += piece.ended_by != nullptr ? 1 : 0;
                    open += piece.ended_by == nullptr ? 1 : 0;
                    time += piece.span();
                });
            });
            CHECK(ended == hits);
            CHECK(open == 0);
            paths.see_open([&](const PathPiece& piece) {
                CHECK(piece.to == until);
                ++open;
                time += piece.span();
            });
            CHECK(open == 20);
            CHECK(time == doctest::Approx(20 * until));
        }
    }
}

// The flights that have ended are the same to the last bit; those that go on are added at the end,
// where round-off in positions leaves a few units in the last digits.
TEST_CASE("averages over lags do not depend on the samples before") {
    for (const Wall wall : {Wall::solid, Wall::periodic})
        for (const double gravity : {0.0, -0.5}) {
            if (wall == Wall::periodic && gravity != 0.0) continue;
            const Gas gas = gas_of(12, wall, gravity);
            const auto means = [&](LagAverages::Of of, int samples) {
                LagAverages averages(gas.box, of, {all_of(12), {3}}, 0.3, 2.0, 9, {});
                see(gas, 6.0, samples, [&](const Sample& sample, std::span<const Collision> all) {
                    averages.see(sample, all);
                });
                return averages.averages();
            };
            for (const auto of : {LagAverages::Of::velocities, LagAverages::Of::displacements}) {
                const Eigen::ArrayXXd few = means(of, 2), many = means(of, 900);
                CHECK((few - many).abs().maxCoeff() <= 1e-12 * few.abs().maxCoeff());
            }
        }
}

TEST_CASE("averages over lags go on through a reversal between two samples") {
    // A bead that flies from 2 with velocity 1, is turned at 3 and is back at 6: the displacement
    // over a lag of 6 is 0, and <v(0) v(6)> is -1.
    Box box;
    box.dimension = 1;
    box.size = {20.0, 0.0};
    LagAverages ways(box, LagAverages::Of::displacements, {{0}}, 0.0, 6.0, 3, {3.0});
    LagAverages velocities(box, LagAverages::Of::velocities, {{0}}, 0.0, 6.0, 3, {3.0});
    Sample sample{0.0, Eigen::ArrayXXd(1, 1), Eigen::ArrayXXd(1, 1)};
    for (const auto& [time, place, velocity] :
         {std::array{0.0, 2.0, 1.0}, {2.0, 4.0, 1.0}, {5.0, 3.0, -1.0}, {6.0, 2.0, -1.0}}) {
        sample.time = time;
        sample.position(0, 0) = place;
        sample.velocity(0, 0) = velocity;
        ways.see(sample, {});
        velocities.see(sample, {});
    }
    // The last lag has one pair of times only, whose integral has no length.
    CHECK(velocities.averages()(0, 0) == doctest::Approx(1.0));
    // Over a lag of 3: both ends before the reversal never; (t, t + 3) has v v' = -1.
    CHECK(velocities.averages()(0, 1) == doctest::Approx(-1.0));
    // From t to t + 3 it moves 3 - t forward and t back: the mean of (3 - 2 t)^2 is 3.
    CHECK(ways.averages()(0, 1) == doctest::Approx(3.0));
}

TEST_CASE("lags that the run has not come to are unknown") {
    const Gas gas = gas_of(3, Wall::solid);
    LagAverages averages(gas.box, LagAverages::Of::velocities, {{0}}, 1.0, 4.0, 5, {});
    see(gas, 3.5, 3, [&](const Sample& sample, std::span<const Collision> collisions) {
        averages.see(sample, collisions);
    });
    CHECK(std::isfinite(averages.averages()(0, 2)));
    CHECK(std::isnan(averages.averages()(0, 3)));
}

TEST_CASE("free flights add up to the whole path, and their mean is way over collisions") {
    const Gas gas = gas_of(20, Wall::solid);
    for (const bool ends_at_walls : {false, true}) {
        FreeFlights flights(gas.box, ends_at_walls, {});
        FlightTotals all;
        double lengths = 0.0, durations = 0.0, way = 0.0;
        std::size_t ended = 0;
        std::int64_t pairs = 0, walls = 0;
        see(gas, 30.0, 11, [&](const Sample& sample, std::span<const Collision> collisions) {
            for (const FreeFlight& flight : flights.see(sample, collisions)) {
                lengths += flight.length;
                durations += flight.duration;
                ++ended;
            }
            for (const FlightTotals& one : flights.totals()) {
                all.collisions += one.collisions;
                all.way += one.way;
                all.time += one.time;
            }
            for (const Collision& one : collisions) ++(one.second.is_particle() ? pairs : walls);
        });
        Simulation whole(gas, Run{});
        way = 30.0 * speeds(whole.sample()).sum();  // but speeds change in pair collisions
        CHECK(all.time == doctest::Approx(20 * 30.0));
        CHECK(all.way == doctest::Approx(way).epsilon(0.1));
        CHECK(all.collisions == double(2 * pairs + (ends_at_walls ? walls : 0)));
        CHECK(double(ended) == all.collisions - 20.0);
        // All but the first and the last flight of each particle, which are no longer than others.
        CHECK(lengths < all.way);
        CHECK(lengths > all.way * (1.0 - 6.0 * 20.0 / all.collisions));
        CHECK(durations < all.time);
    }
}

TEST_CASE("a falling ball's way is the length of its parabola") {
    // Thrown along x at 1 with gravity 1 for a time of 2: the arc of y = x^2 / 2 up to 2.
    const double exact = 0.5 * (2.0 * std::sqrt(5.0) + std::asinh(2.0));
    CHECK(length_of_way({1.0, -1.0}, {0.0, -1.0}, 2.0) == doctest::Approx(exact).epsilon(1e-12));
    CHECK(length_of_way({3.0, 4.0}, {0.0, 0.0}, 2.0) == 10.0);
}

TEST_CASE("the mean free path of a billiard is pi area over perimeter") {
    Box box;
    box.size = {4.0, 4.0};
    box.walls = {Wall::periodic, Wall::periodic};
    const auto disk_at = [](double x, double y, double radius) {
        return Obstacle{"peg", Obstacle::Ball{{x, y}, radius}};
    };
    box.surfaces.obstacles = {disk_at(2.0, 2.0, 1.0)};
    // Sinai's: (L^2 - pi R^2) / 2 R.
    CHECK(*mean_path_of_billiard(box, 0.0, false) == doctest::Approx((16.0 - pi) / 2.0));
    CHECK(*mean_path_of_billiard(box, 0.5, false) == doctest::Approx((16.0 - pi * 2.25) / 3.0));
    box.surfaces.obstacles.push_back(disk_at(0.2, 0.2, 1.0));
    CHECK(mean_path_of_billiard(box, 0.0, false).has_value());
    CHECK_FALSE(mean_path_of_billiard(box, 0.5, false).has_value());  // it cannot pass between
    box.surfaces.obstacles.clear();
    CHECK_FALSE(mean_path_of_billiard(box, 0.0, false).has_value());
    box.walls = {Wall::solid, Wall::solid};
    CHECK_FALSE(mean_path_of_billiard(box, 0.5, false).has_value());
    CHECK(*mean_path_of_billiard(box, 0.5, true) == doctest::Approx(pi * 9.0 / 12.0));
    box.surfaces.gravity = {0.0, -1.0};
    CHECK_FALSE(mean_path_of_billiard(box, 0.5, true).has_value());
}

TEST_CASE("a disk among fixed disks has Sinai's mean free path") {
    Gas gas;
    gas.box.size = {2.0, 2.0};
    gas.box.walls = {Wall::periodic, Wall::periodic};
    gas.box.surfaces.obstacles = {{"peg", Obstacle::Ball{{1.0, 1.0}, 0.5}}};
    gas.species = {{.name = "a",
                    .count = 1,
                    .radius = 0.1,
                    .velocity = Velocity{{{0.8, 0.6}}},
                    .position = Places{{{0.2, 0.3}}}}};
    FreeFlights flights(gas.box, false, {});
    double way = 0.0, hits = 0.0;
    see(gas, 40000.0, 10, [&](const Sample& sample, std::span<const Collision> collisions) {
        flights.see(sample, collisions);
        way += flights.totals()[0].way;
        hits += flights.totals()[0].collisions;
    });
    CHECK(way == doctest::Approx(40000.0));
    // Its long flights between the rows leave an error of a few per cent.
    CHECK(way / hits == doctest::Approx(*mean_path_of_billiard(gas.box, 0.1, false)).epsilon(0.03));
}

TEST_CASE("pairs are near neighbours, each seen once") {
    for (const Wall wall : {Wall::solid, Wall::periodic})
        for (const double distance : {0.3, 1.0, 2.6, 7.0}) {
            const Gas gas = gas_of(40, wall);
            const Simulation simulation(gas, Run{});
            const Eigen::ArrayXXd place = Simulation(simulation).sample().position;
            Eigen::ArrayXXi seen = Eigen::ArrayXXi::Zero(40, 40);
            NearPairs(gas.box, place, distance).for_each([&](Eigen::Index i, Eigen::Index j) {
                CHECK(i < j);
                ++seen(i, j);
            });
            CHECK(seen.maxCoeff() <= 1);
            for (Eigen::Index i = 0; i < 40; ++i)
                for (Eigen::Index j = i + 1; j < 40; ++j) {
                    const Vec apart =
                        gas.box.nearest({place(j, 0) - place(i, 0), place(j, 1) - place(i, 1)});
                    if (length(apart) <= distance) CHECK(seen(i, j) == 1);
                }
        }
}

TEST_CASE("a hexagonal lattice has the order 1, a square one 0, a turned one its angle") {
    const auto order_of = [](const Vec& a, const Vec& b, double turn) {
        // A patch of a lattice in a wide box; only disks with all neighbours are looked at.
        Box box;
        box.size = {100.0, 100.0};
        Eigen::ArrayXXd place(49, 2);
        Eigen::Index inner = 0;
        for (int i = 0; i < 7; ++i)
            for (int k = 0; k < 7; ++k) {
                const Vec at = (i - 3) * a + (k - 3) * b;
                place.row(7 * i + k) << 50.0 + at[0] * std::cos(turn) - at[1] * std::sin(turn),
                    50.0 + at[0] * std::sin(turn) + at[1] * std::cos(turn);
                if (i == 3 && k == 3) inner = 7 * i + k;
            }
        const Particles particles{Eigen::ArrayXd::Constant(49, 0.5), Eigen::ArrayXd::Ones(49),
                                  Eigen::ArrayXi::Zero(49)};
        return bond_order(box, particles, place)(inner, 0);
    };
    const Vec east{1.1, 0.0}, up{0.55, 0.55 * std::sqrt(3.0)}, north{0.0, 1.1};
    CHECK(std::abs(order_of(east, up, 0.0) - 1.0) < 1e-12);
    CHECK(std::abs(order_of(east, up, 0.1) - std::polar(1.0, 0.6)) < 1e-12);
    CHECK(std::abs(order_of(east, north, 0.3)) < 1e-12);  // four neighbours: 1 - 1 + 1 - 1
    CHECK(std::abs(order_of(1.5 * east, 1.5 * north, 0.0)) == 0.0);  // none within 1.4
}

TEST_CASE("what crosses a line one way less what comes back is the change of what is beyond it") {
    // Centres turn back at 0.4 from the floor, but for round-off exactly on the line.
    for (const double at : {0.4, 4.5}) {
        CAPTURE(at);
        const Gas gas = gas_of(20, Wall::solid, -0.7);
        Simulation simulation(gas, Run{});
        const Particles particles = simulation.particles();
        LineCrossings crossings(gas.box, particles, {.axis = 1, .at = at}, all_of(20), {});
        const auto beyond = [&](const Sample& sample) {
            return (sample.position.col(1) > at).count();
        };
        std::optional<Eigen::Index> begun;
        std::int64_t most = 0;
        see(gas, 200.0, 50, [&](const Sample& sample, std::span<const Collision> all) {
            const auto [up, down] = crossings.see(sample, all).count;
            if (!begun) begun = beyond(sample);
            CHECK(up - down == beyond(sample) - *begun);
            most = up;
        });
        if (at > 1.0) CHECK(most > 100);
    }
}
