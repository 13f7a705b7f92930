// Expected collision rate, free path and diffusion of a gas from kinetic theory, without a
// simulation. Estimates for a gas in equilibrium, not measurements. All functions may be called
// from any thread.
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
/// by their energy, and mu the reduced mass. In space it is the sum of pi s^2 chi g / V over all
/// pairs of spheres, with g = sqrt(8 T / (pi mu)). The pair correlation chi is that of
/// contact_correlation(). That centres cannot approach solid walls closely is included to first
/// order in s over the box size. The rate agrees within 3 % with simulations of fluids of disks at
/// equilibrium.
///
/// On a line beads move like points on the length that they leave free, L. Equal masses only
/// exchange velocities: each pair meets max(|v|, |w|) / L times per unit of time between walls and
/// |v - w| / L times on a ring, which is exact over long times. Other masses only meet their
/// neighbours, each pair n g / (2 L) times, where g = sqrt(2 T / (pi mu)) and n is the number of
/// beads, or one less on a ring: exact for beads that come near all states of their energy.
///
/// In all, g includes the exact factor of finite numbers, mean_speed_factor().
double collisions_per_time(const BoxedGas& gas);

/// The pair correlation chi at contact of two particles with these radii, as used in
/// collisions_per_time(); dimensionless. In a plane it is that of Jenkins and Mancini (J. Appl.
/// Mech. 54, 27, 1987), which for equal disks is Henderson's (Mol. Phys. 30, 971, 1975). In space
/// it is that of Boublik (J. Chem. Phys. 53, 471, 1970) and of Mansoori, Carnahan, Starling and
/// Leland (J. Chem. Phys. 54, 1523, 1971), which for equal spheres is Carnahan and Starling's.
double contact_correlation(const Box& box, const Particles& particles, double radius,
                           double other_radius);

/// The mean free path of equal particles in a dilute gas, a length: A / (2 sqrt(2) N d) in a plane
/// with the area A, V / (sqrt(2) pi N d^2) in space with the volume V. `content` is A or V, and
/// `cross_sections` the sum of 2 d or of pi d^2 over all particles. For unequal particles an
/// estimate.
double dilute_free_path(double content, double cross_sections);

/// The sum of 2 d or of pi d^2 over particles of these radii.
double cross_sections(const Eigen::ArrayXd& radii, int dimension);

/// How much of a line or a plane is in the way of a particle, if it comes nearer to the centre of
/// another than `contact`: 2 s in a plane, pi s^2 in space, and 1 on a line.
double cross_section(double contact, int dimension);

/// The fraction of the box that the particles cover: of its length, area or volume.
double packing_fraction(const Box& box, const Particles& particles);

/// The diffusion coefficient of equal hard spheres of this diameter and mass in a periodic cube
/// with these sides, length^2/time: that of Enskog, D_E = 1.01896 * 3/8 sqrt(T / (pi m)) / (n d^2
/// chi) with the contact value chi = (Z - 1) / (4 eta) of their equation of state, times 1 +
/// 0.05403 x + 6.3656 x^2 - 10.9425 x^3 with x = n d^3 / sqrt(2), which Erpenbeck and Wood (Phys.
/// Rev. A 43, 4254, 1991) fitted to molecular dynamics up to x = 0.625, for what collisions one
/// after the other have in common. Periodic images slow down what a sphere drags along, so that a
/// cube with the sides L has less by 2.837297 T / (6 pi (v + m n D) L) with the viscosity v, for
/// which Enskog's is taken: mode coupling, where the vortex and the sphere in it both diffuse
/// (Erpenbeck and Wood, Phys. Rev. A 26, 1648, 1982); in a liquid, where v is the larger by far, it
/// is that of Yeh and Hummer (J. Phys. Chem. B 108, 15873, 2004). L may be infinite. The mean
/// squared displacement grows as 6 D t. Within 5 % of runs of 256 spheres.
double diffusion_of_spheres(double density, double diameter, double temperature, double mass,
                            double side);

/// The packing fraction up to which that fit holds, x = 0.625.
inline constexpr double largest_packing_of_diffusion = 0.4628;

}  // namespace carom
