// The values of the laws, against means over states that are drawn at random, closed forms and
// independent counts.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <numbers>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "physics/box.h"
#include "physics/gas.h"
#include "physics/placement/placement.h"
#include "physics/theory/law.h"
#include "support/gas_states.h"
#include "support/relative.h"
#include "util/random.h"

using namespace carom;
using std::numbers::pi;
using test::disks;
using test::GasState;
using test::relative;
using test::state_named;

namespace {

// Velocities with the energy and the momenta of a state, uniformly distributed: independent normal
// momenta, without their sum along conserved axes, at the same energy. The slow, obvious way.
class Shuffled {
  public:
    explicit Shuffled(const GasState& s)
        : masses_((s.particles.inverse_mass > 0.0).select(s.particles.inverse_mass.inverse(), 0.0)),
          start_(s.start.velocity),
          random_(17, "shuffled velocities") {
        const bool are_finite = (masses_ > 0.0).all();
        for (int axis = 0; axis < s.gas.box.dimension; ++axis)
            conserves_.push_back(are_finite && s.gas.box.is_periodic(axis));
        for (Eigen::Index axis = 0; axis < start_.cols(); ++axis)
            drift_.push_back(conserves_[std::size_t(axis)] ? mean(start_.col(axis)) : 0.0);
    }

    Eigen::ArrayXXd next() {
        Eigen::ArrayXXd v(start_.rows(), start_.cols());
        double wanted = 0.0, found = 0.0;
        for (Eigen::Index axis = 0; axis < v.cols(); ++axis) {
            for (Eigen::Index i = 0; i < v.rows(); ++i)
                v(i, axis) = masses_[i] > 0.0 ? random_.normal() / std::sqrt(masses_[i]) : 0.0;
            if (conserves_[std::size_t(axis)]) v.col(axis) -= mean(v.col(axis));
            wanted += (masses_ * (start_.col(axis) - drift_[std::size_t(axis)]).square()).sum();
            found += (masses_ * v.col(axis).square()).sum();
        }
        v *= std::sqrt(wanted / found);
        for (Eigen::Index axis = 0; axis < v.cols(); ++axis)
            for (Eigen::Index i = 0; i < v.rows(); ++i)
                if (masses_[i] > 0.0) v(i, axis) += drift_[std::size_t(axis)];
        return v;
    }

  private:
    double mean(const Eigen::ArrayXd& v) const { return (masses_ * v).sum() / masses_.sum(); }

    Eigen::ArrayXd masses_;
    Eigen::ArrayXXd start_;
    std::vector<bool> conserves_;
    std::vector<double> drift_;
    Random random_;
};

// A mean over samples that agrees with a value within four standard errors.
struct Sampled {
    double count = 0.0, sum = 0.0, squares = 0.0;
    void add(double x) {
        count += 1.0;
        sum += x;
        squares += x * x;
    }
    double mean() const { return sum / count; }
    double error() const {
        return std::sqrt(std::max(0.0, squares / count - mean() * mean()) / count);
    }
    void check(double value) const {
        CHECK(std::abs(mean() - value) <= 4.0 * error() + 1e-9 * std::abs(value));
    }
};

}  // namespace

TEST_CASE("mean energies and speeds are those of uniform points on the sphere of the energy") {
    for (const std::string name :
         {"closed",     "periodic",   "half",          "mixture",   "fixed",
          "reversed",   "two",        "two-free",      "drifts",    "line",
          "ring",       "not-yet",    "one",           "space",     "space-periodic",
          "space-half", "space-pipe", "space-mixture", "space-one", "space-two-free"}) {
        CAPTURE(name);
        GasState s = state_named(name);
        const std::vector<Eigen::Index> first{0}, last{s.particles.count() - 1};
        for (const std::vector<Eigen::Index>& list : {first, last}) {
            if (s.particles.inverse_mass[list[0]] == 0.0) continue;
            s.asked.of = list;
            const double mass = 1.0 / s.particles.inverse_mass[list[0]];
            Shuffled shuffled(s);
            Sampled energy, speed;
            for (int k = 0; k < 20'000; ++k) {
                const double square = shuffled.next().row(list[0]).square().sum();
                energy.add(0.5 * mass * square);
                speed.add(std::sqrt(square));
            }
            energy.check(s.value_of(LawOf::mean_energy));
            if (law(s.boxed(), LawOf::mean_speed, s.asked))
                speed.check(s.value_of(LawOf::mean_speed));
        }
    }
}

TEST_CASE("of ten light disks and a heavy one in a periodic box, the heavy one has less energy") {
    GasState s = state_named("mixture");
    const double temperature = kinetic_energies(s.particles, s.start).sum() / 10.0;  // E / (N - 1)
    CHECK(s.value_of(LawOf::temperature) == relative(temperature, 1e-12));
    s.asked.of = {{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}};
    CHECK(s.value_of(LawOf::mean_energy) == relative(temperature * (1.0 - 1.0 / 30.0), 1e-12));
    s.asked.of = {{10}};
    CHECK(s.value_of(LawOf::mean_energy) == relative(temperature * (1.0 - 20.0 / 30.0), 1e-12));
}

TEST_CASE("densities of a box that is periodic along some axes are those of the sphere") {
    for (const auto& [name, count] :
         {std::pair{"half", 3}, {"half", 20}, {"space-half", 20}, {"space-pipe", 20}}) {
        CAPTURE(name);
        CAPTURE(count);
        GasState s = state_named(name);
        if (count < 20) {
            s.gas.species = {disks(count)};
            std::tie(s.particles, s.start) = place(s.gas);
        }
        const int dimension = s.gas.box.dimension;
        const EquilibriumGas gas = *law(s.boxed(), LawOf::distribution).equilibrium;
        Shuffled shuffled(s);
        std::array<Sampled, 6> below;  // of energy, speed, component along x, y, any axis, z
        const double e = 0.6 * gas.energy / count, v = std::sqrt(2.0 * e);
        for (int k = 0; k < 40'000; ++k) {
            const Eigen::ArrayXd u = shuffled.next().row(0);
            below[0].add(0.5 * u.square().sum() < e);
            below[1].add(std::sqrt(u.square().sum()) < v);
            below[2].add(std::abs(u[0]) < v);
            below[3].add(std::abs(u[1]) < v);
            below[4].add((u.abs() < v).cast<double>().sum() / dimension);
            if (dimension == 3) below[5].add(std::abs(u[2]) < v);
        }
        const auto integral = [](double end, const std::function<double(double)>& f) {
            constexpr int steps = 2000;
            double sum = 0.0;
            for (int k = 0; k < steps; ++k) sum += f(end * (k + 0.5) / steps) * end / steps;
            return sum;
        };
        below[0].check(integral(e, [&](double x) { return energy_density(gas, x); }));
        below[0].check(energy_probability(gas, 0.0, e));
        below[1].check(integral(v, [&](double x) { return speed_density(gas, x); }));
        below[2].check(2.0 * integral(v, [&](double x) { return velocity_density(gas, x, 0); }));
        below[3].check(2.0 * integral(v, [&](double x) { return velocity_density(gas, x, 1); }));
        below[4].check(2.0 * integral(v, [&](double x) { return velocity_density(gas, x); }));
        if (dimension == 3)
            below[5].check(2.0 *
                           integral(v, [&](double x) { return velocity_density(gas, x, 2); }));
    }
}

TEST_CASE("the temperature is twice the energy per degree of freedom") {
    const std::map<std::string, double> freedoms{{"closed", 40},
                                                 {"periodic", 38},
                                                 {"half", 39},
                                                 {"mixture", 20},
                                                 {"fixed", 40},
                                                 {"reversed", 40},
                                                 {"one", 2},
                                                 {"two", 4},
                                                 {"two-free", 2},
                                                 {"points", 40},
                                                 {"line", 5},
                                                 {"ring", 4},
                                                 {"equals", 5},
                                                 {"space", 60},
                                                 {"space-half", 59},
                                                 {"space-pipe", 58},
                                                 {"space-periodic", 57},
                                                 {"space-one", 3},
                                                 {"space-two-free", 3},
                                                 {"space-mixture", 72}};
    for (const auto& [name, count] : freedoms) {
        CAPTURE(name);
        const GasState s = state_named(name);
        const BoxedGas gas = s.boxed();
        double energy = kinetic_energies(s.particles, s.start).sum();
        energy -= 0.5 * gas.mass * square(gas.drift);
        CHECK(s.value_of(LawOf::temperature) == relative(2.0 * energy / count, 1e-12));
    }
    const GasState bath = state_named("bath");
    CHECK(bath.value_of(LawOf::temperature) == 2.0);
    CHECK(bath.value_of(LawOf::bath) == 2.0);
    CHECK(bath.value_of(LawOf::mean_energy) == 2.0);  // 2 d / 2
    CHECK(bath.value_of(LawOf::mean_speed) == relative(std::sqrt(pi), 1e-14));
    const GasState in_space = state_named("space-bath");
    CHECK(in_space.value_of(LawOf::mean_energy) == 3.0);
    CHECK(in_space.value_of(LawOf::mean_speed) == relative(4.0 / std::sqrt(pi), 1e-14));
}

TEST_CASE("few particles collide as often as their exact relative speed says") {
    // Two disks whose momentum is conserved are one point among disks: 2 s v / (A - pi s^2).
    const GasState s = state_named("two-free");
    const Eigen::ArrayXd apart = s.start.velocity.row(0) - s.start.velocity.row(1);
    const double v = std::sqrt(apart.square().sum()), contact = 0.6;
    CHECK(s.value_of(LawOf::collision_rate) ==
          relative(2.0 * contact * v / (300.0 - pi * contact * contact), 0.005));
    CHECK(mean_speed_factor(2.0) == relative(std::sqrt(4.0 / pi), 1e-14));
    CHECK(mean_speed_factor(1e6) == relative(1.0, 1e-6));
}

TEST_CASE("pressures and the contact value are the closed forms") {
    for (const std::string name : {"closed", "periodic", "points"}) {
        const GasState s = state_named(name);
        const double energy = s.boxed().thermal.energy;
        CHECK(s.value_of(LawOf::ideal_pressure) == relative(energy / 300.0, 1e-13));
    }
    for (const std::string name : {"space", "space-periodic", "space-points"}) {
        const GasState s = state_named(name);
        CHECK(s.value_of(LawOf::ideal_pressure) ==
              relative(2.0 / 3.0 * s.boxed().thermal.energy / 3600.0, 1e-13));
    }
    const GasState rods = state_named("line");
    const double twice = 2.0 * kinetic_energies(rods.particles, rods.start).sum();
    CHECK(rods.value_of(LawOf::ideal_pressure) == relative(twice / 20.0, 1e-13));
    CHECK(rods.value_of(LawOf::pressure) == relative(twice / (20.0 - 5 * 0.6), 1e-13));
    const double eta = 20 * pi * 0.09 / 300.0;
    CHECK(state_named("closed").value_of(LawOf::contact) ==
          relative((1.0 - 7.0 / 16.0 * eta) / ((1.0 - eta) * (1.0 - eta)), 1e-12));
}

TEST_CASE("where walls bound displacements, these level off at twice the variance of a place") {
    CHECK(state_named("closed").value_of(LawOf::displacement) ==
          relative((19.4 * 19.4 + 14.4 * 14.4) / 6.0, 1e-13));
    CHECK(state_named("space").value_of(LawOf::displacement) ==
          relative((19.4 * 19.4 + 14.4 * 14.4 + 11.4 * 11.4) / 6.0, 1e-13));
    // Along a periodic axis they grow for ever, and one particle alone goes to and fro.
    for (const std::string name :
         {"half", "one", "baths", "gravity", "obstacle", "space-pipe", "space-one"}) {
        CAPTURE(name);
        CHECK(std::isnan(state_named(name).value_of(LawOf::displacement)));
    }
    // Beads keep their order: places in rising order, drawn twice.
    Random random(5, "places in order");
    Sampled squares;
    for (int k = 0; k < 20'000; ++k) {
        std::array<std::vector<double>, 2> places;
        for (std::vector<double>& each : places) {
            for (int i = 0; i < 5; ++i) each.push_back(random.uniform(0.0, 20.0 - 5 * 0.6));
            std::ranges::sort(each);
        }
        double sum = 0.0;
        for (std::size_t i = 0; i < 5; ++i) sum += std::pow(places[1][i] - places[0][i], 2);
        squares.add(sum / 5.0);
    }
    squares.check(state_named("line").value_of(LawOf::displacement));
}

TEST_CASE("the slope of the autocorrelation has the factor of finite numbers") {
    for (const std::string name :
         {"two", "mixture", "half", "line", "ring", "space", "space-mixture"}) {
        CAPTURE(name);
        GasState s = state_named(name);
        const Eigen::Index i = 0, j = s.particles.count() - 1;
        s.asked.of = {{i}};
        const double m = 1.0 / s.particles.inverse_mass[i],
                     other = 1.0 / s.particles.inverse_mass[j];
        const double mu = m * other / (m + other), d = s.gas.box.dimension;
        // At collisions with normals of any direction, weighted with the speed of approach g.
        Shuffled shuffled(s);
        Random random(3, "normals");
        Sampled lost, speed, square;
        for (int k = 0; k < 60'000; ++k) {
            const Eigen::ArrayXXd v = shuffled.next();
            Eigen::RowVectorXd normal(v.cols());
            for (double& component : normal) component = random.normal();
            normal /= normal.norm();
            const double own = normal.dot(v.row(i).matrix());
            const double g = own - normal.dot(v.row(j).matrix());
            lost.add(std::abs(g) * 2.0 * mu / m * g * own);
            speed.add(std::abs(g));
            square.add(v.row(i).square().sum());
        }
        const double found = lost.mean() / speed.mean() / square.mean();
        // Three means, each within four standard errors at most.
        const double error = 4.0 * (lost.error() / lost.mean() + speed.error() / speed.mean() +
                                    square.error() / square.mean());
        CHECK(found ==
              relative(s.value_of(LawOf::autocorrelation) * 4.0 / d * other / (m + other), error));
    }
}

TEST_CASE("laws of lines, halves, heights and billiards") {
    for (const std::string name : {"half", "space-half", "space-pipe"}) {
        CAPTURE(name);
        const GasState s = state_named(name);
        Shuffled shuffled(s);
        Sampled rate, energy;
        for (int k = 0; k < 20'000; ++k) {
            const Eigen::ArrayXXd v = shuffled.next();
            const Eigen::ArrayXd crossing = 0.5 * v.col(1).abs() / 14.4;
            rate.add(crossing.sum());
            energy.add((crossing * 0.5 * v.square().rowwise().sum()).sum());
        }
        const Law flux = law(s.boxed(), LawOf::flux, s.asked);
        rate.check(flux.value);
        energy.check(flux.energy);
    }

    for (const std::string name : {"gap", "space-gap"}) {
        CAPTURE(name);
        const GasState gap = state_named(name);
        CHECK(gap.value_of(LawOf::side_count) == 10.0);
        const double energy = gap.value_of(LawOf::side_energy);
        CHECK(energy == relative(kinetic_energies(gap.particles, gap.start).mean(), 1e-13));
        CHECK(gap.value_of(LawOf::side_temperature) ==
              relative(2.0 * energy / gap.gas.box.dimension, 1e-13));
    }
    // Of points half the number has the variance N / 4; 20 spheres cover 0.0006 of their box.
    CHECK(law(state_named("space-gap").boxed(), LawOf::side_count, {.surface = 6}).deviation ==
          relative(std::sqrt(5.0 * (1.0 - 8.0 * 20.0 * 0.113097 / 3600.0)), 1e-5));

    const GasState falling = state_named("gravity");
    double all = 0.0;
    for (const double density : law(falling.boxed(), LawOf::heights, falling.asked).curve)
        all += density * 300.0 / 4.0;
    CHECK(all == relative(20.0, 1e-9));

    // Pi times the area that its centre can reach, over the perimeter of that.
    const double area = 19.4 * 14.4 - pi * 1.8 * 1.8;
    const double perimeter = 2.0 * (19.4 + 14.4) + 2.0 * pi * 1.8;
    CHECK(state_named("billiard").value_of(LawOf::free_flight) ==
          relative(pi * area / perimeter, 1e-13));
}

TEST_CASE("the entropy of velocities in equilibrium is that of an independent count") {
    for (const std::string name : {"closed", "periodic", "half", "space", "space-pipe"}) {
        CAPTURE(name);
        const GasState s = state_named(name);
        const bool is_space = s.gas.box.dimension == 3;
        const Law found = law(s.boxed(), LawOf::velocity_entropy);
        CHECK(found.error > 0.0);
        CHECK(found.error < (is_space ? 7e-4 : 5e-4));  // in space by the limit of its time
        Shuffled shuffled(s);
        const double thermal = std::sqrt(s.boxed().thermal.temperature());
        Sampled entropy;
        for (int k = 0; k < 20'000; ++k) {
            const Eigen::ArrayXXd v = shuffled.next() / thermal;
            // Along each axis from -4 to 4 six in a plane, three in space.
            std::map<std::tuple<int, int, int>, double> cells;
            const auto cell = [&](double u) {
                return is_space ? std::clamp(int(std::floor(0.375 * u + 0.5)), -1, 1)
                                : std::clamp(int(std::floor(0.75 * u)), -3, 2);
            };
            for (Eigen::Index i = 0; i < v.rows(); ++i)
                cells[{cell(v(i, 0)), cell(v(i, 1)), is_space ? cell(v(i, 2)) : 0}] += 1.0;
            double sum = 0.0;
            for (const auto& [place, n] : cells) sum -= n / 20.0 * std::log(n / 20.0);
            entropy.add(sum);
        }
        CHECK(std::abs(entropy.mean() - found.value) <
              4.0 * std::hypot(entropy.error(), found.error));
    }
}

TEST_CASE("the entropy of places is that of an independent count") {
    for (const auto& [name, cells] : {std::pair{"closed", 12}, {"space", 24}}) {  // 4 x 3 (x 2)
        CAPTURE(name);
        Random random(9, "points in cells");
        Sampled entropy;
        for (int k = 0; k < 20'000; ++k) {
            std::vector<double> found(static_cast<std::size_t>(cells), 0.0);
            for (int i = 0; i < 20; ++i)
                found[random.below(static_cast<std::uint64_t>(cells))] += 1.0;
            double sum = 0.0;
            for (const double n : found)
                if (n > 0.0) sum -= n / 20.0 * std::log(n / 20.0);
            entropy.add(sum);
        }
        entropy.check(state_named(name).value_of(LawOf::position_entropy));
    }
}

TEST_CASE("a Galton board has the binomial distribution of its rows") {
    // Pegs at every fourth place, three rows, and walls between bins under the gaps of the last.
    GasState s = state_named("gravity");
    const auto peg = [&](double x, double y) {
        s.gas.box.surfaces.obstacles.push_back({"", Obstacle::Ball{{x, y}, 0.2}});
    };
    for (const double x : {2.0, 6.0, 10.0, 14.0, 18.0}) peg(x, 10.0), peg(x, 6.0);
    for (const double x : {4.0, 8.0, 12.0, 16.0}) {
        peg(x, 8.0);
        s.gas.box.surfaces.obstacles.push_back({"", Obstacle::Lines{{{x, 0.0}, {x, 3.0}}, false}});
    }
    s.gas.species = {disks(1)};
    s.asked.axis = 0;
    const auto found_from = [&](double x) {
        s.start.position.row(0) << x, 14.0;
        return law(s.boxed(), LawOf::binomial, s.asked);
    };
    std::tie(s.particles, s.start) = place(s.gas);
    // Over a peg of the first row there are four choices, over a gap three.
    const Law four = found_from(10.3), three = found_from(11.8);
    CHECK(four.places == std::vector{2.0, 6.0, 10.0, 14.0, 18.0});
    CHECK(four.curve == std::vector{0.0625, 0.25, 0.375, 0.25, 0.0625});
    CHECK(three.places == std::vector{6.0, 10.0, 14.0, 18.0});
    CHECK(three.curve == std::vector{0.125, 0.375, 0.375, 0.125});
    s.gas.box.surfaces.obstacles.pop_back();  // one of the walls, at the end
    CHECK(found_from(10.3));
    peg(8.5, 8.0);
    CHECK(found_from(10.3).none->why == NoLaw::Why::no_board);
}
