// Theoretical values of the numbers of runs, known before any run is done.
#pragma once

#include <optional>
#include <string>

#include "physics/theory/equation_of_state.h"
#include "scene/sweep.h"
#include "util/language.h"

namespace carom {

struct Scene;

/// The equilibrium value, exact or a good approximation, of a number of a scene's runs, averaged
/// over some seeds, as these determine the velocities. For pressures: the equation of state of hard
/// disks (Kolafa and Rottner), hard rods (Tonks) or, in the phase that is asked for, hard spheres
/// (Kolafa, Labik and Malijevsky; Speedy); for energies and speeds: equilibrium means; for
/// collisions: Enskog's rate. Returns nothing if no theory is known, or if surfaces or events act
/// on the gas.
std::optional<double> theory_of_number(const std::string& number, const Scene& scene,
                                       const SeedRange& seeds,
                                       PhaseOfSpheres phase = PhaseOfSpheres::fluid);

/// The pressure of an ideal gas in the same box, if the number is a pressure.
std::optional<double> ideal_gas_of_number(const std::string& number, const Scene& scene,
                                          const SeedRange& seeds);

/// The source of the theoretical curve of a number, in words.
Phrase name_of_theory(const std::string& number, const Scene& scene,
                      PhaseOfSpheres phase = PhaseOfSpheres::fluid);
Phrase name_of_ideal_gas();

/// The packing fraction (part of the box that particles cover), and the number density (particles
/// per unit of area or length). Both return nothing if the gas cannot be drawn from its
/// distributions.
std::optional<double> packing_of(const Scene& scene);
std::optional<double> density_of(const Scene& scene);

}  // namespace carom
