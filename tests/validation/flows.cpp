// Validation of sound waves and shocks.
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "physics/gas.h"
#include "physics/mechanics.h"
#include "physics/simulation.h"
#include "validation/hard_fluids.h"
#include "validation/study.h"

namespace carom::validation {

namespace {

using std::numbers::pi;
constexpr const char* flows_field = "Sound and shocks";
constexpr const char* of_sirmas =
    "N. Sirmas et al., arXiv 1108.0879, with *Z* of Kolafa and Rottner in place of Helfand’s";

/// Disks of diameter 1 and mass 1 at T = 1.
Gas gas_in(double length, double width, double packing, std::uint64_t seed) {
    Gas gas;
    gas.seed = seed;
    gas.box.size = {length, width};
    gas.box.walls = {Wall::periodic, Wall::periodic};
    gas.species = {
        {.name = "",
         .count = static_cast<std::int64_t>(std::round(length * width * packing * 4.0 / pi)),
         .velocity = Temperature{1.0, true},
         .position = LatticePlaces{}}};
    return gas;
}

/// The square of the speed of sound is c^2 = T (Z + packing Z' + Z^2) / m, as the heat capacity per
/// disk is 1.
double speed_of_sound(double packing) {
    const auto fluid = [](double x) { return compressibility_of(2, x); };
    const double z = fluid(packing);
    return std::sqrt(z + packing * derivative(fluid, packing) + z * z);
}

/// The angular frequency w of a damped oscillation: fits (a cos wt + b sin wt) exp(-gt) to the
/// values by least squares (Levenberg-Marquardt).
double frequency(const Eigen::ArrayXd& times, const Eigen::ArrayXd& values, double guess) {
    Eigen::Vector4d best{values[0], 0.0, guess, 0.05 * guess};
    const auto residual = [&](const Eigen::Vector4d& p) -> Eigen::ArrayXd {
        return (p[0] * (p[2] * times).cos() + p[1] * (p[2] * times).sin()) * (-p[3] * times).exp() -
               values;
    };
    double damping = 1e-3, error = residual(best).square().sum();
    for (int step = 0; step < 60; ++step) {
        const Eigen::ArrayXd decay = (-best[3] * times).exp();
        const Eigen::ArrayXd cosine = (best[2] * times).cos() * decay;
        const Eigen::ArrayXd sine = (best[2] * times).sin() * decay;
        Eigen::MatrixXd slopes(times.size(), 4);
        slopes.col(0) = cosine;
        slopes.col(1) = sine;
        slopes.col(2) = times * (best[1] * cosine - best[0] * sine);
        slopes.col(3) = -times * (best[0] * cosine + best[1] * sine);
        Eigen::Matrix4d matrix = slopes.transpose() * slopes;
        matrix.diagonal() *= 1.0 + damping;
        const Eigen::Vector4d next =
            best - matrix.ldlt().solve(slopes.transpose() * residual(best).matrix());
        const double now = residual(next).square().sum();
        if (now < error) {
            best = next;
            error = now;
            damping *= 0.3;
        } else {
            damping *= 5.0;
        }
    }
    return best[2];
}

/// The phase velocity w / k of a standing wave of one wavelength in a box of this length.
double speed_of_wave(double length, double packing, const RunOf& run) {
    constexpr double amplitude = 0.15;
    const double area = std::max(1600.0, 12'000.0 * run.effort);
    const Gas gas = gas_in(length, area / length, packing, run.seed);
    Run how;
    how.equilibrate = 30.0;
    Simulation start(gas, how);
    Sample sample = start.sample();
    const double k = 2.0 * pi / length;
    sample.velocity.col(0) += amplitude * (k * sample.position.col(0)).sin();
    sample.time = 0.0;
    Simulation wave(gas.box, start.particles(), sample, {});
    const double guess = k * speed_of_sound(packing);
    constexpr int points = 80;
    Eigen::ArrayXd times(points), values(points);
    for (int i = 0; i < points; ++i) {
        times[i] = (0.1 + 2.4 * i / points) * 2.0 * pi / guess;
        wave.advance_to(times[i]);
        const Sample& now = wave.sample();
        values[i] = (now.velocity.col(0) * (k * now.position.col(0)).sin()).sum();
    }
    return frequency(times, values, guess) / k;
}

Study sound(double packing) {
    Study study;
    study.field = flows_field;
    study.runs = 40;
    if (packing == 0.2)
        study.how =
            "The frequency of a standing wave of one wavelength and amplitude 0.15 is measured in "
            "boxes of length 100 and 200 diameters; *ω*/*k* is extrapolated to *k* = 0 in *k*².";
    study.truths = {{std::string("speed of sound at packing ") + (packing == 0.2 ? "0.2" : "0.4") +
                         ", *T* = *m* = 1",
                     speed_of_sound(packing), 0.0, 0.0,
                     std::string("*c*² = (*T*/*m*)(*Z* + *η* d*Z*/d*η* + *Z*²): ") + of_sirmas}};
    study.measure = [=](const RunOf& run) {
        return std::vector<double>{
            (4.0 * speed_of_wave(200.0, packing, run) - speed_of_wave(100.0, packing, run)) / 3.0};
    };
    return study;
}

/// A steady shock that a piston drives into a gas at T = 1, from the Rankine-Hugoniot conditions.
struct Shock {
    double density, pressure, speed;  ///< density and pressure behind it; speed of the shock
};

Shock shock_of(double density, double piston) {
    const auto packing = [](double n) { return 0.25 * pi * n; };
    const double before = density * compressibility_of(2, packing(density));
    double low = density * 1.0001, high = 0.7 / packing(1.0);
    Shock shock{};
    while (high - low > 1e-12) {
        shock.density = 0.5 * (low + high);
        shock.speed = piston * shock.density / (shock.density - density);
        shock.pressure = before + density * shock.speed * piston;
        const double temperature =
            1.0 + 0.5 * (before + shock.pressure) * (1.0 / density - 1.0 / shock.density);
        const double gas =
            shock.density * temperature * compressibility_of(2, packing(shock.density));
        (gas < shock.pressure ? low : high) = shock.density;
    }
    return shock;
}

struct Regime {
    std::string name;
    double packing, piston, length, width;
};

/// Measures the pressure on the piston while the shock travels, and the density behind the shock.
std::vector<double> driven(const Regime& regime, const Shock& shock, std::uint64_t seed) {
    Gas gas = gas_in(regime.length, regime.width, regime.packing, seed);
    gas.box.walls = {Wall::solid, Wall::periodic};
    Run how;
    how.equilibrate = 40.0;
    Simulation start(gas, how);
    gas.box.surfaces.sides[0] = Driven{regime.piston};
    Sample sample = start.sample();
    sample.time = 0.0;
    Simulation simulation(gas.box, start.particles(), sample, {});
    const double end = 0.85 * regime.length / shock.speed, begin = 0.35 * end;
    simulation.advance_to(begin);
    const double before = simulation.surfaces()[0].impulse[0];
    simulation.advance_to(end);
    const double impulse = before - simulation.surfaces()[0].impulse[0];
    const double piston = regime.piston * end, way = (shock.speed - regime.piston) * end;
    const Eigen::ArrayXd x = simulation.sample().position.col(0);
    const double low = piston + 0.4 * way, high = piston + 0.8 * way;
    const auto inside = static_cast<double>((x > low && x < high).count());
    return {impulse / (regime.width * (end - begin)), inside / (regime.width * (high - low))};
}

Study shock(const Regime& regime) {
    Study study;
    study.field = flows_field;
    study.runs = 40;
    const double count = std::round(regime.length * regime.width * regime.packing * 4.0 / pi);
    const double density = count / (regime.length * regime.width);
    const Shock known = shock_of(density, regime.piston);
    study.truths = {
        {"pressure on a piston that drives a " + regime.name, known.pressure, 0.0, 0.0, of_sirmas},
        {"density behind this shock", known.density, 0.0, 0.0, of_sirmas}};
    study.measure = [=](const RunOf& run) { return driven(regime, known, run.seed); };
    return study;
}

}  // namespace

std::vector<Study> flows() {
    std::vector<Study> all{
        sound(0.2), sound(0.4),
        shock({"weak shock, speed 0.5, into packing 0.1", 0.1, 0.5, 500.0, 40.0}),
        shock({"strong shock, speed 4, into packing 0.1", 0.1, 4.0, 1000.0, 40.0}),
        shock({"shock, speed 2, into packing 0.35", 0.35, 2.0, 300.0, 30.0})};
    all[2].how =
        "The gas of a shock begins at *T* = 1; the pressure on the piston is that of its impulse "
        "from 0.35 of the time, when the shock is far, to the end, the density that of the middle "
        "of what lies behind the shock.";
    return all;
}

}  // namespace carom::validation
