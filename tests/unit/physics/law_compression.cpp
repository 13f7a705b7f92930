// The laws of a gas that a side squeezes, against closed forms and integrals of equations of state.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <tuple>

#include "physics/gas.h"
#include "physics/placement/placement.h"
#include "physics/theory/law.h"
#include "support/gas_states.h"
#include "support/heating.h"
#include "support/relative.h"

using namespace carom;
using std::numbers::pi;
using test::disks;
using test::GasState;
using test::heating_at;
using test::relative;
using test::state_named;

namespace {

// Disks of radius 0.3 that begin with this packing in a box with this side along y.
GasState dense_state(int count, double packing, double height, Walls walls) {
    GasState s = state_named("closed");
    s.gas.box.size = {count * pi * 0.09 / packing / height, height};
    s.gas.box.walls = walls;
    s.gas.species = {disks(count)};
    std::tie(s.particles, s.start) = place(s.gas);
    return s;
}

}  // namespace

TEST_CASE("the adiabat of disks between periodic sides is that of their equation of state") {
    // Of Henderson's the excess free energy is 9/8 eta / (1 - eta) - 7/8 ln(1 - eta) for each disk.
    const GasState s = dense_state(150, 0.1, 20.0, {Wall::periodic, Wall::periodic});
    const auto entropy = [](double eta) {
        return std::log(eta) + 9.0 / 8.0 * eta / (1.0 - eta) - 7.0 / 8.0 * std::log1p(-eta);
    };
    const double freedoms = 2.0 * 150 - 2.0;
    for (const double ratio : {0.2, 0.4, 0.9, 1.0, 3.0}) {
        CAPTURE(ratio);
        const double expected = 300.0 / freedoms * (entropy(0.1 / ratio) - entropy(0.1));
        CHECK(std::abs(heating_at(s, 20.0 * ratio, EquationOfState::simple) - expected) < 1e-7);
    }
    // Another fit, of H. Liu (arXiv 2010.10624, equation 1), integrated in small steps.
    double expected = 0.0;
    constexpr int steps = 20'000;
    for (int k = 0; k < steps; ++k) {
        const double eta = 0.1 * std::pow(5.0, (k + 0.5) / steps), free = 1.0 - eta;
        const double z =
            (1.0 + eta * eta / 8.0 + std::pow(eta, 3) / 18.0 - 4.0 / 21.0 * std::pow(eta, 4)) /
            (free * free);
        expected += 300.0 / freedoms * z * std::log(5.0) / steps;
    }
    CHECK(heating_at(s, 4.0, EquationOfState::accurate) == relative(expected, 3e-4));
    // Beyond freezing there is none.
    GasState frozen = s;
    frozen.asked.surface = 3;
    frozen.asked.lengths = {2.0, 2.5, 4.0};
    const Law found = law(frozen.boxed(), LawOf::adiabat, frozen.asked);
    CHECK(std::isnan(found.curve[0]));
    CHECK(std::isnan(found.temperatures[1]));
    CHECK(found.curve[2] > 0.0);
}

TEST_CASE("the adiabat of dilute disks between walls is that of their configuration integral") {
    // To second order in the density: the pairs that overlap between four walls.
    const GasState s = dense_state(60, 0.01, 12.0, {Wall::solid, Wall::solid});
    const double width = s.gas.box.size[0] - 0.6;
    const auto logarithm = [&](double height) {
        const double b = height - 0.6, d = 0.6;
        const double overlap = pi * d * d * width * b - 4.0 / 3.0 * std::pow(d, 3) * (width + b) +
                               0.5 * std::pow(d, 4);
        return 60.0 * std::log(width * b) +
               0.5 * 60.0 * 59.0 * std::log1p(-overlap / std::pow(width * b, 2));
    };
    for (const double height : {6.0, 24.0}) {
        const double expected = -2.0 / 120.0 * (logarithm(height) - logarithm(12.0));
        CHECK(heating_at(s, height, EquationOfState::accurate) == relative(expected, 0.002));
    }
}

TEST_CASE("isotherms and adiabats of points, rods and unequal disks") {
    GasState rods = state_named("line");
    rods.asked.surface = 1;
    rods.asked.lengths = {8.0, 30.0};
    const double t = rods.value_of(LawOf::temperature), free = 20.0 - 5 * 0.6;
    const Law isotherm = law(rods.boxed(), LawOf::isotherm, rods.asked);
    const Law adiabat = law(rods.boxed(), LawOf::adiabat, rods.asked);
    for (const std::size_t k : {0, 1}) {
        const double left = rods.asked.lengths[k] - 3.0;
        CHECK(isotherm.curve[k] == relative(5.0 * t / left, 1e-13));
        CHECK(adiabat.temperatures[k] == relative(t * std::pow(free / left, 2), 1e-6));
        CHECK(adiabat.curve[k] == relative(5.0 * adiabat.temperatures[k] / left, 1e-13));
    }
    GasState s = dense_state(60, 0.3, 12.0, {Wall::solid, Wall::solid});
    s.particles.radius[0] = 0.29;
    s.asked.surface = 3;
    s.asked.lengths = {6.0};
    CHECK(law(s.boxed(), LawOf::adiabat, s.asked).none->why == NoLaw::Why::unequal_radii);
    s.asked.as_points = true;
    const Law ideal = law(s.boxed(), LawOf::adiabat, s.asked);
    CHECK(ideal.temperatures[0] == relative(2.0 * s.value_of(LawOf::temperature), 1e-13));
    CHECK(ideal.curve[0] ==
          relative(2.0 * 120.0 * s.value_of(LawOf::temperature) / (2.0 * 6.0 * s.gas.box.size[0]),
                   1e-13));
}
