// What is known of a gas of equal hard disks at any packing fraction of the fluid.
#pragma once

#include <cmath>
#include <numbers>
#include <string>

#include "support/csv.h"

namespace carom::test {

/// Z - 1, Z = P A / (N T), from Kolafa and Rottner 2006, eq. (7); good to a packing fraction of
/// 0.70.
inline double excess_compressibility(double packing) {
    const double x = packing / (1.0 - packing);
    double sum = -1.0;
    for (const auto& row : reference_rows("eos_hard_disk_kr_coefficients.csv"))
        sum += std::stod(row[1]) * std::pow(x, std::stoi(row[0]));
    return sum;
}

/// Collisions of one disk per unit of time, for mass 1, diameter 1 and temperature T:
/// (4/sqrt(pi)) (Z - 1) sqrt(T). Velocities of colliding disks are independent in equilibrium, so
/// Enskog's rate is exact with the exact Z.
inline double collision_rate(double packing, double temperature) {
    return 4.0 / std::sqrt(std::numbers::pi) * excess_compressibility(packing) *
           std::sqrt(temperature);
}

/// Mean path between two collisions, in diameters: pi / (4 sqrt(2) (Z - 1)).
inline double mean_free_path(double packing) {
    return std::numbers::pi / (4.0 * std::numbers::sqrt2 * excess_compressibility(packing));
}

}  // namespace carom::test
