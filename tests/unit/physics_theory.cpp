#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <string>

#include "physics/theory.h"
#include "support/csv.h"

using namespace carom;

namespace {

// Simpson's rule after x = u^2 at the lower end; the integrands are smooth powers.
double integral(const std::function<double(double)>& f, double high) {
    constexpr int steps = 20000;
    const double h = 1.0 / steps;
    double sum = 0.0;
    for (int i = 0; i <= steps; ++i) {
        const double u = i * h;
        const double weight = (i == 0 || i == steps) ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0);
        sum += weight * f(high * u * u) * 2.0 * u * high;
    }
    return sum * h / 3.0;
}

struct State {
    Box box;
    Particles particles;
    Sample sample;
};

// N particles of one mass, the first with all the energy, or the first two back to back.
State gas_of(int count, Wall wall) {
    State s;
    s.box.size = {10.0, 10.0};
    s.box.walls = {wall, wall};
    s.particles.radius = Eigen::ArrayXd::Constant(count, 0.1);
    s.particles.inverse_mass = Eigen::ArrayXd::Constant(count, 0.5);
    s.particles.species = Eigen::ArrayXi::Zero(count);
    s.sample.position = Eigen::ArrayXXd::Zero(count, 2);
    s.sample.velocity = Eigen::ArrayXXd::Zero(count, 2);
    s.sample.velocity(0, 0) = 3.0;
    if (wall == Wall::periodic) s.sample.velocity(1, 0) = -3.0;
    return s;
}

}  // namespace

TEST_CASE("moments of the densities are the exact ones of the finite gas") {
    int rows = 0;
    for (const auto& row : test::reference_rows("microcanonical_moments.csv")) {
        const bool periodic = row[0].starts_with("2D periodic");
        if (!periodic && !row[0].starts_with("2D walls")) continue;
        ++rows;
        const int count = std::stoi(row[1]);
        const State s = gas_of(count, periodic ? Wall::periodic : Wall::solid);
        const auto gas = equilibrium(s.box, s.particles, s.sample);
        REQUIRE(gas.has_value());
        const double energy = gas->energy;
        CHECK(energy == doctest::Approx(periodic ? 18.0 : 9.0));
        const double most = gas->groups[0].largest_share * energy;
        const double fastest = std::sqrt(most);  // m = 2
        const double thermal = std::sqrt(energy / (periodic ? count - 1 : count) / 2.0);
        const auto share_moment = [&](int power) {
            return integral(
                [&](double e) { return std::pow(e / energy, power) * energy_density(*gas, e); },
                most);
        };
        CHECK(share_moment(0) == doctest::Approx(1.0).epsilon(1e-7));
        CHECK(share_moment(1) == doctest::Approx(test::fraction(row[2])).epsilon(1e-7));
        CHECK(share_moment(2) == doctest::Approx(test::fraction(row[3])).epsilon(1e-7));
        CHECK(integral([&](double v) { return speed_density(*gas, v); }, fastest) ==
              doctest::Approx(1.0).epsilon(1e-7));
        CHECK(integral([&](double v) { return v * speed_density(*gas, v); }, fastest) / thermal ==
              doctest::Approx(std::stod(row[6])).epsilon(1e-6));
        CHECK(mean_speed(*gas) / thermal == doctest::Approx(std::stod(row[6])).epsilon(1e-12));
        CHECK(mean_energy(*gas) / energy == doctest::Approx(test::fraction(row[2])));
    }
    CHECK(rows >= 12);
}

TEST_CASE("a mixture's density is the average over its particles, species can be picked") {
    State s = gas_of(5, Wall::solid);
    s.particles.inverse_mass << 0.5, 0.5, 0.125, 0.125, 0.125;
    s.particles.species << 0, 0, 1, 1, 1;
    const auto all = equilibrium(s.box, s.particles, s.sample);
    const auto light = equilibrium(s.box, s.particles, s.sample, {0});
    const auto heavy = equilibrium(s.box, s.particles, s.sample, {1});
    REQUIRE(all.has_value());
    CHECK(all->groups.size() == 2);
    for (const double v : {0.1, 0.7, 1.3}) {
        CHECK(speed_density(*all, v) ==
              doctest::Approx(0.4 * speed_density(*light, v) + 0.6 * speed_density(*heavy, v)));
        // 4 particles share what is left: (1 - e/E)^3 4/E
        const double e = 0.5 * 2.0 * v * v;
        CHECK(speed_density(*light, v) ==
              doctest::Approx(2.0 * v * 4.0 / 9.0 * std::pow(1.0 - e / 9.0, 3.0)));
    }
    CHECK(energy_density(*all, 9.1) == 0.0);
    CHECK(energy_density(*all, -0.1) == 0.0);
    CHECK(speed_density(*all, -0.1) == 0.0);
}

TEST_CASE("two particles share the energy uniformly") {
    const State s = gas_of(2, Wall::solid);
    const auto gas = equilibrium(s.box, s.particles, s.sample);
    REQUIRE(gas.has_value());
    CHECK(energy_density(*gas, 0.0) == doctest::Approx(1.0 / 9.0));
    CHECK(energy_density(*gas, 9.0) == doctest::Approx(1.0 / 9.0));
}

TEST_CASE("there is no curve where nothing tends to it") {
    const auto none = [](const State& s) {
        return !equilibrium(s.box, s.particles, s.sample).has_value();
    };
    CHECK(none(gas_of(1, Wall::solid)));     // its energy never changes
    CHECK(none(gas_of(2, Wall::periodic)));  // nor do these
    CHECK_FALSE(none(gas_of(3, Wall::periodic)));
    State s = gas_of(4, Wall::solid);
    s.box.walls[0] = Wall::periodic;
    CHECK(none(s));
    s.particles.inverse_mass[3] = 0.0;  // a fixed obstacle takes up momentum
    CHECK_FALSE(none(s));
    s.sample.velocity(3, 0) = 0.1;  // a moving one energy as well
    CHECK(none(s));
    s = gas_of(4, Wall::periodic);
    s.sample.velocity(2, 1) = 1.0;  // a drift
    CHECK(none(s));
    s = gas_of(4, Wall::solid);
    s.sample.velocity.setZero();
    CHECK(none(s));
    s = gas_of(4, Wall::solid);
    s.particles.radius[1] = 0.0;
    CHECK(none(s));
}

TEST_CASE("many different masses are merged without harm") {
    State s = gas_of(5000, Wall::solid);
    s.particles.inverse_mass = Eigen::ArrayXd::LinSpaced(5000, 0.5, 2.0);
    const auto gas = equilibrium(s.box, s.particles, s.sample);
    REQUIRE(gas.has_value());
    CHECK(gas->groups.size() <= 1025);
    double exact = 0.0;  // in the limit of many particles m v / T exp(-m v^2 / 2T)
    const double t = gas->energy / 5000.0, v = 0.04;
    for (const double w : s.particles.inverse_mass)
        exact += v / (w * t) * std::exp(-v * v / (2.0 * w * t)) / 5000.0;
    CHECK(speed_density(*gas, v) == doctest::Approx(exact).epsilon(2e-3));
}
