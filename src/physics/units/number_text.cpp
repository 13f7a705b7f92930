#include "physics/units/number_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "physics/units/unit_table.h"

namespace carom {
namespace {

constexpr std::string_view no_break_space = "\u00a0";

bool has_unit(UnitSystem units, const Quantity& quantity) {
    return units == UnitSystem::real && !quantity.is_logarithm &&
           (!quantity.dimension.is_none() || quantity.kind == Quantity::Kind::entropy);
}

// Calls `text` with the factor of the unit for numbers up to `largest`, and appends the unit.
template <class TextOf>
std::string in_unit(UnitSystem units, const Quantity& quantity, double largest,
                    const TextOf& text) {
    if (!has_unit(units, quantity)) return text(1.0);
    const ShownUnit unit = shown_unit(quantity, units, largest);
    return text(unit.factor) + std::string(no_break_space) + unit.name;
}

}  // namespace

std::string three_digits(const Wording& wording, const Quantity& quantity, double value) {
    return in_unit(wording.units, quantity, value,
                   [&](double factor) { return three_digits(wording.language, factor * value); });
}

std::string plain_number(const Wording& wording, const Quantity& quantity, double value) {
    return in_unit(wording.units, quantity, value,
                   [&](double factor) { return plain_number(wording.language, factor * value); });
}

std::string all_digits(const Wording& wording, const Quantity& quantity, double value) {
    return has_unit(wording.units, quantity)
               ? plain_number(wording, quantity, value)
               : localised(wording.language, fmt::format("{}", value));
}

std::string with_error(const Wording& wording, const Quantity& quantity, double value,
                       double error) {
    const bool has_error = error > 0.0 && std::isfinite(error);
    return in_unit(wording.units, quantity, value, [&](double factor) {
        const std::string words = with_error(wording.language, factor * value, factor * error);
        return has_error && has_unit(wording.units, quantity) ? "(" + words + ")" : words;
    });
}

std::string steady_number(const Wording& wording, const Quantity& quantity, double value,
                          std::pair<double, double> range) {
    const double largest = std::max(std::abs(range.first), std::abs(range.second));
    return in_unit(wording.units, quantity, largest, [&](double factor) {
        return steady_number(wording.language, factor * value,
                             {factor * range.first, factor * range.second});
    });
}

std::string listed_numbers(const Wording& wording, const Quantity& quantity,
                           const std::vector<double>& values) {
    double largest = 0.0;
    for (const double value : values) largest = std::max(largest, std::abs(value));
    return in_unit(wording.units, quantity, largest, [&](double factor) {
        std::vector<std::string> words;
        for (const double value : values)
            words.push_back(plain_number(wording.language, factor * value));
        return listed(wording.language, words);
    });
}

std::string number_words(UnitSystem units, const Quantity& quantity, double value) {
    if (!has_unit(units, quantity)) return fmt::format("{}", value);
    const ShownUnit unit = shown_unit(quantity, units, value);
    return fmt::format("{:.6g} {}", value * unit.factor, unit.name);
}

std::string unit_after_number(UnitSystem units, const Quantity& quantity, double largest) {
    if (!has_unit(units, quantity)) return "";
    return std::string(no_break_space) + shown_unit(quantity, units, largest).name;
}

}  // namespace carom
