// Equations of state of the fluid of equal hard disks, and corrections for a finite number of
// disks.
#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "support/csv.h"
#include "support/equation_of_state.h"

namespace carom::validation {

/// The compressibility factor Z = P A / (N T) according to Kolafa and Rottner.
inline double kolafa_rottner(double packing) { return 1.0 + test::excess_compressibility(packing); }

inline double henderson(double packing) {
    return (1.0 + packing * packing / 8.0) / ((1.0 - packing) * (1.0 - packing));
}

/// Z from the virial series up to the tenth coefficient.
inline double virial_series(double packing) {
    double sum = 1.0;
    for (const auto& row : test::reference_rows("virial_hard_disk.csv"))
        sum += std::stod(row[1]) * std::pow(2.0 * packing, std::stoi(row[0]) - 1);
    return sum;
}

/// The derivative of a function at x, by finite differences of fourth order.
double derivative(const auto& function, double x) {
    const double step = 1e-4;
    return (8.0 * (function(x + step) - function(x - step)) -
            (function(x + 2.0 * step) - function(x - 2.0 * step))) /
           (12.0 * step);
}

/// The difference between Z of `count` disks in a periodic box and that of infinitely many: a fixed
/// number of disks cannot fluctuate. To first order it is rho / 2N times d ln(chi) / d rho, where
/// chi = d rho / d(P / T) (Lebowitz and Percus, Phys. Rev. 122, 1675, 1961).
inline double finite_number(double packing, double count) {
    const auto stiffness = [](double x) {
        return std::log(derivative([](double y) { return y * kolafa_rottner(y); }, x));
    };
    return -packing / (2.0 * count) * derivative(stiffness, packing);
}

/// The mean magnitude of a velocity component at fixed energy of `freedom` degrees of freedom,
/// relative to that in an infinite gas.
inline double fixed_energy(double freedom) {
    return std::sqrt(0.5 * freedom) *
           std::exp(std::lgamma(0.5 * freedom) - std::lgamma(0.5 * (freedom + 1.0)));
}

/// The excluded area of two disks of diameter s whose centres move in a rectangle of a by b: the
/// measure of the pairs of places at which they would overlap.
inline double excluded(double a, double b, double s) {
    return std::numbers::pi * s * s * a * b - 4.0 / 3.0 * s * s * s * (a + b) + 0.5 * s * s * s * s;
}

}  // namespace carom::validation
