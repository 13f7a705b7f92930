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

    /// Of small oscillations of a piston of mass M about the mean, so slow that the gas stays in
    /// equilibrium, from M omega^2 deviation^2 = T. Where N is large this is the motion along the
    /// adiabat, omega^2 = (1 + 2/d) F / (M h).
    double period(double mass) const {
        return 2.0 * std::numbers::pi * deviation() * std::sqrt(mass / temperature());
    }

    void archive(auto& archive) { archive(count, energy, force, dimension); }
};

}  // namespace carom
