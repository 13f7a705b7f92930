// Spheres in space, and integrals over their places, for tests of theory and of statistics.
#pragma once

#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <vector>

#include "physics/particles.h"
#include "physics/theory/equation_of_state.h"

namespace carom::test {

using std::numbers::pi;

/// Z of an equation of state in space.
inline double z_of_spheres(EquationOfState equation, double packing) {
    return compressibility_factor(3, equation, packing);
}

/// Particles of these radii and of mass 1.
inline Particles spheres_of(const std::vector<double>& radii) {
    const auto n = static_cast<Eigen::Index>(radii.size());
    return {Eigen::Map<const Eigen::ArrayXd>(radii.data(), n), Eigen::ArrayXd::Ones(n),
            Eigen::ArrayXi::Zero(n)};
}

inline Particles equal_spheres(std::size_t count, double radius) {
    return spheres_of(std::vector<double>(count, radius));
}

/// The integral of a function, by the middle of each step.
inline double summed(double low, double high, const std::function<double(double)>& f,
                     int steps = 4000) {
    double sum = 0.0;
    for (int k = 0; k < steps; ++k) sum += f(low + (high - low) * (k + 0.5) / steps);
    return sum * (high - low) / steps;
}

/// The volume that pairs of places in a box of these sides have in which they are nearer than `d`,
/// and how it grows with `d`: the integral of (a - |x|)(b - |y|)(c - |z|) over a ball, exact for d
/// less than all sides.
struct NearPlaces {
    double a, b, c;
    double volume(double d) const {
        return 4.0 / 3.0 * pi * a * b * c * std::pow(d, 3) -
               0.5 * pi * (a * b + b * c + c * a) * std::pow(d, 4) +
               8.0 / 15.0 * (a + b + c) * std::pow(d, 5) - std::pow(d, 6) / 6.0;
    }
    double growth(double d) const {
        return 4.0 * pi * a * b * c * std::pow(d, 2) -
               2.0 * pi * (a * b + b * c + c * a) * std::pow(d, 3) +
               8.0 / 3.0 * (a + b + c) * std::pow(d, 4) - std::pow(d, 5);
    }
    double all() const { return std::pow(a * b * c, 2); }
};

}  // namespace carom::test
