#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "physics/collision/contact_rule.h"
#include "physics/multiprecision/multiprecision.h"
#include "support/csv.h"
#include "support/relative.h"
#include "util/random.h"

using namespace carom;
using test::relative;

namespace {

using Motion = RelativeMotion<double>;

double time_of(const Motion& m, double sigma) {
    return contact_time(m, sigma, approach_round_off(m, {0.0, 0.0}, m.v));
}

// The contact time in long double, from the same doubles; good to 1e-15 unless the pair grazes.
long double reference_time(const Motion& m, double sigma) {
    const long double x = m.r[0], y = m.r[1], vx = m.v[0], vy = m.v[1], s = sigma;
    const long double b = x * vx + y * vy, v2 = vx * vx + vy * vy;
    const long double c = x * x + y * y - s * s, miss = x * vy - y * vx;
    return c / (-b + std::sqrt(s * s * v2 - miss * miss));
}

}  // namespace

TEST_CASE("along the line of centres a collision is the exact one of one dimension") {
    for (const auto& row : test::reference_rows("pair_collision_1d.csv")) {
        const double u1 = test::fraction(row[0]), u2 = test::fraction(row[1]);
        const double w1 = test::fraction(row[2]), w2 = test::fraction(row[3]);
        // Whatever the line of centres; 3-4-5 keeps its components exact. The part of the velocity
        // across it, 0.5, stays.
        for (const auto& [nx, ny] : {std::pair{1.0, 0.0}, {0.0, -1.0}, {0.6, 0.8}}) {
            const double v1x = u1 * nx - 0.5 * ny, v1y = u1 * ny + 0.5 * nx;
            const double v2x = u2 * nx - 0.5 * ny, v2y = u2 * ny + 0.5 * nx;
            const Motion m{1.25 * nx, 1.25 * ny, v2x - v1x, v2y - v1y};
            const Unrounded<double> factor = ContactRule::impulse(m, w1, w2);
            const double first = product_of(w1, factor), second = product_of(w2, factor);
            const double after1 = (v1x + first * m.r[0]) * nx + (v1y + first * m.r[1]) * ny;
            const double after2 = (v2x - second * m.r[0]) * nx + (v2y - second * m.r[1]) * ny;
            const double across1 = -(v1x + first * m.r[0]) * ny + (v1y + first * m.r[1]) * nx;
            const double size = std::abs(u1) + std::abs(u2) + 0.5;
            CHECK(std::abs(after1 - std::stod(row[6])) <= 8e-16 * size);  // a few roundings
            CHECK(std::abs(after2 - std::stod(row[7])) <= 8e-16 * size);
            CHECK(std::abs(across1 - 0.5) <= 8e-16 * size);
        }
    }
}

TEST_CASE("contact times of simple pairs are exact") {
    CHECK(time_of({3.0, 0.0, -1.0, 0.0}, 1.0) == 2.0);
    CHECK(time_of({0.0, -3.0, 0.0, 4.0}, 1.0) == 0.5);
    CHECK(time_of({4.0, 3.0, -1.0, 0.0}, 5.0) == 0.0);               // touching
    CHECK(time_of({8.0, 3.0, -1.0, 0.0}, 5.0) == 4.0);               // 3-4-5 at contact
    CHECK(time_of({3.0, 0.0, 1.0, 0.0}, 1.0) == never<double>);      // receding
    CHECK(time_of({0.5, 0.0, 1.0, 0.0}, 1.0) == never<double>);      // receding from an overlap
    CHECK(time_of({0.5, 0.0, -1.0, 0.0}, 1.0) == 0.0);               // deeper into it: now
    CHECK(time_of({3.0, 2.0, -1.0, 0.0}, 1.0) == never<double>);     // passing
    CHECK(time_of({3.0, 0.0, 0.0, 0.0}, 1.0) == never<double>);      // no relative motion
    CHECK(time_of({3.0, 0.0, -1e-320, 0.0}, 1.0) == never<double>);  // overflows
}

TEST_CASE("a tangential approach is none") {
    // Touching along x and sliding along y, with the velocities' round-off along x.
    const double v = 1e-17;
    const Motion sliding{1.0, 0.0, -v, 1.0};
    CHECK(contact_time(sliding, 1.0, approach_round_off(sliding, {0.5, 0.0}, {0.5, 1.0})) ==
          never<double>);
    // The same approach without large velocities behind it is real.
    CHECK(contact_time(sliding, 1.0, approach_round_off(sliding, {0.0, 0.0}, {-v, 0.001})) == 0.0);
}

TEST_CASE("a pair that nearly touches meets at a time that is right to the last digits") {
    Random random(7, "near contact");
    for (int i = 0; i < 20000; ++i) {
        const double angle = random.uniform(0.0, 6.28), gap = std::exp(random.uniform(-30.0, 0.0));
        const double across = random.uniform(-0.9, 0.9);
        const double nx = std::cos(angle), ny = std::sin(angle);
        const Motion m{(1.0 + gap) * nx, (1.0 + gap) * ny, -nx - across * ny, -ny + across * nx};
        if (m.r[0] * m.r[0] + m.r[1] * m.r[1] <= 1.0) continue;
        const auto exact = reference_time(m, 1.0);
        if (!(exact > 1e-12L)) continue;  // there long double itself cancels
        // long double cancels too: its error is 1e-19 of the squares
        CHECK(std::abs(time_of(m, 1.0) - static_cast<double>(exact)) <=
              static_cast<double>(4e-15L * exact + 4e-19L));
    }
}

TEST_CASE("whether distant pairs graze is told rightly") {
    // At 1000 diameters, offsets across the path of 1 -+ 1e-12 decide; exact in these numbers.
    for (const double offset : {0x1p-38, 0x1p-42, 0x1p-45}) {
        const Motion hit{1024.0, 1.0 - offset, -1.0, 0.0};
        const Motion miss{1024.0, 1.0 + offset, -1.0, 0.0};
        CHECK(std::isfinite(time_of(hit, 1.0)));
        CHECK(time_of(miss, 1.0) == never<double>);
        const double depth = std::sqrt((1.0 - hit.r[1]) * (1.0 + hit.r[1]));
        CHECK(time_of(hit, 1.0) == relative(1024.0 - depth, 4e-16));
    }
}

TEST_CASE("gap and cross product keep the digits that plain arithmetic loses") {
    // (1 + e)^2 - 1 = 2 e + e^2 with e = 2^-40: exact, where the rounded squares give 2 e only.
    const double e = 0x1p-40;
    CHECK(contact_gap(Motion{1.0 + e, 0.0, 0.0, 0.0}, 1.0) == 2.0 * e + e * e);
    CHECK(contact_gap(Motion{0.0, 1.0 - e, 0.0, 0.0}, 1.0) == -2.0 * e + e * e);
    // (1 + e)(1 - e) - 1 = -e^2.
    CHECK(difference_of_products(1.0 + e, 1.0 - e, 1.0, 1.0) == -e * e);
}

// Two disks some 1e-15 to 1e3 sums of radii from contact, mostly aimed at the rim, within a part in
// 1e0 to 1e15 of the sum of radii.
Motion near_the_rim(Random& random) {
    const double angle = random.uniform(0.0, 6.28);
    const double distance = 1.0 + std::exp(random.uniform(-35.0, 8.0));
    const double offset = 1.0 - std::exp(random.uniform(-35.0, 0.0));
    const double along = std::sqrt((distance - offset) * (distance + offset));
    const double nx = std::cos(angle), ny = std::sin(angle);
    return {along * nx - offset * ny, along * ny + offset * nx, -nx, -ny};
}

TEST_CASE("a quick look leaves out no contact, and most of those that recede or pass wide") {
    Random random(11, "refusals");
    int contacts = 0;
    for (int i = 0; i < 100'000; ++i) {
        const Motion m = near_the_rim(random);
        if (!std::isfinite(time_of(m, 1.0))) continue;
        ++contacts;
        const auto look = quick_look(m, 1.0);
        REQUIRE(look.approach > 0.0);
        REQUIRE(look.slack >= 0.0);
    }
    CHECK(contacts > 50'000);
    CHECK(quick_look(Motion{3.0, 0.9, 1.0, 0.0}, 1.0).approach < 0.0);
    CHECK(quick_look(Motion{3.0, 1.001, -1.0, 0.0}, 1.0).slack < 0.0);
}

TEST_CASE("who might touch within a time is never less than half as far away in time") {
    Random random(13, "in time");
    const auto might_touch = [](const Motion& m, double time) {
        return might_touch_within(m, 1.0, quick_look(m, 1.0).approach, time);
    };
    int far = 0;
    for (int i = 0; i < 100'000; ++i) {
        const Motion m = near_the_rim(random);
        const double time = time_of(m, 1.0);
        if (!std::isfinite(time)) continue;
        REQUIRE(might_touch(m, time));
        // the margin of 1e-4 diameters apart, whoever is that near might
        const bool near = contact_gap(m, 1.0) < 1e-2;
        REQUIRE((near || !might_touch(m, 0.45 * time)));
        far += near ? 0 : 1;
    }
    CHECK(far > 10'000);
    CHECK(might_touch(Motion{3.0, 0.0, -1.0, 0.0}, never<double>));
}

TEST_CASE("contact times of two at once have the bits of those one by one") {
    Random random(12, "lanes");
    const auto draw = [&random]() -> Motion {
        const double kind = random.uniform();
        if (kind < 0.7) return near_the_rim(random);
        if (kind < 0.8)
            return {1.0, 0.0, -1e-16 * std::floor(20.0 * random.uniform()), 1.0};  // a graze
        if (kind < 0.9) return {2.0, 0.0, 0.0, 0.0};                               // no motion
        return {random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0),
                random.uniform(-2.0, 2.0)};
    };
    for (int i = 0; i < 100'000; ++i) {
        const Motion a = draw(), b = draw();
        const double sigma = random.uniform(0.5, 1.0), v = random.uniform(-1.0, 1.0);
        RelativeMotion<TwoLanes> both;
        for (std::size_t k = 0; k < 2; ++k) {
            both.r[k] = TwoLanes{a.r[k], b.r[k]};
            both.v[k] = TwoLanes{a.v[k], b.v[k]};
        }
        const std::array<TwoLanes, 2> drift{TwoLanes{} + v, TwoLanes{} + v};
        const TwoLanes round_off = approach_round_off(both, drift, drift);
        const TwoLanes times = contact_time(both, TwoLanes{1.0, sigma}, round_off);
        REQUIRE(times[0] == contact_time(a, 1.0, approach_round_off(a, {v, v}, {v, v})));
        REQUIRE(times[1] == contact_time(b, sigma, approach_round_off(b, {v, v}, {v, v})));
    }
}

// What a collision adds to the energy goes by the relative error of its impulse. It must have no
// mean: in a long run all else averages out.
TEST_CASE("the rounding errors of impulses have no mean") {
    constexpr double pi = 3.14159265358979, unit = 0x1p-53;
    constexpr int pairs = 40'000;
    // Errors of four products, two sums, quotients and the result spread by less than a unit and a
    // half. Five standard errors: of three means one is beyond once in half a million.
    constexpr double most = 5.0 * 1.5 / 200.0;  // the root of the number of pairs
    for (const auto& shares : {std::pair{1.0, 1.0}, {1.0 / 3, 1.0 / 3}, {0.1, 7.0}}) {
        const double w1 = shares.first, w2 = shares.second;
        CAPTURE(w1);
        Random random(21, "impulses");
        double sum = 0.0;
        for (int k = 0; k < pairs;) {
            const double angle = random.uniform(0, 2 * pi);  // the disks touch at a distance of 1
            const Motion m{std::cos(angle), std::sin(angle), random.normal(), random.normal()};
            const long double x = m.r[0], y = m.r[1], vx = m.v[0], vy = m.v[1];
            const long double approach = x * vx + y * vy;
            if (std::abs(approach) < 0.3L * std::hypot(vx, vy)) continue;  // few bits are left
            const long double exact =
                2 * approach / ((x * x + y * y) * (static_cast<long double>(w1) + w2));
            for (const double w : {w1, w2})
                sum += static_cast<double>(
                    (product_of(w, ContactRule::impulse(m, w1, w2)) / (w * exact) - 1) / unit);
            ++k;
        }
        CHECK(std::abs(sum / (2 * pairs)) < most);
    }
}

TEST_CASE("an infinite mass is not moved, and a heavy one hardly") {
    const Motion m{1.0, 0.0, -2.0, 0.0};
    CHECK(product_of(1.0, ContactRule::impulse(m, 1.0, 0.0)) ==
          -4.0);  // v1 += 1 * -4: the wall's law, twice its speed
    CHECK(product_of(1e-15, ContactRule::impulse(m, 1e-15, 1.0)) == relative(-4e-15, 1e-14));
}

TEST_CASE("walls are met from inside, at once from beyond, and never at rest") {
    CHECK(wall_time(2.0, -1.0, 0.5, 9.5) == 1.5);
    CHECK(wall_time(2.0, 2.0, 0.5, 9.5) == 3.75);
    CHECK(wall_time(0.4, -1.0, 0.5, 9.5) == 0.0);
    CHECK(wall_time(0.4, 1.0, 0.5, 9.5) == relative(9.1, 4e-16));
    CHECK(wall_time(2.0, 0.0, 0.5, 9.5) == never<double>);
}

TEST_CASE("each arithmetic of the contact rule gives the same elastic contact") {
    Random random(4, "contact rule");
    for (int k = 0; k < 1'000; ++k) {
        const auto any = [&] { return random.uniform(-2.0, 2.0); };
        const std::array<double, 2> r{any(), any()}, v1{any(), any()}, v2{any(), any()};
        const double w1 = random.uniform(0.01, 3.0), w2 = k % 3 == 0 ? w1 : random.uniform() * 3.0;
        const double square = r[0] * r[0] + r[1] * r[1];
        const double approach = r[0] * (v2[0] - v1[0]) + r[1] * (v2[1] - v1[1]);
        const double exact = 2.0 * approach / (square * (w1 + w2));
        const auto close = [&](double found, double expected) {
            return std::abs(found - expected) < 1e-12 * (1.0 + std::abs(exact));
        };
        const RelativeMotion<double> motion{r, {v2[0] - v1[0], v2[1] - v1[1]}};
        const auto in_doubles = ContactRule::impulse(motion, w1, w2);
        CHECK(close(in_doubles.value, exact));

        const auto real = [](double value) { return Real(value, 200); };
        std::array<Real, 2> first{real(v1[0]), real(v1[1])}, second{real(v2[0]), real(v2[1])};
        Real along = real(approach), of_square = real(square), factor = real(0.0), part = factor;
        ContactRule::push(first, second, {real(r[0]), real(r[1])}, w1, w2, along, of_square, factor,
                          part);
        for (std::size_t a = 0; a < 2; ++a) {
            CHECK(close(static_cast<double>(first[a]), v1[a] + w1 * exact * r[a]));
            CHECK(close(static_cast<double>(second[a]), v2[a] - w2 * exact * r[a]));
        }

        // Along a line the separation is of length 1, and so is the normal of a surface here.
        const double on_line = 2.0 * (v2[0] - v1[0]) / (w1 + w2);
        double left = v1[0], right = v2[0];
        const auto [share, other_share] = ContactRule::shares_on_line(w1, w2);
        ContactRule::push_on_line(left, right, share, other_share);
        CHECK(close(left, v1[0] + w1 * on_line));
        CHECK(close(right, v2[0] - w2 * on_line));
        const auto off = ContactRule::reflection(v1[0] - v2[0], 1.0, w1, w2);
        CHECK(close(v1[0] + off.of_particle, left));
        CHECK(close(v2[0] + off.of_surface, right));
        const auto off_wall = ContactRule::reflection(v1[0], 1.0, w1, 0.0);
        double reflected = v1[0];
        ContactRule::reflect(reflected);
        CHECK(reflected == -v1[0]);
        CHECK(v1[0] + off_wall.of_particle == reflected);
        CHECK(off_wall.of_surface == 0.0);
    }
}
