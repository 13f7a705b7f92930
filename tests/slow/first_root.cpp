// The first contact of a falling point in doubles against 256 bits, a million times.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "physics/collision/accelerated_contact.h"
#include "physics/multiprecision/multiprecision.h"
#include "util/random.h"

using namespace carom;

TEST_CASE("the first root is that of 256 bits in a million cases, grazing ones among them") {
    constexpr int bits = 256;
    Random random(5, "first roots");
    const auto precise = [](double x) { return Real(x, bits); };
    int contacts = 0, misses = 0, grazes = 0;
    for (int k = 0; k < 1'000'000; ++k) {
        CAPTURE(k);
        const auto number = [&] { return random.uniform(-1.0, 1.0); };
        const double scale = std::exp(random.uniform(-5.0, 5.0));
        AcceleratedMotion<double> m{number(),         number(), scale * number(),
                                    scale * number(), number(), number()};
        double sigma = std::hypot(m.r[0], m.r[1]) * std::exp(random.uniform(-4.0, 0.0));
        if (k % 4 == 0) {  // nearest after one unit of time, by a little more or less than sigma
            const double turn = random.uniform(0.0, 6.3), speed = 1.0 + 3.0 * random.uniform();
            const double miss =
                std::pow(10.0, random.uniform(-14.0, -3.0)) * (number() < 0 ? -1 : 1);
            const double c = std::cos(turn), s = std::sin(turn);
            sigma = 0.3;
            m.v[0] = -speed * s - m.a[0], m.v[1] = speed * c - m.a[1];
            m.r[0] = (sigma + miss) * c - m.v[0] - 0.5 * m.a[0];
            m.r[1] = (sigma + miss) * s - m.v[1] - 0.5 * m.a[1];
        }
        if (!(sigma < std::hypot(m.r[0], m.r[1]))) continue;
        const double time = accelerated_contact_time(m, sigma, 0.0);
        const AcceleratedMotion<Real> exact{precise(m.r[0]), precise(m.r[1]), precise(m.v[0]),
                                            precise(m.v[1]), precise(m.a[0]), precise(m.a[1])};
        const auto true_time = static_cast<double>(
            accelerated_contact_time<Real>(exact, precise(sigma), precise(0.0), bits));
        if (time == never<double> && true_time == never<double>) {
            ++misses;
            continue;
        }
        const auto there = m.at(std::min(time, true_time));
        const double speed = std::hypot(there.v[0], there.v[1]);
        const double approach = std::abs(there.r[0] * there.v[0] + there.r[1] * there.v[1]) / sigma;
        const double size = std::hypot(m.r[0], m.r[1]) + std::min(time, true_time) * speed;
        // Where it approaches so slowly, round-off decides whether it touches.
        const double depth = 0.5 * approach * approach / (speed * speed) * sigma;
        if (time == never<double> || true_time == never<double>) {
            ++grazes;
            CHECK(depth < 1e-13 * size);
            continue;
        }
        ++contacts;
        const double slack = 64e-16 * (size / std::max(approach, 1e-8 * speed) + time);
        if (depth > 1e-13 * size) CHECK(std::abs(time - true_time) < slack);
    }
    CHECK(contacts > 150'000);
    CHECK(misses > 200'000);
    CHECK(grazes < 100'000);
}
