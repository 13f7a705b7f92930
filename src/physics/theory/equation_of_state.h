// The pressure of a gas in equilibrium from theory: equations of state of hard rods, disks and
// spheres. Nothing is measured here (see stats/). All functions may be called from any thread.
#pragma once

#include <optional>
#include <string_view>

#include "physics/box.h"
#include "physics/mechanics.h"
#include "physics/particles.h"

namespace carom {

/// An equation of state of a fluid of equal hard disks or spheres: the compressibility factor Z = P
/// V / (N T), with the area for V in a plane, dimensionless, at a packing fraction eta from 0 to
/// largest_packing_of_fluid().
enum class EquationOfState {
    /// In a plane Henderson's, (1 + eta^2 / 8) / (1 - eta)^2: Mol. Phys. 30, 971 (1975); within 1 %
    /// up to a packing of 0.6. In space that of Carnahan and Starling, (1 + eta + eta^2 - eta^3) /
    /// (1 - eta)^3: J. Chem. Phys. 51, 635 (1969); within 0.4 % up to 0.494.
    simple,
    /// In a plane that of Kolafa and Rottner, Mol. Phys. 104, 3435 (2006), equation (7): within 0.1
    /// % up to 0.69. In space that of Kolafa, Labik and Malijevsky, Phys. Chem. Chem. Phys. 6, 2335
    /// (2004), the fit to the stable fluid and beyond: within 0.02 % up to 0.494.
    accurate
};

/// Its authors, as in a legend: "Henderson", "Carnahan-Starling".
std::string_view name_of(EquationOfState equation, int dimension);

/// Above this packing fraction the fluid begins to freeze. For disks 0.70: Li et al. (2022) find
/// coexistence from 0.700 to 0.716. For spheres 0.492: there the accurate equation has the pressure
/// of coexistence (PhaseOfSpheres). Hoover and Ree (J. Chem. Phys. 49, 3609, 1968) found 0.494.
double largest_packing_of_fluid(int dimension);

/// A phase of equal spheres in space, at the packing fractions at which it is the stable one.
enum class PhaseOfSpheres {
    fluid,  ///< up to largest_packing_of_fluid()
    /// A fluid and a crystal side by side, both at the pressure 11.5727 T / d^3, with the
    /// temperature T and the diameter d: L. A. Fernandez et al., Phys. Rev. Lett. 108, 165701
    /// (2012), 11.5727(10) from up to 2916 spheres. Hoover and Ree (1968) found 11.7.
    coexistence,
    /// Face-centred cubic, from the packing fraction 0.543, at which it has the pressure of
    /// coexistence, to that of close packing, pi / sqrt(18): R. J. Speedy, J. Phys.: Condens.
    /// Matter 10, 4387 (1998), a fit to molecular dynamics. With z, the density divided by that of
    /// close packing, Z = 3 / (1 - z) - 0.5921 (z - 0.7072) / (z - 0.601).
    crystal
};

/// The compressibility factor of equal spheres in space in the one phase that is stable at this
/// packing fraction, dimensionless; nothing for another. The fluid has that of the accurate
/// equation of state.
std::optional<double> compressibility_of_phase(PhaseOfSpheres phase, double packing_fraction);

/// The compressibility factor Z by this equation in 2 or 3 dimensions, dimensionless.
double compressibility_factor(int dimension, EquationOfState equation, double packing_fraction);

/// d(N T) / d(P V) at constant volume and temperature, dimensionless: the isothermal
/// compressibility divided by that of an ideal gas, which is also the variance of the number of
/// particles in a part of a large fluid divided by that of an ideal gas.
double relative_compressibility(int dimension, EquationOfState equation, double packing_fraction);

/// The pressure of a gas of point particles with this thermal energy: 2 K / (d V) with the size V
/// of the box; in one dimension a force.
double pressure_of_points(const Box& box, double thermal_energy);

/// The time-averaged pressure, in energy per area or volume, of a gas with this thermal motion in
/// its box, as virial_pressure() and wall_pressure() measure it, in a plane or in space. It follows
/// from an equation of state; the masses do not matter. Returns nothing on a line, and unless all
/// particles have finite masses and form a fluid. Disks must all have the same radius; spheres of
/// several radii have the pressure of mixtures by Boublik (J. Chem. Phys. 53, 471, 1970) and by
/// Mansoori, Carnahan, Starling and Leland (J. Chem. Phys. 54, 1523, 1971), whatever the equation,
/// up to the packing at which equal ones freeze.
///
/// The effect of solid sides is that of a tension gamma of the line or surface that the centres can
/// reach. Each such wall adds -rho d(gamma)/d(P) particles per length or area to the number that
/// fill the room accessible to the centres at the density of the fluid. With the grand potential -P
/// V + gamma times the perimeter or surface of this room, it takes gamma from the force on the
/// walls at its ends. With the diameter sigma, the number density rho and the packing fraction eta,
/// scaled particle theory gives gamma / T = -sigma rho eta / (2 (1 - eta)^2) in a plane (Helfand,
/// Frisch and Lebowitz, J. Chem. Phys. 34, 1037, 1961) and -9 eta^2 (1 + eta) / (2 pi sigma^2 (1 -
/// eta)^3) in space (Reiss, Frisch, Helfand and Lebowitz, J. Chem. Phys. 32, 119, 1960): the work
/// of making a large empty circle or sphere less that of P times its content. Both are exact to
/// second order in the density. In a plane the pressure is within 1 % up to a packing fraction of
/// 0.5 for boxes 13 diameters wide. In space, where edges count too, it is 2.8 % too high at a
/// packing fraction of 0.3 between six walls 9 diameters apart, and 0.2 % at 16.
///
/// Of a mixture of spheres gamma / T, at the wall itself, is n1 / (1 - eta) + n2^2 / (8 pi (1 -
/// eta)^2), with the sums n1 of the radii and n2 of the surfaces of all spheres per volume: the
/// derivative of the free energy of scaled particle theory by n2 (Rosenfeld, Phys. Rev. Lett. 63,
/// 980, 1989). It is exact to second order in the density, and that of equal spheres is the one
/// above. What ideal gases add is exact, as their centres reach different rooms.
std::optional<double> pressure_of_fluid(EquationOfState equation, const Box& box,
                                        const Particles& particles, const ThermalMotion& thermal);

/// The time-averaged pressure of equal spheres in a periodic box in space that form this phase, as
/// virial_pressure() measures it. Returns nothing for another gas, and where the phase is not the
/// stable one. In a crystal, and where it coexists with a fluid, N spheres whose centre of mass
/// rests have the pressure 2 K Z / (3 V), with the thermal energy K: a crystal's 3 N - 3 vibrations
/// share it evenly. Coexistence is that of a large box, in which the surface between the phases
/// counts for little.
std::optional<double> pressure_of_phase(PhaseOfSpheres phase, const Box& box,
                                        const Particles& particles, const ThermalMotion& thermal);

/// The factor by which to multiply the size of a box so that the gas has this pressure
/// (pressure_of_fluid()) at this thermal motion, to 1e-9 of it. Returns nothing where no size gives
/// the pressure: the gas has no equation of state, or would freeze.
std::optional<double> scale_at_pressure(EquationOfState equation, const Box& box,
                                        const Particles& particles, const ThermalMotion& thermal,
                                        double pressure);

/// The mean force of a fluid between walls, of one radius, on each side across an axis, or through
/// a line or plane across a periodic axis, divided by the temperature: 1/length. Returns nothing
/// where pressure_of_fluid() does, and for several radii.
std::optional<double> force_of_fluid(EquationOfState equation, const Box& box,
                                     const Particles& particles, int axis);

/// The pressure of beads on a line, which is a force: that of points on the length that the rods
/// leave free (Tonks, Phys. Rev. 50, 955, 1936), exact for any number of beads. Returns nothing in
/// a plane or in space, without particles, for infinite masses, or if the beads leave no free
/// length.
std::optional<double> pressure_of_rods(const Box& box, const Particles& particles,
                                       const ThermalMotion& thermal);

}  // namespace carom
