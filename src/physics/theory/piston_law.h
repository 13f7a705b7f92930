// Where a free piston is over a gas in equilibrium, exactly, for any finite number of particles.
// Any function may be called from any thread.
#pragma once

#include <cmath>
#include <numbers>

namespace carom {

/// A piston that a constant force pushes onto N points in a column, whose far end is fixed, all in
/// equilibrium with the total energy E: its distance h from that end has the density
/// p(h) = C h^N (E - F h)^b, b = (d N - 1) / 2 in d dimensions, so that F h / E has a beta
/// distribution. On a line rods are as points on the length that they leave free.
struct PistonLaw {
    double count = 1.0;   ///< N
    double energy = 1.0;  ///< E: of the gas, of the piston and, as F h, in the force
    double force = 1.0;   ///< F > 0
    int dimension = 2;

    double alpha() const { return count + 1.0; }  ///< of the beta distribution
    double beta() const { return 0.5 * (dimension * count + 1.0); }
    double largest() const { return energy / force; }

    /// Of h.
    double mean() const { return largest() * alpha() / (alpha() + beta()); }
    double deviation() const {
        const double sum = alpha() + beta();
        return largest() * std::sqrt(alpha() * beta() / (sum + 1.0)) / sum;
    }
    /// p(h), 1/length; 0 beyond what the energy allows.
    double density(double h) const {
        const double share = h / largest();
        if (!(share > 0.0 && share < 1.0)) return 0.0;
        const double scale =
            std::lgamma(alpha() + beta()) - std::lgamma(alpha()) - std::lgamma(beta());
        return std::exp(scale + (alpha() - 1.0) * std::log(share) +
                        (beta() - 1.0) * std::log1p(-share)) /
               largest();
    }

    /// The mean of M v^2: twice the mean energy of each of the d N + 1 degrees of freedom.
    double temperature() const { return (energy - force * mean()) / beta(); }

    /// The period of the slowest small oscillations of a piston of mass M on a gas of mass m
    /// through which sound travels. A standing wave u = sin(x z / h) sin(omega t) of the
    /// displacement in the column 0 < z < h, with omega = x c / h, moves the piston by its pressure
    /// at z = h if x tan x = m / M; the smallest x counts. With the stiffness K = m c^2 / h^2 of
    /// the column, omega^2 = x^2 K / m; where m << M this is K / M, that of a spring. K = T /
    /// deviation^2, which is (1 + 2/d) F / h, that of the adiabat, where N is large.
    double period(double mass, double gas_mass) const {
        double low = 0.0, high = 0.5 * std::numbers::pi;
        while (0.5 * (low + high) > low && 0.5 * (low + high) < high) {
            const double x = 0.5 * (low + high);
            (x * std::sin(x) * mass < gas_mass * std::cos(x) ? low : high) = x;
        }
        return 2.0 * std::numbers::pi * deviation() / low * std::sqrt(gas_mass / temperature());
    }

    void archive(auto& archive) { archive(count, energy, force, dimension); }
};

}  // namespace carom
