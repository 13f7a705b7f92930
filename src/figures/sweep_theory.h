// What theory says of the numbers of runs, before any is done.
#pragma once

#include <optional>
#include <string>

#include "scene/scene.h"
#include "scene/sweep.h"
#include "util/language.h"

namespace carom {

/// What is exactly or well known of a number of a scene's runs in equilibrium: its mean over some
/// seeds, which draw the velocities. Of pressures that of hard disks (Kolafa and Rottner) or of
/// hard rods (Tonks), of energies and speeds those of equilibrium, of collisions the rate by
/// Enskog. Nothing where none is known, and where events act on the gas.
std::optional<double> theory_of_number(const std::string& number, const Scene& scene,
                                       const SeedRange& seeds);

/// The pressure of an ideal gas in the same box, if the number is a pressure.
std::optional<double> ideal_gas_of_number(const std::string& number, const Scene& scene,
                                          const SeedRange& seeds);

/// Where the curve of a number is from, in words.
Phrase name_of_theory(const std::string& number, const Scene& scene);
Phrase name_of_ideal_gas();

/// The part of the box that particles cover, or their number in a unit of area or length; nothing
/// for a gas that cannot be drawn.
std::optional<double> packing_of(const Scene& scene);
std::optional<double> density_of(const Scene& scene);

}  // namespace carom
