// Exact equilibrium distributions for any finite number of particles: the energy and the speed of
// one particle when the total energy is fixed. Momenta are uniformly distributed on the energy
// sphere whatever the masses, sizes and density, so the energy share of a particle is
// Beta-distributed. Nothing is measured here (see stats/). All functions may be called from any
// thread.
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
    /// The largest share of the total energy that one particle can have: 1 between walls; 1 - m/M
    /// in a periodic box, where the others must balance its momentum.
    double largest_share;
    void archive(auto& archive) { archive(mass, count, largest_share); }
};

/// A gas in equilibrium: energy shares are largest_share * Beta(alpha, beta).
struct EquilibriumGas {
    double energy = 0.0;            ///< of all particles together
    double alpha = 1.0;             ///< half the dimension
    double beta = 1.0;              ///< d/2 (N - 1) between walls, d/2 (N - 2) in a periodic box
    std::vector<MassGroup> groups;  ///< the requested particles, by increasing mass
    void archive(auto& archive) { archive(energy, alpha, beta, groups); }
};

/// The equilibrium that the gas approaches. Returns nothing if there is none: energy is not
/// conserved (moving infinite masses), momentum is conserved along one axis only or is not zero,
/// there is no energy, points in a plane never meet, or there are too few particles to share the
/// energy in more than one way. On a line there is also none if the masses are equal (velocities
/// are only exchanged), if fixed beads separate those that move, or for two beads between walls or
/// three on a ring: these move like a point in a triangle (Glashow and Mittag 1997), which need not
/// come close to all of its states. `species` selects the particles whose distribution is
/// requested; empty: all particles of finite mass.
std::optional<EquilibriumGas> equilibrium(const Box& box, const Particles& particles,
                                          const Sample& sample,
                                          const std::vector<int>& species = {});

/// The same equilibrium for only those of its particles that are listed by number; nothing if none
/// of these has a finite mass.
std::optional<EquilibriumGas> among(const EquilibriumGas& gas, const Particles& particles,
                                    const std::vector<Eigen::Index>& chosen);

/// Probability density of a particle's kinetic energy at e, averaged over the groups; 1/energy.
/// Infinite at 0 in one dimension.
double energy_density(const EquilibriumGas& gas, double e);

/// Probability of a kinetic energy from `low` to `high`, averaged over the groups. The relative
/// error is below 1e-6 for intervals up to a third of the mean energy.
double energy_probability(const EquilibriumGas& gas, double low, double high);

/// Probability density of a particle's speed at v, averaged over the groups; time/length.
double speed_density(const EquilibriumGas& gas, double v);

/// Probability density of one component of a particle's velocity at v (of either sign), averaged
/// over the groups; time/length. If a point is uniformly distributed on a unit sphere in D
/// dimensions, each coordinate u has the density (1 - u^2)^((D - 3)/2) / B(1/2, (D - 1)/2); here D
/// = d N, or d (N - 1) in a periodic box.
double velocity_density(const EquilibriumGas& gas, double v);

/// Standard deviation of that component, whose mean is 0; length/time.
double velocity_deviation(const EquilibriumGas& gas);

/// Mean kinetic energy of a particle, averaged over the groups.
double mean_energy(const EquilibriumGas& gas);

/// Mean speed of a particle, averaged over the groups.
double mean_speed(const EquilibriumGas& gas);

}  // namespace carom
