// The pressure of a gas in equilibrium, before anything is simulated: equations of state of hard
// disks and of hard rods. Does not measure anything (stats/). Any function may be called from any
// thread.
#pragma once

#include <optional>

#include "physics/gas.h"
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

/// Z by this equation.
double compressibility_factor(EquationOfState equation, double packing_fraction);

/// d(N T) / d(P A) at constant area and temperature: the isothermal compressibility in units of
/// that of an ideal gas, and the variance of the number of particles in a part of a large fluid in
/// units of that of points.
double relative_compressibility(EquationOfState equation, double packing_fraction);

/// The time average of the pressure of a gas with this thermal motion, 1/area times energy, in its
/// box, as virial_pressure() and wall_pressure() measure it: in a plane by an equation of state;
/// nothing unless all disks have the same radius, a finite mass each, and are a fluid. Masses do
/// not matter. Nothing on a line.
///
/// Where sides are solid, their effect is that of a surface tension gamma at the line that centres
/// reach: each such wall adds -d(gamma)/d(P) particles per length to those that fill the area that
/// centres have with the density of the fluid, and gamma to the force on the walls at its ends. For
/// gamma / T = -sigma^3 rho^2 / (3 (1 - eta)^2), with the diameter sigma and the number density
/// rho: exact to second order in the density, with the dependence on the packing eta of
/// scaled-particle theory (Helfand, Frisch and Lebowitz, J. Chem. Phys. 34, 1037, 1961). The
/// pressure is within 1 % up to a packing of 0.5 for boxes 20 diameters wide.
std::optional<double> pressure_of_disks(EquationOfState equation, const Box& box,
                                        const Particles& particles, const ThermalMotion& thermal);

/// The same of beads on a line, a force: that of points on the length that rods leave free (Tonks,
/// Phys. Rev. 50, 955, 1936), exactly, for any number of beads. Nothing in a plane, or where they
/// leave no room.
std::optional<double> pressure_of_rods(const Box& box, const Particles& particles,
                                       const ThermalMotion& thermal);

}  // namespace carom
