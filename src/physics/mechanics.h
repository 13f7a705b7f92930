// Energy, momentum and temperature of a gas. Particles of infinite mass act as moving walls and are
// excluded from all sums unless stated otherwise. Boltzmann's constant is 1.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "physics/advance_result.h"
#include "physics/box.h"
#include "physics/particles.h"

namespace carom {

/// The sum of all values, added in the same order on every processor: that of Eigen's sum() with
/// two numbers per vector. The initial state of a run depends on such sums, so they must be
/// reproducible.
double sum_in_order(const Eigen::ArrayXd& values);

/// Masses, N; infinite where the inverse mass is 0. Of all numbers whose inverse rounds to the
/// stored value, the one with the fewest decimals is returned: the mass as it was specified.
Eigen::ArrayXd masses(const Particles& particles);

/// Whether a particle of infinite mass moves: it does work on the others, so that neither energy
/// nor momentum is conserved.
bool infinite_mass_moves(const Particles& particles, const Sample& sample);

/// The mean of `energies` (one for each particle) over the particles of finite mass: others cannot
/// take part in an exchange of energy. NaN if there are none.
double mean_over_finite_masses(const Particles& particles, const Eigen::ArrayXd& energies);

/// The mean of `speeds` (one for each particle) over the particles of finite mass, or over all
/// particles if none has a finite mass. Particles whose velocity collisions do not change are thus
/// left out.
double mean_of_speeds(const Particles& particles, const Eigen::ArrayXd& speeds);

/// The momentum that the partner in a collision received, which is what the first particle lost.
/// NaN if neither mass is finite.
Vec impulse_of(const Particles& particles, const Collision& collision);

/// Total momentum, one component for each dimension; infinite with an infinite mass that moves.
Eigen::ArrayXd momentum(const Particles& particles, const Sample& sample);

/// Whether the momentum along an axis is conserved in a gas without infinite masses: the box is
/// periodic along the axis, gravity has no component along it, and every surface is smooth and
/// extends along the axis from end to end. Partitions perpendicular to the axis count as closed;
/// changes by events are not considered.
bool conserves_momentum(const Box& box, Eigen::Index axis);

/// The same for these particles, which may include infinite masses.
bool conserves_momentum(const Box& box, const Particles& particles, Eigen::Index axis);

/// Thermal kinetic energy, relative to the drift, of some or all particles of a gas, and the number
/// of degrees of freedom that share it.
///
/// Along an axis where momentum is conserved (conserves_momentum()) velocities are taken relative
/// to that of the centre of mass, V: a common drift is not heat. Removing it costs one degree of
/// freedom: at temperature T the mean of m (v_x - V_x)^2 is T (1 - m / M), where M is the mass of
/// the whole gas (Shirts, Burt and Johnson, J. Chem. Phys. 125, 164102, 2006). So each particle has
/// 1 degree of freedom per axis, or 1 - m / M where momentum is conserved; for all N particles
/// together that is N - 1.
struct ThermalMotion {
    double energy = 0.0;
    double degrees_of_freedom = 0.0;

    /// Twice the energy per degree of freedom; NaN without degrees of freedom (infinite masses
    /// only, or a single particle in a periodic box). In equilibrium its mean is the same for all
    /// species and for the whole gas.
    double temperature() const { return 2.0 * energy / degrees_of_freedom; }
};

/// Thermal motion of all particles of finite mass that are present.
ThermalMotion thermal_motion(const Box& box, const Particles& particles, const Sample& sample);

/// Thermal motion of the particles listed by number; those among them that are absent or of
/// infinite mass are ignored.
ThermalMotion thermal_motion(const Box& box, const Particles& particles, const Sample& sample,
                             const std::vector<Eigen::Index>& members);

}  // namespace carom
