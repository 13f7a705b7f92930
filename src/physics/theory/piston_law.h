// Exact distribution of the position of a free piston on a gas in equilibrium, for any finite
// number of particles. All functions may be called from any thread.
#pragma once

#include <cmath>
#include <numbers>

namespace carom {

/// A constant force F pushes a piston onto N point particles in a column with a fixed far end; all
/// are in equilibrium with the total energy E. The distance h of the piston from the fixed end has
/// the density p(h) = C h^N (E - F h)^b with b = (d N - 1) / 2 in d dimensions, so F h / E has a
/// beta distribution. Rods on a line behave like points on the length that they leave free.
struct PistonLaw {
    double count = 1.0;   ///< N
    double energy = 1.0;  ///< E: of the gas and the piston, including the potential energy F h
    double force = 1.0;   ///< F > 0
    int dimension = 2;

    double alpha() const { return count + 1.0; }  ///< parameters of the beta distribution
    double beta() const { return 0.5 * (dimension * count + 1.0); }
    double largest() const { return energy / force; }

    /// Mean and standard deviation of h.
    double mean() const { return largest() * alpha() / (alpha() + beta()); }
    double deviation() const {
        const double sum = alpha() + beta();
        return largest() * std::sqrt(alpha() * beta() / (sum + 1.0)) / sum;
    }
    /// The density p(h), 1/length; 0 where the energy does not suffice.
    double density(double h) const {
        const double share = h / largest();
        if (!(share > 0.0 && share < 1.0)) return 0.0;
        const double scale =
            std::lgamma(alpha() + beta()) - std::lgamma(alpha()) - std::lgamma(beta());
        return std::exp(scale + (alpha() - 1.0) * std::log(share) +
                        (beta() - 1.0) * std::log1p(-share)) /
               largest();
    }

    /// The mean of M v^2: twice the mean energy per degree of freedom, of which there are d N + 1.
    double temperature() const { return (energy - force * mean()) / beta(); }

    /// The period of the slowest small oscillations of a piston of mass M on a gas of mass m in
    /// which sound propagates. A standing wave of the displacement in the column 0 < z < h, u =
    /// sin(x z / h) sin(omega t) with omega = x c / h, moves the piston by its pressure at z = h if
    /// x tan x = m / M; the smallest root x is used. With the stiffness K = m c^2 / h^2 of the
    /// column, omega^2 = x^2 K / m, which for m << M becomes that of a mass on a spring, K / M. K =
    /// T / deviation^2, which for large N is the adiabatic stiffness (1 + 2/d) F / h.
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
