// What a gas in equilibrium looks like, exactly, for any finite number of particles: the
// distributions of one particle's energy and speed when the total energy is fixed. Momenta are
// uniform on the energy sphere whatever the masses, sizes and density, so an energy share is
// Beta-distributed. Does not measure anything (stats/). Any function may be called from any thread.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "physics/gas.h"
#include "physics/particles.h"

namespace carom {

/// Particles of one mass.
struct MassGroup {
    double mass;
    double count;
    /// The most of the total energy that one of them can have: 1 between walls; 1 - m/M in a
    /// periodic box, where the others must balance its momentum.
    double largest_share;
    void archive(auto& archive) { archive(mass, count, largest_share); }
};

/// A gas in equilibrium: energy shares are largest_share * Beta(alpha, beta).
struct EquilibriumGas {
    double energy = 0.0;            ///< of all particles together
    double alpha = 1.0;             ///< half the dimension
    double beta = 1.0;              ///< d/2 (N - 1) between walls, d/2 (N - 2) in a periodic box
    std::vector<MassGroup> groups;  ///< those whose distribution is asked for, by rising mass
    void archive(auto& archive) { archive(energy, alpha, beta, groups); }
};

/// The equilibrium towards which the gas tends, or nothing where there is none: energy not
/// conserved (moving infinite masses), momentum conserved along one axis only or not zero, no
/// energy, points of a plane that never meet, or too few particles to share the energy in more than
/// one way. On a line also none where masses are equal (velocities only change hands), where fixed
/// beads part those that move, and for two beads between walls or three on a ring: these move as a
/// point in a triangle (Glashow and Mittag 1997), which need not come near all its states.
/// `species` selects whose distribution is asked for; empty: all particles of finite mass.
std::optional<EquilibriumGas> equilibrium(const Box& box, const Particles& particles,
                                          const Sample& sample,
                                          const std::vector<int>& species = {});

/// The same equilibrium, asked for those particles of it alone that are listed by their number;
/// nothing if none of these has a finite mass.
std::optional<EquilibriumGas> among(const EquilibriumGas& gas, const Particles& particles,
                                    const std::vector<Eigen::Index>& chosen);

/// Probability density of a particle's kinetic energy at e, averaged over the groups; 1/energy.
/// Infinite at 0 in one dimension.
double energy_density(const EquilibriumGas& gas, double e);

/// Probability of a kinetic energy from `low` to `high`, averaged over the groups; accurate to 1e-6
/// of itself for intervals up to a third of the mean energy.
double energy_probability(const EquilibriumGas& gas, double low, double high);

/// Probability density of a particle's speed at v, averaged over the groups; time/length.
double speed_density(const EquilibriumGas& gas, double v);

/// Probability density of one component of a particle's velocity at v (of either sign), averaged
/// over the groups; time/length. A coordinate of a point that is uniform on a sphere in D = d N, in
/// a periodic box d (N - 1), dimensions has the density (1 - u^2)^((D - 3)/2) / B(1/2, (D - 1)/2).
double velocity_density(const EquilibriumGas& gas, double v);

/// Standard deviation of that component, whose mean is 0; length/time.
double velocity_deviation(const EquilibriumGas& gas);

/// Mean kinetic energy of a particle, averaged over the groups.
double mean_energy(const EquilibriumGas& gas);

/// Mean speed of a particle, averaged over the groups.
double mean_speed(const EquilibriumGas& gas);

}  // namespace carom
