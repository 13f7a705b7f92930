// What is left of normal distributions, against tables and against what is drawn.
#include "physics/sampling/cut_normal.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "physics/gas.h"
#include "physics/mechanics.h"
#include "physics/placement/draws.h"
#include "support/relative.h"

using namespace carom;
using test::relative;

namespace {

struct Moments {
    double mean, deviation;
};

Moments moments_of(const Eigen::ArrayXd& values) {
    const double mean = values.mean();
    return {mean, std::sqrt((values - mean).square().mean())};
}

// Standard errors of a mean and a deviation, five of them; the distributions are not far from
// normal.
void check_moments(const Eigen::ArrayXd& values, const CutNormal& cut) {
    const Moments drawn = moments_of(values);
    const double most = 5.0 * cut.deviation / std::sqrt(static_cast<double>(values.size()));
    CHECK(std::abs(drawn.mean - cut.mean) < most);
    CHECK(std::abs(drawn.deviation - cut.deviation) < most);
}

}  // namespace

TEST_CASE("a normal distribution about 0 becomes half of one") {
    for (const CutNormal& half : {truncated_at_zero({0.0, 2.0}), folded_at_zero({0.0, 2.0})}) {
        CHECK(half.share == 0.5);
        CHECK(half.mean == relative(2.0 * std::sqrt(2.0 / std::numbers::pi), 1e-15));
        CHECK(half.deviation == relative(2.0 * std::sqrt(1.0 - 2.0 / std::numbers::pi), 1e-14));
    }
    CHECK(truncated_at_zero({3.0, 0.0}).mean == 3.0);
    CHECK(folded_at_zero({3.0, 0.0}).deviation == 0.0);
    CHECK(truncated_at_zero({1.0, 1.0}).share == relative(0.15865525393145707, 1e-15));
}

TEST_CASE("radii, masses and speeds have the moments of the normal distributions that are left") {
    constexpr std::int64_t count = 200'000;
    Gas gas;
    for (const NormalDistribution& normal :
         {NormalDistribution{1.0, 1.0}, {0.5, 1.0}, {2.0, 1.0}, {1.0, 0.1}}) {
        CAPTURE(normal.mean);
        gas.species = {{.name = "a",
                        .count = count,
                        .radius = normal,
                        .mass = ValueRule{normal},
                        .velocity = Speed{normal}}};
        const auto [particles, start] = draw_gas(gas);
        check_moments(particles.radius, truncated_at_zero(normal));
        check_moments(particles.inverse_mass.inverse(), truncated_at_zero(normal));
        check_moments(speeds(start), folded_at_zero(normal));
    }
}
