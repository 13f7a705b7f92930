#include "physics/collision/accelerated_contact.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "physics/multiprecision/multiprecision.h"
#include "support/relative.h"
#include "util/random.h"

using namespace carom;
using test::relative;

namespace {

using Polynomial = std::vector<Real>;

constexpr int bits = 400;
Real precise(double value) { return {value, bits}; }

Real value_at(const Polynomial& p, const Real& t) {
    Real value = p.back();
    for (std::size_t k = p.size() - 1; k > 0; --k) value = value * t + p[k - 1];
    return value;
}

// Sturm's theorem: the number of roots in (from, to] is the difference of the changes of sign.
class Sturm {
  public:
    explicit Sturm(const Polynomial& p) : chain_{p, {}} {
        for (std::size_t k = 1; k < p.size(); ++k)
            chain_[1].push_back(p[k] * static_cast<double>(k));
        while (chain_.back().size() > 1) {
            Polynomial rest = chain_[chain_.size() - 2];
            const Polynomial& by = chain_.back();
            while (rest.size() >= by.size()) {
                const Real share = rest.back() / by.back();
                for (std::size_t k = 0; k < by.size(); ++k)
                    rest[rest.size() - by.size() + k] -= share * by[k];
                rest.pop_back();
            }
            for (Real& one : rest) one.negate();
            chain_.push_back(rest);
        }
    }
    int roots(const Real& from, const Real& to) const { return changes(from) - changes(to); }

  private:
    int changes(const Real& t) const {
        int count = 0, last = 0;
        for (const Polynomial& p : chain_) {
            const int sign = value_at(p, t).sign();
            if (sign != 0 && last != 0 && sign != last) ++count;
            if (sign != 0) last = sign;
        }
        return count;
    }
    std::vector<Polynomial> chain_;
};

Polynomial gap_of(const AcceleratedMotion<double>& m, double sigma) {
    const Real x = precise(m.r[0]), y = precise(m.r[1]), vx = precise(m.v[0]), vy = precise(m.v[1]),
               ax = precise(m.a[0]), ay = precise(m.a[1]), s = precise(sigma);
    return {x * x + y * y - s * s, 2.0 * (x * vx + y * vy), vx * vx + vy * vy + x * ax + y * ay,
            vx * ax + vy * ay, (ax * ax + ay * ay) * 0.25};
}

double distance_at(const AcceleratedMotion<double>& m, double t) {
    const auto there = m.at(t);
    return std::hypot(there.r[0], there.r[1]);
}

}  // namespace

TEST_CASE("simple contacts of a falling point are exact") {
    const auto fall = [](double height, double speed, double sigma) {
        return accelerated_contact_time<double>({0.0, height, 0.0, speed, 0.0, -1.0}, sigma, 0.0);
    };
    CHECK(fall(2.5, 0.0, 0.5) == relative(2.0, 1e-15));
    CHECK(fall(1.2, 0.0, 1.0) == relative(std::sqrt(0.4), 1e-15));
    CHECK(fall(0.5, 1.0, 0.5) == relative(2.0, 1e-15));  // thrown up from the disk
    CHECK(fall(0.5, -1.0, 0.5) == 0.0);                  // touches, and approaches
    CHECK(fall(-2.0, 1.0, 0.5) == never<double>);        // from below, not high enough
    CHECK(fall(-1.0, 2.0, 0.5) == relative(2.0 - std::sqrt(3.0), 1e-14));
}

TEST_CASE("an acceleration next to nothing changes nothing") {
    for (const double acceleration : {1e-300, 1e-150}) {  // the square of the first underflows
        CAPTURE(acceleration);
        const auto contact = [&](double y, double vx) {
            return accelerated_contact_time<double>({4.0, y, vx, 0.0, acceleration, 0.0}, 1.0, 0.0);
        };
        CHECK(contact(0.0, -2.0) == relative(1.5, 1e-14));
        CHECK_FALSE(contact(0.0, 2.0) < 1e100);
        CHECK_FALSE(contact(3.0, -2.0) < 1e100);
    }
}

// In one case of four the distance comes so near to that of contact, from either side, that a
// contact is short, or there is none; in one of five the point begins at rest.
TEST_CASE("the first contact of a falling point is found, and none that is not there") {
    Random random(3, "falling points");
    int contacts = 0, misses = 0;
    for (int k = 0; k < 20'000; ++k) {
        const double scale = std::exp(random.uniform(-5.0, 5.0));
        const auto number = [&] { return random.uniform(-1.0, 1.0); };
        const double fast = k % 5 == 1 ? 0.0 : scale;
        const AcceleratedMotion<double> m{number(),        number(), fast * number(),
                                          fast * number(), number(), number()};
        double sigma = std::hypot(m.r[0], m.r[1]) * std::exp(random.uniform(-4.0, 0.0));
        if (k % 4 == 0) {
            double nearest = std::hypot(m.r[0], m.r[1]);
            for (int step = 0; step < 2000; ++step)
                nearest = std::min(nearest, distance_at(m, 3.0 / scale * step / 1000.0));
            sigma = nearest *
                    (1.0 + (k % 8 == 0 ? 1.0 : -1.0) * std::pow(10.0, random.uniform(-12.0, -3.0)));
        }
        if (!(sigma < std::hypot(m.r[0], m.r[1]))) continue;
        const Sturm sturm(gap_of(m, sigma));
        const double time = accelerated_contact_time(m, sigma, 0.0);
        if (time == never<double>) {
            ++misses;
            CHECK(sturm.roots(precise(0.0), precise(1e9)) == 0);
            continue;
        }
        ++contacts;
        // Positions are rounded to 1e-16 or so, by which a point has moved in `slack`.
        const auto there = m.at(time);
        const double speed = std::hypot(there.v[0], there.v[1]);
        const double approach = std::abs(there.r[0] * there.v[0] + there.r[1] * there.v[1]) / sigma;
        const double size = std::hypot(m.r[0], m.r[1]) + time * speed;
        const double slack = 16e-16 * (size / std::max(approach, 1e-9 * speed) + time);
        CHECK(sturm.roots(precise(0.0), precise(std::max(0.0, time - slack))) == 0);
        CHECK(sturm.roots(precise(0.0), precise(time + slack)) > 0);
        CHECK(std::abs(distance_at(m, time) - sigma) <= 16e-16 * size);
    }
    CHECK(contacts > 3000);
    CHECK(misses > 3000);
}

TEST_CASE("many bits give the same contact to the last of them") {
    const AcceleratedMotion<Real> m{precise(0.3),  precise(2.5), precise(0.1),
                                    precise(-0.4), precise(0.0), precise(-1.0)};
    const Real time = accelerated_contact_time(m, precise(0.5), precise(0.0), bits);
    const auto there = m.at(time);
    const Real gap = there.r[0] * there.r[0] + there.r[1] * there.r[1] - precise(0.25);
    CHECK(std::abs(static_cast<double>(gap)) < 1e-118);  // 2^-400 is 4e-121
    CHECK(static_cast<double>(time) ==
          relative(accelerated_contact_time<double>({0.3, 2.5, 0.1, -0.4, 0.0, -1.0}, 0.5, 0.0),
                   1e-15));
}
