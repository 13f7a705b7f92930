// Equation of state of the fluid of equal hard disks or spheres, collision rate and mean free path
// of that of disks.
#pragma once

#include <cmath>
#include <numbers>
#include <string>

#include "support/csv.h"

namespace carom::test {

/// Z - 1, where Z = P A / (N T) is the compressibility factor, from Kolafa and Rottner 2006, eq.
/// (7); valid up to a packing fraction of 0.70. In space, with the volume for A, from Kolafa, Labik
/// and Malijevsky 2004; valid up to 0.494.
inline double excess_compressibility(double packing, int dimension = 2) {
    const double x = packing / (1.0 - packing);
    double sum = -1.0;
    for (const auto& row : reference_rows(dimension == 2 ? "eos_hard_disk_kr_coefficients.csv"
                                                         : "eos_hard_sphere_klm_coefficients.csv"))
        sum += std::stod(row[1]) * std::pow(x, std::stoi(row[0]));
    return sum;
}

/// Collisions per disk and unit of time, (4/sqrt(pi)) (Z - 1) sqrt(T), for mass 1, diameter 1 and
/// temperature T. In equilibrium the velocities of colliding disks are independent, so Enskog's
/// rate is exact if Z is.
inline double collision_rate(double packing, double temperature) {
    return 4.0 / std::sqrt(std::numbers::pi) * excess_compressibility(packing) *
           std::sqrt(temperature);
}

/// Mean free path between two collisions of a disk, in diameters: pi / (4 sqrt(2) (Z - 1)).
inline double mean_free_path(double packing) {
    return std::numbers::pi / (4.0 * std::numbers::sqrt2 * excess_compressibility(packing));
}

}  // namespace carom::test
