// Numbers as viewers read them, in real units each with its unit. In reduced units these are the
// functions of the same names in util/language.h. Pure functions, safe on any thread.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "physics/units/quantity.h"
#include "util/language.h"

namespace carom {

/// How numbers are written: in a language, and in units. Where only the language matters, it is
/// that.
struct Wording {
    Language language = Language::english;
    UnitSystem units = UnitSystem::reduced;
    operator Language() const { return language; }  // NOLINT(google-explicit-constructor)
};

/// "1.25", in real units "397 m/s": the unit is that of the size of the number itself, or of the
/// larger end of the range.
std::string three_digits(const Wording& wording, const Quantity& quantity, double value);
std::string plain_number(const Wording& wording, const Quantity& quantity, double value);
std::string with_error(const Wording& wording, const Quantity& quantity, double value,
                       double error);
std::string steady_number(const Wording& wording, const Quantity& quantity, double value,
                          std::pair<double, double> range);

/// All digits of a number, in real units six of them and the unit.
std::string all_digits(const Wording& wording, const Quantity& quantity, double value);

/// Several numbers in the unit of the largest, which follows the last: "12, 9 and 9 nm".
std::string listed_numbers(const Wording& wording, const Quantity& quantity,
                           const std::vector<double>& values);

/// A number in messages and reports, with all its digits in reduced units: "40", "40 nm".
std::string number_words(UnitSystem units, const Quantity& quantity, double value);

/// The unit of numbers up to `largest`, as it follows one: " nm"; empty for numbers without
/// dimension, and where units are reduced.
std::string unit_after_number(UnitSystem units, const Quantity& quantity, double largest);

}  // namespace carom
