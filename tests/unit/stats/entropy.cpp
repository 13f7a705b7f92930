#include "stats/entropy.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "physics/theory/even_spread.h"
#include "physics/theory/law.h"
#include "physics/theory/velocity_entropy.h"
#include "stats/run_statistics.h"
#include "support/equilibrium.h"
#include "support/relative.h"
#include "util/random.h"

using namespace carom;
using test::relative;

namespace {

Particles alike(Eigen::Index count) {
    return {Eigen::ArrayXd::Constant(count, 0.5), Eigen::ArrayXd::Ones(count),
            Eigen::ArrayXi::Zero(count)};
}

// Half of them to the right, half to the left.
Eigen::ArrayXXd two_beams(Eigen::Index count) {
    Eigen::ArrayXXd velocity = Eigen::ArrayXXd::Zero(count, 2);
    velocity.col(0).head(count / 2) = 1.0;
    velocity.col(0).tail(count / 2) = -1.0;
    return velocity;
}

ThermalMotion motion_of(const Particles& particles, const Eigen::ArrayXXd& velocity) {
    Box box;
    box.size = {10.0, 10.0};
    return thermal_motion(box, particles, {0.0, velocity, velocity});
}

double entropy_of(const Particles& particles, const Eigen::ArrayXXd& velocity) {
    return VelocityEntropy(particles, motion_of(particles, velocity)).of(velocity);
}

}  // namespace

TEST_CASE("kinds are told apart by mass and radius, and by nothing else") {
    Particles particles = alike(7);
    particles.radius[1] = particles.radius[3] = 0.25;
    particles.inverse_mass[2] = 0.5;
    particles.inverse_mass[5] = 0.0;
    particles.species[4] = 3;
    const Kinds kinds = kinds_of(particles);
    CHECK((kinds.of == Eigen::ArrayXi{{0, 1, 2, 1, 0, 3, 0}}).all());
    CHECK(kinds.members == std::vector<int>{3, 2, 1, 1});
}

TEST_CASE("particles of which each is different are one kind, walls apart") {
    Particles particles = alike(4);
    particles.radius = Eigen::ArrayXd{{0.1, 0.2, 0.3, 0.4}};
    particles.inverse_mass[2] = 0.0;
    CHECK((kinds_of(particles).of == Eigen::ArrayXi{{0, 0, 1, 0}}).all());
}

TEST_CASE("the entropy of two beams is ln 2, whatever they are called") {
    Particles particles = alike(100);
    const Eigen::ArrayXXd beams = two_beams(100);
    const double one_name = entropy_of(particles, beams);
    CHECK(one_name == relative(std::log(2.0), 1e-14));
    particles.species.tail(50) = 1;
    CHECK(entropy_of(particles, beams) == one_name);
    particles.inverse_mass.tail(50) = 0.5;  // two gases, each of which moves alike
    CHECK(entropy_of(particles, beams) == 0.0);
}

TEST_CASE("thermal velocities have the entropy of equilibrium, names apart") {
    Particles particles = alike(2000);
    particles.inverse_mass.tail(1000) = 0.25;
    Eigen::ArrayXXd velocity(2000, 2);
    Random random(7, "velocities");
    for (double& v : velocity.reshaped()) v = random.normal();
    velocity.colwise() *= particles.inverse_mass.sqrt();
    const VelocityEntropy entropy(particles, motion_of(particles, velocity));
    Box box;
    box.size = {10.0, 10.0};
    const double expected =
        law(BoxedGas(box, {}, particles, {0.0, velocity, velocity}), LawOf::velocity_entropy).value;
    // Of 1000 in 400 cells or so the entropy varies by some 1 %.
    CHECK(entropy.of(velocity) == relative(expected, 0.02));
    particles.species.tail(500) = 1;
    const VelocityEntropy renamed(particles, motion_of(particles, velocity));
    CHECK(renamed.of(velocity) == entropy.of(velocity));
    CHECK(law(BoxedGas(box, {}, particles, {0.0, velocity, velocity}), LawOf::velocity_entropy)
              .value == expected);
}

TEST_CASE("no number of a gas depends on how its species are called or parted") {
    Particles particles = alike(100);
    particles.inverse_mass.tail(40) = 0.25;
    Eigen::ArrayXXd position(100, 2), velocity(100, 2);
    Random random(11, "a gas");
    for (Eigen::Index i = 0; i < 100; ++i) {
        position.row(i) << 1.0 + 2.0 * double(i % 10), 1.0 + 2.0 * double(i / 10);
        velocity.row(i) << random.normal(), random.normal();
    }
    const Sample sample{0.0, position, velocity};
    Box box;
    box.size = {20.0, 20.0};
    const auto numbers = [&](int species) {
        RunStatistics statistics(box, particles, species, 1);
        statistics.see(sample);
        const RunSummary run = statistics.summary({});
        const ThermalMotion motion = thermal_motion(box, particles, sample);
        const auto gas = test::equilibrium(box, particles, sample);
        REQUIRE(gas);
        return std::vector<double>{
            run.temperature.value(),
            run.energy_final.value(),
            run.virial_pressure.value_or(0.0),  // of no time
            motion.temperature(),
            VelocityEntropy(particles, motion).of(velocity),
            law(BoxedGas(box, {}, particles, sample), LawOf::collision_rate).value,
            mean_speed(*gas),
            speed_density(*gas, 0.5)};
    };
    particles.species.tail(40) = 1;
    const std::vector<double> as_two = numbers(2);
    particles.species = Eigen::ArrayXi::LinSpaced(100, 0, 99) / 10;
    CHECK(numbers(10) == as_two);
    particles.species.setZero();
    CHECK(numbers(1) == as_two);
}

TEST_CASE("the entropy of positions counts particles in cells") {
    Box box;
    box.size = {8.0, 4.0};
    Particles particles;
    particles.radius = Eigen::ArrayXd::Zero(5);
    particles.inverse_mass = Eigen::ArrayXd::Ones(5);
    particles.inverse_mass[4] = 0.0;  // a wall: not counted
    particles.species = Eigen::ArrayXi::Zero(5);
    const PositionEntropy entropy(box, particles, 2);
    REQUIRE(entropy.cells().all() == 2);
    Eigen::ArrayXXd position(5, 2);
    position << 1, 1, 2, 3, 3, 3, 1, 2, 7, 1;
    CHECK(entropy.of(position) == 0.0);
    position(0, 0) = 5.0;
    CHECK(std::abs(entropy.of(position) + 0.25 * std::log(0.25) + 0.75 * std::log(0.75)) < 1e-15);
    position(1, 0) = 9.0;  // beyond a side that has moved
    CHECK(std::abs(entropy.of(position) - std::log(2.0)) < 1e-15);

    // All 16 ways to put four into two cells, each as likely.
    double sum = 0.0;
    for (unsigned way = 0; way < 16; ++way) {
        for (Eigen::Index i = 0; i < 4; ++i) position(i, 0) = (way >> i) % 2 == 1 ? 1.0 : 5.0;
        sum += entropy.of(position);
    }
    CHECK(std::abs(entropy_of_even_spread(4.0, 2.0) - sum / 16.0) < 1e-14);
}
