#include "physics/theory/theory.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "support/csv.h"
#include "support/equilibrium.h"
#include "support/goodness_of_fit.h"
#include "support/relative.h"
#include "util/random.h"

using namespace carom;
using test::relative;

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
        const auto gas = test::equilibrium(s.box, s.particles, s.sample);
        REQUIRE(gas.has_value());
        const double energy = gas->energy;
        CHECK(energy == relative(periodic ? 18.0 : 9.0, 1e-12));
        const double most = gas->groups[0].largest_share[0] * energy;
        const double fastest = std::sqrt(most);  // m = 2
        const double thermal = std::sqrt(energy / (periodic ? count - 1 : count) / 2.0);
        const auto share_moment = [&](int power) {
            return integral(
                [&](double e) { return std::pow(e / energy, power) * energy_density(*gas, e); },
                most);
        };
        CHECK(share_moment(0) == relative(1.0, 1e-7));
        CHECK(share_moment(1) == relative(test::fraction(row[2]), 1e-7));
        CHECK(share_moment(2) == relative(test::fraction(row[3]), 1e-7));
        CHECK(integral([&](double v) { return speed_density(*gas, v); }, fastest) ==
              relative(1.0, 1e-7));
        CHECK(integral([&](double v) { return v * speed_density(*gas, v); }, fastest) / thermal ==
              relative(std::stod(row[6]), 1e-6));
        CHECK(mean_speed(*gas) / thermal == relative(std::stod(row[6]), 1e-12));
    }
    CHECK(rows >= 12);
}

namespace {

// Beads of different masses with all energy in the first, or in the first two back to back; in
// their centre-of-mass frame.
State line_of(const std::vector<double>& masses, Wall ends) {
    const auto count = static_cast<Eigen::Index>(masses.size());
    State s;
    s.box = {1, {10.0, 0.0}, {ends, Wall::solid}};
    s.particles.radius = Eigen::ArrayXd::Zero(count);
    s.particles.inverse_mass = Eigen::Map<const Eigen::ArrayXd>(masses.data(), count).inverse();
    s.particles.species = Eigen::ArrayXi::Zero(count);
    s.sample.position = Eigen::ArrayXd::LinSpaced(count, 1.0, 9.0);
    s.sample.velocity = Eigen::ArrayXd::Zero(count);
    s.sample.velocity(0, 0) = 3.0;
    if (ends == Wall::periodic) s.sample.velocity(1, 0) = -3.0 * masses[0] / masses[1];
    return s;
}

}  // namespace

TEST_CASE("moments of beads between walls are the exact ones of the finite gas") {
    int rows = 0;
    for (const auto& row : test::reference_rows("microcanonical_moments.csv")) {
        if (!row[0].starts_with("1D walls")) continue;
        ++rows;
        const int count = std::stoi(row[1]);
        // The laws are the same for all masses; a line draws them only where masses differ.
        const EquilibriumGas gas{9.0, 0.5, 0.5 * (count - 1), {{2.0, double(count)}}};
        const double thermal = std::sqrt(2.0 * 9.0 / count / 2.0);
        CHECK(mean_speed(gas) / thermal == relative(std::stod(row[6]), 1e-12));
        if (count == 2) continue;  // its density is infinite at both ends
        const auto share_moment = [&](int power) {
            return integral(
                [&](double e) {
                    return e > 0.0 ? std::pow(e / 9.0, power) * energy_density(gas, e) : 0.0;
                },
                9.0);
        };
        CHECK(share_moment(1) == relative(test::fraction(row[2]), 1e-6));
        CHECK(share_moment(2) == relative(test::fraction(row[3]), 1e-6));
        const auto speed_moment = [&](int power) {
            return integral([&](double v) { return std::pow(v, power) * speed_density(gas, v); },
                            3.0);
        };
        CHECK(speed_moment(0) == relative(1.0, 1e-6));
        CHECK(speed_moment(4) / std::pow(speed_moment(2), 2) ==
              relative(test::fraction(row[4]), 1e-6));
    }
    CHECK(rows == 7);
}

TEST_CASE("energies of beads are those of points spread evenly over the energy sphere") {
    const std::vector<double> masses{1.0, 2.0, 2.0, 7.0, 0.5};
    for (const Wall ends : {Wall::solid, Wall::periodic}) {
        State s = line_of(masses, ends);
        s.particles.species << 0, 1, 1, 2, 0;
        const auto gas = test::equilibrium(s.box, s.particles, s.sample, {1, 2});
        REQUIRE(gas.has_value());
        constexpr int draws = 40'000;
        constexpr int bins = 10;
        Random random(5, "energy sphere");
        std::array<double, bins> share{};
        const double width = 0.33 * gas->energy / double(masses.size());
        for (int draw = 0; draw < draws; ++draw) {
            std::vector<double> v, e;
            double momentum = 0.0, energy = 0.0;
            for (const double mass : masses) {
                v.push_back(random.normal() / std::sqrt(mass));
                momentum += mass * v.back();
            }
            const double drift = ends == Wall::periodic ? momentum / 12.5 : 0.0;
            for (std::size_t i = 0; i < v.size(); ++i) {
                e.push_back(0.5 * masses[i] * std::pow(v[i] - drift, 2));
                energy += e.back();
            }
            const double picked = e[static_cast<std::size_t>(1 + draw % 3)] / energy;
            const auto bin = static_cast<std::size_t>(picked * gas->energy / width);
            if (bin < bins) share[bin] += 1.0 / draws;
        }
        for (std::size_t i = 0; i < bins; ++i) {
            const double expected =
                energy_probability(*gas, double(i) * width, double(i + 1) * width);
            CAPTURE(i);
            CHECK(std::abs(share[i] - expected) < 4.5 * std::sqrt(expected / draws));
        }
    }
}

TEST_CASE("the probability of an interval is the integral of the density") {
    const State s = line_of({1.0, 2.0, 3.0, 0.2}, Wall::solid);
    const auto gas = test::equilibrium(s.box, s.particles, s.sample);
    REQUIRE(gas.has_value());
    const double step = gas->energy / 12.0;  // a third of the mean of each
    double sum = 0.0;
    for (int i = 0; i * step < gas->energy; ++i)
        sum += energy_probability(*gas, i * step, (i + 1) * step);
    CHECK(sum == relative(1.0, 1e-6));
    const auto density = [&](double e) { return e > 0.0 ? energy_density(*gas, e) : 0.0; };
    CHECK(energy_probability(*gas, 0.5 * step, step) ==
          relative(integral(density, step) - integral(density, 0.5 * step), 1e-4));
    CHECK(std::isinf(energy_density(*gas, 0.0)));
    CHECK(std::isfinite(speed_density(*gas, 0.0)));
    CHECK(energy_probability(*gas, -1.0, 0.0) == 0.0);
    CHECK(energy_probability(*gas, gas->energy, 2.0 * gas->energy) == 0.0);
}

TEST_CASE("beads that do not mix have no curve") {
    const auto none = [](const State& s) {
        return !test::equilibrium(s.box, s.particles, s.sample).has_value();
    };
    CHECK(none(line_of({2.0, 2.0, 2.0, 2.0, 2.0}, Wall::solid)));
    CHECK(none(line_of({2.0, 2.0, 2.0, 2.0, 2.0}, Wall::periodic)));
    CHECK(none(line_of({1.0, 2.0}, Wall::solid)));
    CHECK_FALSE(none(line_of({1.0, 2.0, 2.0}, Wall::solid)));
    CHECK(none(line_of({1.0, 2.0, 2.0}, Wall::periodic)));
    CHECK_FALSE(none(line_of({1.0, 2.0, 2.0, 2.0}, Wall::periodic)));
    State s = line_of({1.0, 2.0, 2.0, 2.0}, Wall::periodic);
    s.sample.velocity(3, 0) = 1.0;
    CHECK(none(s));  // it drifts
    // A fixed bead parts a line with walls, but makes one of a ring.
    for (const Wall ends : {Wall::solid, Wall::periodic}) {
        s = line_of({1.0, 2.0, 2.0, 1.0, 3.0, 4.0}, ends);
        s.particles.inverse_mass[3] = 0.0;
        CHECK(none(s) == (ends == Wall::solid));
    }
    s = line_of({1.0, 2.0, 2.0, 1.0}, Wall::solid);
    s.particles.inverse_mass[3] = 0.0;
    CHECK_FALSE(none(s));  // the fixed one stands at the end
    s = line_of({1.0, 1.0, 1.0, 5.0}, Wall::solid);
    s.particles.inverse_mass[3] = 0.0;
    CHECK(none(s));
    // Species may be picked although each has one mass.
    s = line_of({1.0, 2.0, 2.0, 1.0}, Wall::solid);
    s.particles.species << 0, 1, 1, 0;
    CHECK(test::equilibrium(s.box, s.particles, s.sample, {1}).has_value());
}

TEST_CASE("a mixture's density is the average over its particles, species can be picked") {
    State s = gas_of(5, Wall::solid);
    s.particles.inverse_mass << 0.5, 0.5, 0.125, 0.125, 0.125;
    s.particles.species << 0, 0, 1, 1, 1;
    const auto all = test::equilibrium(s.box, s.particles, s.sample);
    const auto light = test::equilibrium(s.box, s.particles, s.sample, {0});
    const auto heavy = test::equilibrium(s.box, s.particles, s.sample, {1});
    REQUIRE(all.has_value());
    CHECK(all->groups.size() == 2);
    for (const double v : {0.1, 0.7, 1.3}) {
        CHECK(speed_density(*all, v) ==
              relative(0.4 * speed_density(*light, v) + 0.6 * speed_density(*heavy, v), 1e-12));
        // 4 particles share what is left: (1 - e/E)^3 4/E
        const double e = 0.5 * 2.0 * v * v;
        CHECK(speed_density(*light, v) ==
              relative(2.0 * v * 4.0 / 9.0 * std::pow(1.0 - e / 9.0, 3.0), 1e-12));
    }
    CHECK(energy_density(*all, 9.1) == 0.0);
    CHECK(energy_density(*all, -0.1) == 0.0);
    CHECK(speed_density(*all, -0.1) == 0.0);
}

TEST_CASE("two particles share the energy uniformly") {
    const State s = gas_of(2, Wall::solid);
    const auto gas = test::equilibrium(s.box, s.particles, s.sample);
    REQUIRE(gas.has_value());
    CHECK(energy_density(*gas, 0.0) == relative(1.0 / 9.0, 1e-12));
    CHECK(energy_density(*gas, 9.0) == relative(1.0 / 9.0, 1e-12));
}

TEST_CASE("there is no curve where nothing tends to it") {
    const auto none = [](const State& s) {
        return !test::equilibrium(s.box, s.particles, s.sample).has_value();
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
    const auto gas = test::equilibrium(s.box, s.particles, s.sample);
    REQUIRE(gas.has_value());
    CHECK(gas->groups.size() <= 1025);
    double exact = 0.0;  // in the limit of many particles m v / T exp(-m v^2 / 2T)
    const double t = gas->energy / 5000.0, v = 0.04;
    for (const double w : s.particles.inverse_mass)
        exact += v / (w * t) * std::exp(-v * v / (2.0 * w * t)) / 5000.0;
    CHECK(speed_density(*gas, v) == relative(exact, 2e-3));
}

namespace {

// A component of the first particle's velocity in `samples` states spread evenly over the energy
// sphere: normal numbers in units of the thermal velocity, without the drift where momentum is
// fixed, brought to the energy. The slow, obvious way.
std::vector<double> components_on_sphere(const std::vector<double>& masses, int dimension,
                                         bool momentum_fixed, double energy, int samples) {
    Random random(11, "velocity on the energy sphere");
    const auto count = static_cast<Eigen::Index>(masses.size());
    const Eigen::ArrayXd mass = Eigen::Map<const Eigen::ArrayXd>(masses.data(), count);
    std::vector<double> found;
    for (int s = 0; s < samples; ++s) {
        Eigen::ArrayXXd v(count, dimension);
        for (double& one : v.reshaped()) one = random.normal();
        for (int a = 0; a < dimension; ++a) {
            v.col(a) /= mass.sqrt();
            if (momentum_fixed) v.col(a) -= (mass * v.col(a)).sum() / mass.sum();
        }
        const double now = 0.5 * (mass * v.square().rowwise().sum()).sum();
        found.push_back(v(0, 0) * std::sqrt(energy / now));
    }
    return found;
}

std::function<double(double)> below(const EquilibriumGas& gas, double fastest) {
    constexpr int steps = 20'000;
    const double step = 2.0 * fastest / steps;
    std::vector<double> sums{0.0};   // at the end of each step
    for (int i = 0; i < steps; ++i)  // the middle of each
        sums.push_back(sums.back() + velocity_density(gas, -fastest + (i + 0.5) * step) * step);
    return [sums, fastest, step](double v) {
        const double at = std::clamp((v + fastest) / step, 0.0, double(steps));
        const auto i = std::min(static_cast<std::size_t>(at), std::size_t{steps - 1});
        return sums[i] + (at - static_cast<double>(i)) * (sums[i + 1] - sums[i]);
    };
}

}  // namespace

TEST_CASE("a component of velocity is that of points spread evenly over the energy sphere") {
    struct Case {
        std::vector<double> masses;
        int dimension;
        Wall wall;
    };
    const std::vector<Case> cases{
        {{2.0, 2.0, 2.0}, 2, Wall::solid},           {{5.0, 1.0, 2.0, 3.0}, 2, Wall::solid},
        {{2.0, 1.0, 4.0}, 2, Wall::periodic},        {{3.0, 1.0, 2.0}, 1, Wall::solid},
        {{3.0, 1.0, 2.0, 2.0, 7.0}, 1, Wall::solid}, {{3.0, 1.0, 2.0, 5.0}, 1, Wall::periodic}};
    constexpr double energy = 6.0;
    for (const Case& one : cases) {
        const auto count = static_cast<Eigen::Index>(one.masses.size());
        CAPTURE(count);
        CAPTURE(one.dimension);
        const bool periodic = one.wall == Wall::periodic;
        State s = line_of(one.masses, one.wall);
        if (one.dimension == 2) {
            s.box = {2, {10.0, 10.0}, {one.wall, one.wall}};
            s.particles.radius = Eigen::ArrayXd::Constant(count, 0.1);
            s.sample.velocity = Eigen::ArrayXXd::Zero(count, 2);
            s.sample.velocity(0, 1) = 1.0;
            if (periodic) s.sample.velocity(1, 1) = -one.masses[0] / one.masses[1];
        }
        const Eigen::ArrayXd speed = s.sample.velocity.square().rowwise().sum().sqrt();
        s.sample.velocity *=
            std::sqrt(energy / (0.5 * speed.square() / s.particles.inverse_mass).sum());
        const auto whole = test::equilibrium(s.box, s.particles, s.sample);
        REQUIRE(whole.has_value());
        const auto first = among(*whole, s.particles, {0});
        REQUIRE(first.has_value());
        REQUIRE(first->groups.size() == 1);
        const std::vector<double> found =
            components_on_sphere(one.masses, one.dimension, periodic, energy, 4000);
        const double fastest =
            std::sqrt(2.0 * first->groups[0].largest_share[0] * energy / one.masses[0]);
        // Six tests: one in a thousand overall.
        CHECK(test::chance(found, below(*first, fastest)) > 1e-3 / 6);
        CHECK(below(*first, fastest)(fastest) == relative(1.0, 1e-4));
    }
}

TEST_CASE("in one dimension a speed is a component of velocity of either sign") {
    const EquilibriumGas gas{9.0, 0.5, 2.5, {{1.0, 2.0}, {4.0, 1.0}}};
    for (const double v : {0.1, 0.7, 1.9, 2.5, 4.0})
        CHECK(2.0 * velocity_density(gas, v) == relative(speed_density(gas, v), 1e-12));
    CHECK(velocity_density(gas, -0.7) == velocity_density(gas, 0.7));
    CHECK(velocity_density(gas, 5.0) == 0.0);
}

TEST_CASE("among all particles the equilibrium is the same, and among none there is none") {
    State s = line_of({3.0, 1.0, 2.0, 5.0}, Wall::periodic);
    const auto whole = test::equilibrium(s.box, s.particles, s.sample);
    const auto all = among(whole.value(), s.particles, {0, 1, 2, 3});
    REQUIRE(all.has_value());
    REQUIRE(all->groups.size() == whole->groups.size());
    for (std::size_t k = 0; k < all->groups.size(); ++k) {
        CHECK(all->groups[k].mass == whole->groups[k].mass);
        CHECK(all->groups[k].largest_share == whole->groups[k].largest_share);
    }
    s.particles.inverse_mass[2] = 0.0;
    CHECK(!among(*whole, s.particles, {2}).has_value());
    CHECK(!among(*whole, s.particles, {}).has_value());
}
