// Expected collision rate of a gas from kinetic theory, without a simulation. An estimate for a gas
// in equilibrium, not a measurement.
#pragma once

#include "physics/box.h"
#include "physics/particles.h"
#include "physics/theory/boxed_gas.h"

namespace carom {

/// Expected number of particle-particle collisions of the whole gas per unit of time, 1/time, where
/// law() has one (LawOf::collision_rate, which is per particle). Uses the velocities, and on a line
/// the order of beads whose masses differ.
///
/// In a plane this is Enskog's rate, the sum of 2 s chi g / A over all pairs of disks, where s is
/// the contact distance, g = sqrt(pi T / (2 mu)) the mean relative speed at the temperature T given
/// by their energy, and mu the reduced mass. The pair correlation chi at contact is that of Jenkins
/// and Mancini (J. Appl. Mech. 54, 27, 1987), which for equal disks is Henderson's (Mol. Phys. 30,
/// 971, 1975). That centres cannot approach solid walls closely is included to first order in s
/// over the box size. The rate agrees within 3 % with simulations of fluids at equilibrium.
///
/// On a line beads move like points on the length that they leave free, L. Equal masses only
/// exchange velocities: each pair meets max(|v|, |w|) / L times per unit of time between walls and
/// |v - w| / L times on a ring, which is exact over long times. Other masses only meet their
/// neighbours, each pair n g / (2 L) times, where g = sqrt(2 T / (pi mu)) and n is the number of
/// beads, or one less on a ring: exact for beads that come near all states of their energy.
///
/// In both, g includes the exact factor of finite numbers, mean_speed_factor().
double collisions_per_time(const BoxedGas& gas);

/// The pair correlation chi at contact of disks with these radii, as used in
/// collisions_per_time(); dimensionless.
double contact_correlation(const Box& box, const Particles& particles, double radius,
                           double other_radius);

/// The mean free path of equal disks in a dilute gas, A / (2 sqrt(2) N d), a length: `area` is A
/// and `diameters` is N d, the sum of all diameters. For unequal disks an estimate.
double dilute_free_path(double area, double diameters);

/// The fraction of the box that the particles cover: of its area, or of the length of a line.
double packing_fraction(const Box& box, const Particles& particles);

}  // namespace carom
