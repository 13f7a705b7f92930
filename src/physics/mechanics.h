// Energy, momentum and temperature of a gas. Particles of infinite mass are walls that move: they
// belong to none of the sums unless it is said. Boltzmann's constant is 1.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "physics/advance_result.h"
#include "physics/gas.h"
#include "physics/particles.h"

namespace carom {

/// The sum, added up in one order whatever processor the program is compiled for: that of Eigen's
/// sum() with two numbers at a time. What begins a run is a sum by this.
double sum_in_order(const Eigen::ArrayXd& values);

/// Masses, N; infinite where the inverse is 0. Of the numbers whose inverse rounds to the same the
/// one with the fewest decimals: as it was given.
Eigen::ArrayXd masses(const Particles& particles);

/// Whether a particle of infinite mass moves: it does work on the others, so that neither energy
/// nor momentum is conserved.
bool infinite_mass_moves(const Particles& particles, const Sample& sample);

/// The mean of some energies, one for each particle, over the particles of finite mass: what cannot
/// take part in an exchange of energy does not count. NaN if there are none.
double mean_over_finite_masses(const Particles& particles, const Eigen::ArrayXd& energies);

/// The mean of the speeds, one for each particle, over the particles of finite mass, or over all
/// where there are none: those that collisions do not change do not count.
double mean_of_speeds(const Particles& particles, const Eigen::ArrayXd& speeds);

/// The momentum that the partner of a collision received from its first particle, as much as that
/// lost; not a number where neither of both masses is finite.
Eigen::Array2d impulse_of(const Particles& particles, const Collision& collision);

/// Total momentum, one component for each dimension; infinite with an infinite mass that moves.
Eigen::ArrayXd momentum(const Particles& particles, const Sample& sample);

/// Whether nothing can take up momentum along an axis from a gas without infinite masses: its sides
/// are joined, nothing pulls along it, and every surface is smooth and lies along it from end to
/// end. Partitions that stand across it count as closed; what events change does not count.
bool conserves_momentum(const Box& box, Eigen::Index axis);

/// The same of these particles.
bool conserves_momentum(const Box& box, const Particles& particles, Eigen::Index axis);

/// Kinetic energy relative to the drift, and the degrees of freedom that share it, of some or all
/// particles of a gas.
///
/// Along an axis where momentum is conserved (conserves_momentum()) velocities count from that of
/// the centre of mass, V: what drifts as a whole is no heat. Such a drift takes up one degree of
/// freedom: at temperature T the mean of m (v_x - V_x)^2 is T (1 - m / M), M being the mass of the
/// whole gas (Shirts, Burt and Johnson, J. Chem. Phys. 125, 164102, 2006). So there is 1 degree of
/// freedom for each particle and axis, and 1 - m / M where momentum is conserved: for all N
/// particles together N - 1.
struct ThermalMotion {
    double energy = 0.0;
    double degrees_of_freedom = 0.0;

    /// Twice the energy for each degree of freedom; NaN where there is none (infinite masses only,
    /// or a single particle in a periodic box). In equilibrium its mean is the same for all species
    /// and for the whole gas.
    double temperature() const { return 2.0 * energy / degrees_of_freedom; }
};

/// Of all particles of finite mass.
ThermalMotion thermal_motion(const Box& box, const Particles& particles, const Sample& sample);

/// Of those listed by number; infinite masses among them count nothing.
ThermalMotion thermal_motion(const Box& box, const Particles& particles, const Sample& sample,
                             const std::vector<Eigen::Index>& members);

}  // namespace carom
