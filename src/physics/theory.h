// What a gas in equilibrium looks like, exactly, for any finite number of particles: the laws of
// one particle's energy and speed when the total energy is fixed. Momenta are uniform on the energy
// sphere whatever the masses, sizes and density, so an energy share is Beta-distributed.
// Does not measure anything (stats/).
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
};

/// A two-dimensional gas in equilibrium: energy shares are largest_share * Beta(1, beta).
struct EquilibriumGas {
    double energy = 0.0;            ///< of all particles together
    double beta = 1.0;              ///< N - 1 between walls, N - 2 in a periodic box
    std::vector<MassGroup> groups;  ///< those whose distribution is asked for, by rising mass
};

/// The equilibrium towards which the gas tends, or nothing where there is none: energy not
/// conserved (moving infinite masses), momentum conserved along one axis only or not zero, no
/// energy, points that never meet, or too few particles to share the energy in more than one way.
/// `species` selects whose distribution is asked for; empty: all particles of finite mass.
std::optional<EquilibriumGas> equilibrium(const Box& box, const Particles& particles,
                                          const Sample& sample,
                                          const std::vector<int>& species = {});

/// Probability density of a particle's kinetic energy at e, averaged over the groups; 1/energy.
double energy_density(const EquilibriumGas& gas, double e);

/// Probability density of a particle's speed at v, averaged over the groups; time/length.
double speed_density(const EquilibriumGas& gas, double v);

/// Mean kinetic energy of a particle, averaged over the groups.
double mean_energy(const EquilibriumGas& gas);

/// Mean speed of a particle, averaged over the groups.
double mean_speed(const EquilibriumGas& gas);

}  // namespace carom
