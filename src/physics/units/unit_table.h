// Units of measurement by name. A scene in real units is calculated in nanometres, atomic mass
// units and picoseconds, with temperatures as energies; this file converts numbers to these and
// back, and chooses the units in which they are shown. Pure values, safe on any thread.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "physics/units/quantity.h"

namespace carom {

/// A unit in which a scene may give a number. One of it is `factor` * 10^`power` in units of
/// nanometres, atomic mass units and picoseconds.
struct Unit {
    std::string_view name;  ///< as scenes write it: "m/s2"
    Quantity quantity;      ///< what it measures
    double factor;          ///< 1, or at least 0.1 and below 10
    int power;
};

/// Returns all units, those of a dimension from small to large.
std::span<const Unit> all_units();

/// Returns the unit of this name; null if there is none. `um` may be written with a micro sign,
/// `m/s2` as m/s^2 or with a superscript, `angstrom` with its letter.
const Unit* unit_named(std::string_view name);

/// Returns whether numbers of the quantity may have the unit. A temperature is no energy here.
bool measures(const Unit& unit, const Quantity& quantity);

/// Returns a decimal number of this unit in nanometres, atomic mass units and picoseconds, where a
/// temperature T is kT: correctly rounded where the factor is 1, otherwise to 1 ulp. Nothing if the
/// text is no decimal number or the result no finite double.
std::optional<double> in_base_units(std::string_view decimal, const Unit& unit);

/// Returns the converse, to 1 ulp.
double from_base_units(double value, const Unit& unit);

/// Returns a number that is given in nanometres, atomic mass units and picoseconds in SI: metres,
/// kilograms, seconds, joules, pascals, and a temperature in kelvins. A logarithm is that of the
/// number in SI.
double in_si(double value, const Quantity& quantity);

/// A unit for numbers that are shown: each is multiplied by the factor.
struct ShownUnit {
    std::string name;  ///< "nm"; empty: it has none
    double factor = 1.0;
};

/// Returns the unit in which numbers up to the size `largest` are shown, so that the largest is at
/// least 1 where the unit has prefixes. Other units than real ones are not converted.
ShownUnit shown_unit(const Quantity& quantity, UnitSystem units, double largest);

/// Returns the unit of a quantity in which a scene in real units is calculated: "nm", "u nm/ps".
std::string unit_of_calculation(const Quantity& quantity);

/// Returns what messages call a quantity ("a length") and an example of a number of it ("0.17
/// nm").
std::string quantity_words(const Quantity& quantity);
std::string unit_example(const Quantity& quantity);

}  // namespace carom
