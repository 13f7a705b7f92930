// Equations of state of the fluid of equal hard disks or spheres, and corrections for a finite
// number of particles.
#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "physics/vec.h"
#include "support/csv.h"
#include "support/equation_of_state.h"
#include "support/spheres.h"

namespace carom::validation {

/// "disk" or "sphere".
inline std::string body_of(int dimension) { return dimension == 2 ? "disk" : "sphere"; }

/// The compressibility factor Z = P V / (N T), with the area for V in a plane, according to Kolafa
/// and Rottner or, in space, to Kolafa, Labik and Malijevsky.
inline double compressibility_of(int dimension, double packing) {
    return 1.0 + test::excess_compressibility(packing, dimension);
}

inline double henderson(double packing) {
    return (1.0 + packing * packing / 8.0) / ((1.0 - packing) * (1.0 - packing));
}

/// The second virial coefficient of a fluid over the content of a particle.
inline double second_virial(int dimension) { return dimension == 2 ? 2.0 : 4.0; }

/// Z from the virial series up to the tenth coefficient.
inline double virial_series(int dimension, double packing) {
    double sum = 1.0;
    for (const auto& row :
         test::reference_rows(dimension == 2 ? "virial_hard_disk.csv" : "virial_hard_sphere.csv"))
        sum +=
            std::stod(row[1]) * std::pow(second_virial(dimension) * packing, std::stoi(row[0]) - 1);
    return sum;
}

/// The pair correlation at contact, by the virial theorem.
inline double contact_value(int dimension, double packing) {
    return (compressibility_of(dimension, packing) - 1.0) / (second_virial(dimension) * packing);
}

/// The derivative of a function at x, by finite differences of fourth order.
double derivative(const auto& function, double x) {
    const double step = 1e-4;
    return (8.0 * (function(x + step) - function(x - step)) -
            (function(x + 2.0 * step) - function(x - 2.0 * step))) /
           (12.0 * step);
}

/// The difference between Z of `count` particles in a periodic box and that of infinitely many, if
/// `z` gives Z at a packing: a fixed number of particles cannot fluctuate. To first order it is rho
/// / 2N times d ln(chi) / d rho, where chi = d rho / d(P / T) (Lebowitz and Percus, Phys. Rev. 122,
/// 1675, 1961).
inline double finite_number(const auto& z, double packing, double count) {
    const auto stiffness = [&](double x) {
        return std::log(derivative([&](double y) { return y * z(y); }, x));
    };
    return -packing / (2.0 * count) * derivative(stiffness, packing);
}

/// The same of equal disks or spheres.
inline double finite_number(int dimension, double packing, double count) {
    return finite_number([=](double x) { return compressibility_of(dimension, x); }, packing,
                         count);
}

/// The mean magnitude of a velocity component at fixed energy of `freedom` degrees of freedom,
/// relative to that in an infinite gas.
inline double fixed_energy(double freedom) {
    return std::sqrt(0.5 * freedom) *
           std::exp(std::lgamma(0.5 * freedom) - std::lgamma(0.5 * (freedom + 1.0)));
}

/// The share of the pairs of places, of centres that move in a rectangle or a cuboid with these
/// sides, at which two particles of diameter s would overlap. s is less than all sides.
inline double excluded_share(int dimension, const Vec& sides, double s) {
    const double a = sides[0], b = sides[1];
    if (dimension == 3) {
        const test::NearPlaces places{a, b, sides[2]};
        return places.volume(s) / places.all();
    }
    const double area =
        std::numbers::pi * s * s * a * b - 4.0 / 3.0 * s * s * s * (a + b) + 0.5 * s * s * s * s;
    return area / (a * a * b * b);
}

}  // namespace carom::validation
