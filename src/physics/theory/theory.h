// Exact equilibrium distributions for any finite number of particles: the energy and the speed of
// one particle when the total energy is fixed. Momenta are uniformly distributed on the energy
// sphere whatever the masses, sizes and density, so the energy share of a particle is
// Beta-distributed. Nothing is measured here (see stats/). All functions may be called from any
// thread.
#pragma once

#include <array>
#include <optional>
#include <vector>

namespace carom {

/// Particles of one mass.
struct MassGroup {
    double mass;
    double count;
    /// The largest share of the total energy that one particle can have in its motion along each
    /// axis: 1 between walls; 1 - m/M where momentum is conserved and the others must balance that
    /// of the particle.
    std::array<double, 3> largest_share{1.0, 1.0, 1.0};
    void archive(auto& archive) { archive(mass, count, largest_share); }
};

/// A gas in equilibrium. The momenta, divided by the roots of the masses, are a point uniformly
/// distributed on a sphere in D dimensions: d for each particle, less one for each axis along which
/// momentum is conserved. The share of the energy in one component of a particle's velocity is
/// largest_share * Beta(1/2, (D - 1)/2). Where it is the same along all axes, that of the particle
/// is largest_share * Beta(alpha, beta); where momentum is conserved along some axes only, it is a
/// mixture of these over the direction of motion n, of which each has the largest share 1 - m/M
/// times the sum of n_i^2 over these axes.
struct EquilibriumGas {
    double energy = 0.0;            ///< of all particles together
    double alpha = 1.0;             ///< half the dimension of the box, d/2
    double beta = 1.0;              ///< D/2 - d/2
    std::vector<MassGroup> groups;  ///< the requested particles, by increasing mass

    int dimension() const { return alpha < 1.0 ? 1 : alpha < 1.5 ? 2 : 3; }  ///< of the box
    void archive(auto& archive) { archive(energy, alpha, beta, groups); }
};

/// The motion of the same gas along some of its axes alone. The speed and the kinetic energy of a
/// particle are then those of this part of its velocity: k coordinates of a point on a sphere in D
/// dimensions have the sum of squares Beta(k/2, (D - k)/2) and, relative to each other, a uniform
/// direction.
EquilibriumGas motion_along(const EquilibriumGas& gas, const std::vector<int>& axes);

/// Probability density of a particle's kinetic energy at e, averaged over the groups; 1/energy.
/// Infinite at 0 in one dimension.
double energy_density(const EquilibriumGas& gas, double e);

/// Probability of a kinetic energy from `low` to `high`, averaged over the groups. The relative
/// error is below 1e-6 for intervals up to a third of the mean energy.
double energy_probability(const EquilibriumGas& gas, double low, double high);

/// Probability density of a particle's speed at v, averaged over the groups; time/length.
double speed_density(const EquilibriumGas& gas, double v);

/// Probability density of one component of a particle's velocity at v (of either sign), averaged
/// over the groups, and over the axes unless one is given; time/length. If a point is uniformly
/// distributed on a unit sphere in D dimensions, each coordinate u has the density (1 - u^2)^((D -
/// 3)/2) / B(1/2, (D - 1)/2).
double velocity_density(const EquilibriumGas& gas, double v, std::optional<int> axis = {});

/// The mean of |v| along an axis, averaged over the groups.
double mean_speed_along(const EquilibriumGas& gas, int axis);

/// D, the number of degrees of freedom that share the energy.
inline double freedoms(const EquilibriumGas& gas) { return 2.0 * (gas.alpha + gas.beta); }

/// The mean length of a vector of any dimension that D degrees of freedom of fixed energy include,
/// divided by that for very many degrees of freedom at the same temperature: sqrt(D/2) Gamma(D/2) /
/// Gamma(D/2 + 1/2), above 1. Relative speeds, too, have this factor.
double mean_speed_factor(double freedoms);

/// Mean speed of a particle, averaged over the groups.
double mean_speed(const EquilibriumGas& gas);

/// The square of the mean length of a vector with `dimension` independent components that are
/// normally distributed with mean 0 and variance 1: 2/pi, pi/2 or 8/pi. Times T / m it is the
/// square of the mean speed in a Maxwell distribution.
double squared_mean_length(int dimension);

}  // namespace carom
