// Energy and momentum of a whole gas. Particles of infinite mass are walls that move: they belong
// to none of the sums unless it is said.
#pragma once

#include <Eigen/Core>

#include "physics/gas.h"
#include "physics/particles.h"

namespace carom {

/// Masses, N; infinite where the inverse is 0. Of the numbers whose inverse rounds to the same the
/// one with the fewest decimals: as it was given.
Eigen::ArrayXd masses(const Particles& particles);

/// Whether a particle of infinite mass moves: it does work on the others, so that neither energy
/// nor momentum is conserved.
bool infinite_mass_moves(const Particles& particles, const Sample& sample);

/// Total momentum, one component for each dimension; infinite with an infinite mass that moves.
Eigen::ArrayXd momentum(const Particles& particles, const Sample& sample);

/// Kinetic energy of the particles of finite mass without that of the drift which nothing stops:
/// along periodic axes, unless there is an infinite mass, velocities count from the centre of
/// mass's.
double thermal_energy(const Box& box, const Particles& particles, const Sample& sample);

/// 2/d of the thermal energy for each particle of finite mass in d dimensions, Boltzmann's constant
/// being 1: its mean in 2-D, twice that in 1-D. NaN where all masses are infinite.
double temperature(const Box& box, const Particles& particles, double thermal_energy);

}  // namespace carom
