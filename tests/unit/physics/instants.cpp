// Contacts that coincide: what they do does not depend on the numbers of the particles, and energy
// and momentum are conserved.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <vector>

#include "physics/box.h"
#include "physics/events/contact_rounds.h"
#include "physics/events/event_loop.h"
#include "physics/particles.h"

using namespace carom;

namespace {

struct Ball {
    double x, y, vx, vy, radius = 1.0, inverse_mass = 1.0;
};

struct Outcome {
    std::vector<Vec> v;  // in the order given
    CollisionCounts counts;
    std::optional<double> one_way;
    std::vector<Collision> collisions;
};

template <int dimension, class Scalar, bool has_surfaces>
Outcome outcome_of(const Box& box, const std::vector<Ball>& balls,
                   const std::vector<std::size_t>& order, double end) {
    const auto count = static_cast<Eigen::Index>(balls.size());
    Particles particles{Eigen::ArrayXd(count), Eigen::ArrayXd(count), Eigen::ArrayXi::Zero(count)};
    Sample start{0.0, Eigen::ArrayXXd(count, dimension), Eigen::ArrayXXd(count, dimension)};
    for (Eigen::Index i = 0; i < count; ++i) {
        const Ball& ball = balls[order[static_cast<std::size_t>(i)]];
        particles.radius[i] = ball.radius;
        particles.inverse_mass[i] = ball.inverse_mass;
        start.position(i, 0) = ball.x;
        start.velocity(i, 0) = ball.vx;
        if constexpr (dimension == 2) {
            start.position(i, 1) = ball.y;
            start.velocity(i, 1) = ball.vy;
        }
    }
    const int bits = std::is_same_v<Scalar, double> ? 53 : 200;
    EventLoop<dimension, Scalar, has_surfaces> loop(box, particles, {.bits = bits});
    loop.start(start);
    Outcome outcome;
    loop.advance(end, &outcome.collisions);
    Sample now;
    loop.sample(end, now);
    outcome.v.resize(balls.size(), Vec());
    for (Eigen::Index i = 0; i < count; ++i)
        for (int axis = 0; axis < dimension; ++axis)
            outcome.v[order[static_cast<std::size_t>(i)]][axis] = now.velocity(i, axis);
    outcome.counts = loop.counts();
    outcome.one_way = loop.one_way();
    return outcome;
}

// In all orders of up to five balls, or in some; in doubles and in many bits; in loops for plain
// and for other boxes.
template <int dimension, class See>
void in_all_ways(const Box& box, const std::vector<Ball>& balls, double end, const See& see) {
    std::vector<std::size_t> order(balls.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    int done = 0;
    do {
        CAPTURE(done);
        const bool is_plain = box.surfaces.are_plain();
        if (is_plain) see(outcome_of<dimension, double, false>(box, balls, order, end));
        see(outcome_of<dimension, double, true>(box, balls, order, end));
        if (done % 7 == 0) {
            if (is_plain) see(outcome_of<dimension, Real, false>(box, balls, order, end));
            see(outcome_of<dimension, Real, true>(box, balls, order, end));
        }
    } while (std::ranges::next_permutation(order).found && ++done < 120);
}

double energy(const std::vector<Ball>& balls, const std::vector<Vec>& v) {
    double sum = 0.0;
    for (std::size_t i = 0; i < balls.size(); ++i)
        if (balls[i].inverse_mass > 0.0) sum += square(v[i]) / balls[i].inverse_mass;
    return 0.5 * sum;
}

Vec momentum(const std::vector<Ball>& balls, const std::vector<Vec>& v) {
    Vec sum;
    for (std::size_t i = 0; i < balls.size(); ++i) sum += v[i] / balls[i].inverse_mass;
    return sum;
}

void is_velocity(const Vec& v, double x, double y) {
    CHECK(std::abs(v[0] - x) < 1e-13);
    CHECK(std::abs(v[1] - y) < 1e-13);
}

Box plane(double width = 40.0, double height = 20.0) {
    return {2, {width, height}, {Wall::solid, Wall::solid}};
}
Box line() { return {1, {40.0, 0.0}, {Wall::solid, Wall::solid}}; }

}  // namespace

TEST_CASE("a disk that meets two touching ones at once is mirrored by neither") {
    const std::vector<Ball> balls{{5, 10, 1, 0}, {20, 11, 0, 0}, {20, 9, 0, 0}};
    const double root = std::sqrt(3.0) / 5.0;
    in_all_ways<2>(plane(), balls, 15.0, [&](const Outcome& found) {
        is_velocity(found.v[0], -0.2, 0.0);
        is_velocity(found.v[1], 0.6, root);
        is_velocity(found.v[2], 0.6, -root);
        CHECK(found.counts.particle == 2);
        CHECK(found.counts.ties.instants == 1);
        CHECK(found.counts.ties.contacts == 2);
        CHECK(found.counts.ties.first == doctest::Approx(15.0 - std::sqrt(3.0)));
        REQUIRE(found.one_way.has_value());
        CHECK(*found.one_way == doctest::Approx(15.0 - std::sqrt(3.0)));
        REQUIRE(found.collisions.size() == 2);
    });
}

TEST_CASE("a disk aimed at the middle of two posts comes straight back") {
    for (const double apart : {1.0, 0.25}) {  // with normals at more, and at less, than 60 degrees
        const std::vector<Ball> posts{
            {5, 10, 1, 0}, {20, 10 + apart, 0, 0, apart, 0.0}, {20, 10 - apart, 0, 0, apart, 0.0}};
        in_all_ways<2>(plane(), posts, 15.5, [&](const Outcome& found) {
            is_velocity(found.v[0], -1.0, 0.0);
            CHECK(!found.one_way);
        });
        Box obstacles = plane();
        for (const double side : {1.0, -1.0})
            obstacles.surfaces.obstacles.push_back(
                {.name = side > 0.0 ? "above" : "below",
                 .shape = Obstacle::Ball{{20.0, 10.0 + side * apart}, apart}});
        in_all_ways<2>(obstacles, {{5, 10, 1, 0}}, 15.5, [&](const Outcome& found) {
            is_velocity(found.v[0], -1.0, 0.0);
            CHECK(found.counts.ties.contacts == 2);
        });
    }
}

TEST_CASE("beads that meet at once") {
    in_all_ways<1>(line(), {{10, 0, 1, 0}, {15, 0, 0, 0, 1, 0.5}, {20, 0, -1, 0}}, 4.0,
                   [](const Outcome& found) {
                       is_velocity(found.v[0], -1.0, 0.0);
                       is_velocity(found.v[1], 0.0, 0.0);
                       is_velocity(found.v[2], 1.0, 0.0);
                       CHECK(found.counts.ties.instants == 1);
                       CHECK(!found.one_way);
                   });
    in_all_ways<1>(line(), {{10, 0, 2, 0}, {16, 0, 0, 0}, {20, 0, -1, 0}}, 3.0,
                   [](const Outcome& found) {
                       CHECK(found.v[0][0] == -1.0);
                       CHECK(found.v[1][0] == 0.0);
                       CHECK(found.v[2][0] == 2.0);
                       CHECK(found.counts.particle == 3);
                       CHECK(!found.one_way);
                   });
}

TEST_CASE("the last bead of a cradle of touching ones flies off") {
    const std::vector<Ball> cradle{
        {5, 0, 1, 0}, {20, 0, 0, 0}, {22, 0, 0, 0}, {24, 0, 0, 0}, {26, 0, 0, 0}};
    const auto see = [](const Outcome& found) {
        for (std::size_t i = 0; i < 4; ++i) is_velocity(found.v[i], 0.0, 0.0);
        is_velocity(found.v[4], 1.0, 0.0);
        CHECK(found.counts.particle == 4);
        CHECK(found.counts.ties.instants == 1);
        CHECK(found.counts.ties.contacts == 4);
        CHECK(!found.one_way);
    };
    in_all_ways<1>(line(), cradle, 16.0, see);
    std::vector<Ball> disks = cradle;
    for (Ball& ball : disks) ball.y = 10.0;
    in_all_ways<2>(plane(), disks, 16.0, see);
    // two fly off if two come, also if these do not touch
    in_all_ways<1>(line(), {{5, 0, 1, 0}, {8, 0, 1, 0}, {20, 0, 0, 0}, {22, 0, 0, 0}}, 20.0,
                   [](const Outcome& found) {
                       is_velocity(found.v[1], 0.0, 0.0);
                       is_velocity(found.v[2], 1.0, 0.0);
                       is_velocity(found.v[3], 1.0, 0.0);
                   });
}

TEST_CASE("two disks that hit the ends of a row at once do so before the row passes it on") {
    std::vector<Ball> balls{{5, 10, 1, 0},
                            {15, 10, 0, 0, 1, 0.5},
                            {17, 10, 0, 0, 1, 0.25},
                            {19, 10, 0, 0, 1, 0.5},
                            {29, 10, -1, 0}};
    in_all_ways<2>(plane(), balls, 8.5, [&](const Outcome& found) {
        CHECK(found.v[0][0] == doctest::Approx(-found.v[4][0]).epsilon(1e-14));
        CHECK(found.v[1][0] == doctest::Approx(-found.v[3][0]).epsilon(1e-14));
        is_velocity(found.v[2], 0.0, 0.0);
        CHECK(energy(balls, found.v) == doctest::Approx(1.0).epsilon(1e-14));
    });
}

TEST_CASE("seven packed disks have twelve contacts of rank eleven") {
    std::vector<Ball> balls{{0, 0, 0, 0}};
    for (int k = 0; k < 6; ++k) {
        const double angle = k * std::numbers::pi / 3.0;
        const double x = 2.0 * std::cos(angle), y = 2.0 * std::sin(angle);
        // all rush inwards, with different speeds
        balls.push_back({x, y, -(1.0 + 0.1 * k) * x, -(1.0 + 0.1 * k) * y});
    }
    using Rounds = ContactRounds<double, 2>;
    std::vector<Rounds::Participant> all;
    std::vector<Rounds::Contact> contacts;
    for (const Ball& ball : balls) all.push_back({{ball.vx, ball.vy}, {1.0, 1.0}});
    for (std::size_t i = 0; i < 7; ++i)
        for (std::size_t j = i + 1; j < 7; ++j) {
            const double x = balls[j].x - balls[i].x, y = balls[j].y - balls[i].y;
            const double distance = std::hypot(x, y);
            if (distance < 2.1) contacts.push_back({i, j, {x / distance, y / distance}});
        }
    REQUIRE(contacts.size() == 12);
    const auto after = [&](const std::vector<Rounds::Contact>& in_order) {
        Rounds rounds(all, in_order, 53);
        std::vector<double> before;
        for (std::size_t c = 0; c < 12; ++c) before.push_back(rounds.opening_speed(c));
        REQUIRE(std::ranges::count_if(before, [](double v) { return v < -1e-9; }) == 12);
        REQUIRE(rounds.run());
        CHECK(rounds.hits().size() == 12);
        for (std::size_t c = 0; c < 12; ++c)  // each contact is reflected, none left out
            CHECK(rounds.opening_speed(c) == doctest::Approx(-before[c]).epsilon(1e-12));
        std::vector<Vec> v;
        for (const auto& one : rounds.participants()) v.push_back({one.v[0], one.v[1]});
        CHECK(rounds.lead_back_to(all));
        return v;
    };
    const auto v = after(contacts);
    std::vector<Vec> start;
    for (const Ball& ball : balls) start.push_back({ball.vx, ball.vy});
    CHECK(energy(balls, v) == doctest::Approx(energy(balls, start)).epsilon(1e-14));
    CHECK(longest(abs(momentum(balls, v) - momentum(balls, start)), 2) < 1e-14);
    for (int turns = 1; turns < 12; ++turns) {
        std::ranges::rotate(contacts, contacts.begin() + 5);
        const auto again = after(contacts);
        for (std::size_t i = 0; i < 7; ++i) CHECK(longest(abs(v[i] - again[i]), 2) < 1e-13);
    }
}

TEST_CASE("a disk that meets a wall and another disk at once") {
    // at the left wall at time 4, when the other is 6 beside and 8 above it
    const std::vector<Ball> balls{{9, 10, -1, 0, 5.0}, {15, 22, -1, -1, 5.0, 0.5}};
    const Box box = plane(40.0, 40.0);
    std::optional<Outcome> first;
    in_all_ways<2>(box, balls, 4.5, [&](const Outcome& found) {
        if (!first) first = found;
        CHECK(found.counts.ties.instants == 1);
        CHECK(energy(balls, found.v) == doctest::Approx(2.5).epsilon(1e-14));
        for (std::size_t i = 0; i < 2; ++i)
            CHECK(longest(abs(found.v[i] - first->v[i]), 2) < 1e-13);
    });
    Box moving = box;
    moving.surfaces.sides[0] = Driven{0.0};
    in_all_ways<2>(moving, balls, 4.5, [&](const Outcome& found) {
        for (std::size_t i = 0; i < 2; ++i)
            CHECK(longest(abs(found.v[i] - first->v[i]), 2) < 1e-13);
    });
}

TEST_CASE("disks that reach a piston at once share it") {
    Box box = plane();
    box.surfaces.sides[1] = Piston{2.0, 0.0, 0.0};
    // each brings momentum 1 to a mass of 2: as a disk of mass 2 would
    const std::vector<Ball> balls{{5, 5, 1, 0}, {5, 10, 1, 0}};
    in_all_ways<2>(box, balls, 35.0, [](const Outcome& found) {
        is_velocity(found.v[0], 0.0, 0.0);
        is_velocity(found.v[1], 0.0, 0.0);
        CHECK(found.counts.ties.contacts == 2);
    });
}

TEST_CASE("a rack of touching disks is broken the same way in every order") {
    std::vector<Ball> balls{{25, 50, 1, 0, 5.0}};  // triangles of 10, 10 and 12: exact
    for (int row = 0; row < 3; ++row)
        for (int k = 0; k <= row; ++k)
            balls.push_back({75.0 + 8.0 * row, 50.0 - 6.0 * row + 12.0 * k, 0, 0, 5.0});
    std::optional<Outcome> first;
    int ways = 0;
    in_all_ways<2>(plane(200.0, 100.0), balls, 41.0, [&](const Outcome& found) {
        if (!first) first = found;
        ++ways;
        for (std::size_t i = 0; i < balls.size(); ++i) {
            CHECK(longest(abs(found.v[i] - first->v[i]), 2) < 1e-12);
        }
        is_velocity({found.v[0][1], 0.0}, 0.0, 0.0);
        CHECK(energy(balls, found.v) == doctest::Approx(0.5).epsilon(1e-13));
        CHECK(momentum(balls, found.v)[0] == doctest::Approx(1.0).epsilon(1e-13));
        CHECK(found.v[2][1] == doctest::Approx(-found.v[3][1]));
    });
    CHECK(ways > 100);
}

TEST_CASE("contacts at different instants are ordinary collisions") {
    const std::vector<Ball> balls{{5, 10, 1, 0}, {20, 11, 0, 0}, {20 + 1e-9, 8.9999, 0, 0}};
    in_all_ways<2>(plane(), balls, 15.0, [&](const Outcome& found) {
        CHECK(found.counts.ties.contacts == 0);
        CHECK(found.counts.particle == 2);
    });
}
