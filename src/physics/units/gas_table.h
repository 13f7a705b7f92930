// Gases by name: the masses of their molecules, and the diameters of hard spheres that have their
// viscosity. Pure values, safe on any thread.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "util/language.h"

namespace carom {

/// A gas that scenes may name. Its molecules are taken for smooth hard spheres, which neither
/// rotate nor vibrate: true of atoms, a model of molecules.
struct NamedGas {
    Phrase name;              ///< as scenes write it: "carbon dioxide"
    std::string_view symbol;  ///< "CO₂"; of a mixture its name
    double mass;              ///< of a molecule, in atomic mass units
    double viscosity;         ///< in micropascal seconds, at the temperature of the table
    double diameter;          ///< of a hard sphere, in nanometres
    std::string_view color;   ///< #rrggbb, of its spheres in pictures
    bool is_monatomic;        ///< whether it consists of single atoms
};

/// The temperature in kelvins that the viscosities belong to.
inline constexpr double temperature_of_viscosities = 300.0;

/// Returns all gases: noble gases, then gases of molecules, from light to heavy. Their diameters d
/// are those of hard spheres of mass m whose dilute gas has the viscosity eta of the table at its
/// temperature T, rounded to picometres: d^2 = 1.016 5/16 sqrt(m k T / pi) / eta, where 1.016 is
/// the fourth approximation to the theory of Chapman and Enskog (Chapman and Cowling, The
/// Mathematical Theory of Non-uniform Gases, section 10.21).
std::span<const NamedGas> named_gases();

/// Returns the gas of this name; null if there is none.
const NamedGas* gas_named(std::string_view name);

/// Returns its symbol without lowered digits: "CO2".
std::string plain_symbol(const NamedGas& gas);

}  // namespace carom
