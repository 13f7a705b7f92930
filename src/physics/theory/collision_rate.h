// How often the particles of a gas should collide, before anything is simulated: kinetic theory.
// An estimate for a gas in equilibrium, not a measurement.
#pragma once

#include <optional>

#include "physics/gas.h"
#include "physics/particles.h"

namespace carom {

/// Collisions between particles in a unit of time, of all particles together, 1/time; velocities
/// are used, positions are not. Nothing where an infinite mass moves (energy is not conserved) or
/// the beads of a line leave no room, or some of them are fixed.
///
/// In a plane Enskog's rate, a sum over all pairs: 2 s chi g / A for disks with the contact
/// distance s, mean relative speed g = sqrt(pi T / (2 mu)) at the temperature T that their energy
/// gives, reduced mass mu. The pair correlation chi at contact is that of Jenkins and Mancini
/// (J. Appl. Mech. 54, 27, 1987); for equal disks it is Henderson's (Mol. Phys. 30, 971, 1975).
/// Within 3 % of simulations of fluids at equilibrium; centres stay off solid walls, to first order
/// in s over the box.
///
/// On a line beads move as points on the length that they leave free. Equal masses only exchange
/// velocities: between walls every pair meets max(|v|, |w|) / L, on a ring |v - w| / L times in a
/// unit of time, which is exact over long times. Otherwise g / L for all pairs with
/// g = sqrt(2 T / (pi mu)).
std::optional<double> expected_collision_rate(const Box& box, const Particles& particles,
                                              const Sample& sample);

/// The pair correlation chi of disks with these radii at contact, in the rate above.
double contact_correlation(const Box& box, const Particles& particles, double radius,
                           double other_radius);

/// The mean free path of equal disks in a dilute gas, A / (2 sqrt(2) N d), of the area A and of the
/// diameters N d of all together. For unequal disks an estimate.
double dilute_free_path(double area, double diameters);

/// The part of the box that particles cover: of the area, or of the length on a line.
double packing_fraction(const Box& box, const Particles& particles);

}  // namespace carom
