// The pressure of a gas in equilibrium from theory: equations of state of hard disks and of hard
// rods. Nothing is measured here (see stats/). All functions may be called from any thread.
#pragma once

#include <optional>

#include "physics/box.h"
#include "physics/mechanics.h"
#include "physics/particles.h"

namespace carom {

/// An equation of state of a fluid of equal hard disks: the compressibility factor Z = P A / (N T),
/// dimensionless, at a packing fraction from 0 to largest_packing_of_fluid.
enum class EquationOfState {
    henderson,       ///< (1 + eta^2 / 8) / (1 - eta)^2: Mol. Phys. 30, 971 (1975); within 1 % up to
                     ///< a packing of 0.6
    kolafa_rottner,  ///< Mol. Phys. 104, 3435 (2006), equation (7): within 0.1 % up to 0.69
};

/// Above this packing fraction disks begin to freeze: Li et al. (2022) find coexistence from 0.700
/// to 0.716.
inline constexpr double largest_packing_of_fluid = 0.70;

/// The compressibility factor Z by this equation, dimensionless.
double compressibility_factor(EquationOfState equation, double packing_fraction);

/// d(N T) / d(P A) at constant area and temperature, dimensionless: the isothermal compressibility
/// divided by that of an ideal gas, which is also the variance of the number of particles in a part
/// of a large fluid divided by that of an ideal gas.
double relative_compressibility(EquationOfState equation, double packing_fraction);

/// The pressure of a gas of point particles with this thermal energy: 2 K / (d V) with the size V
/// of the box; in one dimension a force.
double pressure_of_points(const Box& box, double thermal_energy);

/// The time-averaged pressure, in energy per area, of a gas with this thermal motion in its box, as
/// virial_pressure() and wall_pressure() measure it. In a plane it follows from an equation of
/// state; the masses do not matter. Returns nothing on a line, and unless all disks have the same
/// radius and finite masses and form a fluid.
///
/// The effect of solid sides is that of a tension gamma of the line that the centres can reach.
/// Each such wall adds -rho d(gamma)/d(P) particles per length to the number that fill the area
/// accessible to the centres at the density of the fluid. With the grand potential -P A + gamma
/// times the perimeter of this area, it takes gamma from the force on the walls at its ends. With
/// the diameter sigma, the number density rho and the packing fraction eta, gamma / T = -sigma rho
/// eta / (2 (1 - eta)^2) by scaled-particle theory (Helfand, Frisch and Lebowitz, J. Chem. Phys.
/// 34, 1037, 1961): the work of making a large empty circle less that of P times its area. The
/// pressure is within 1 % up to a packing fraction of 0.5 for boxes 13 diameters wide.
std::optional<double> pressure_of_disks(EquationOfState equation, const Box& box,
                                        const Particles& particles, const ThermalMotion& thermal);

/// The mean force of such a gas on each side across an axis, or through a line across a periodic
/// axis, divided by the temperature: 1/length. Returns nothing where pressure_of_disks() does.
std::optional<double> force_of_disks(EquationOfState equation, const Box& box,
                                     const Particles& particles, int axis);

/// The pressure of beads on a line, which is a force: that of points on the length that the rods
/// leave free (Tonks, Phys. Rev. 50, 955, 1936), exact for any number of beads. Returns nothing in
/// a plane, without particles, for infinite masses, or if the beads leave no free length.
std::optional<double> pressure_of_rods(const Box& box, const Particles& particles,
                                       const ThermalMotion& thermal);

}  // namespace carom
