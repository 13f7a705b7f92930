#include "physics/units/quantity.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "physics/units/unit_table.h"

namespace carom {
namespace {

std::string base_to_power(const char* base, int twice) {
    return twice == 2 ? base : fmt::format("{}^{}", base, 0.5 * twice);
}

// "mass length^2/time^2", "1/length"; with the names of a mass, a length and a time.
std::string text_of_powers(const Dimension& dimension,
                           const std::array<const char*, 3>& names = {"mass", "length", "time"}) {
    const std::array<std::pair<const char*, int>, 3> powers{
        {{names[0], dimension.mass}, {names[1], dimension.length}, {names[2], dimension.time}}};
    std::string over, under;
    int under_count = 0;
    for (const auto& [base, twice] : powers) {
        if (twice == 0) continue;
        std::string& side = twice > 0 ? over : under;
        side += (side.empty() ? "" : " ") + base_to_power(base, std::abs(twice));
        if (twice < 0) ++under_count;
    }
    if (over.empty()) over = "1";
    if (under_count > 1) under = "(" + under + ")";
    return under.empty() ? over : over + "/" + under;
}

std::string text_of_number(Quantity::Kind kind) {
    switch (kind) {
        case Quantity::Kind::per_cent:
            return "per cent";
        case Quantity::Kind::count:
        case Quantity::Kind::count_per_bin:
            return "count";
        case Quantity::Kind::coefficient:
        case Quantity::Kind::ordinal:
            return "number";
        case Quantity::Kind::overlap:
            return "contact distances";
        default:
            return "1";
    }
}

// Of quantities of the same dimension the first gives the name, so that a pressure on a line is a
// force.
constexpr std::array named_units{
    std::pair{quantities::energy, "energy"}, std::pair{quantities::force, "force"},
    std::pair{quantities::momentum, "momentum"}, std::pair{quantities::pressure(2), "energy/area"},
    std::pair{quantities::pressure(3), "energy/volume"}};

std::string name_of_unit(const Quantity& quantity) {
    if (quantity.kind == Quantity::Kind::overlap) return text_of_number(quantity.kind);
    if (quantity.dimension.is_none()) return "";
    for (const auto& [unit, name] : named_units)
        if (unit.dimension == quantity.dimension) return name;
    return text_of_powers(quantity.dimension);
}

std::string si_unit(const Quantity& quantity) {
    if (quantity.dimension.is_none()) return text_of_number(quantity.kind);
    if (quantity.kind == Quantity::Kind::temperature) return "K";
    for (const auto& [unit, name] : {std::pair{quantities::energy, "J"},
                                     {quantities::force, "N"},
                                     {quantities::pressure(2), "N/m"},
                                     {quantities::pressure(3), "Pa"},
                                     {quantities::energy_current, "W"}})
        if (unit.dimension == quantity.dimension) return name;
    return text_of_powers(quantity.dimension, {"kg", "m", "s"});
}

}  // namespace

namespace quantities {
namespace {

// Those that come first give numbers with an ambiguous unit their kind.
constexpr std::array usual{
    number,      length,   mass,  time,        speed,       momentum,       energy,     pressure(1),
    pressure(2), force,    rate,  density(1),  pressure(3), density(2),     density(3), content(2),
    content(3),  per_cent, count, coefficient, overlap,     energy_current, temperature};

}  // namespace
}  // namespace quantities

std::string unit_text(const Quantity& quantity, UnitSystem units) {
    if (quantity.is_logarithm) return "";
    if (units == UnitSystem::real) return shown_unit(quantity, units, 1.0).name;
    if (units == UnitSystem::si) return si_unit(quantity);
    if (units == UnitSystem::reduced_names) return name_of_unit(quantity);
    return quantity.dimension.is_none() ? text_of_number(quantity.kind)
                                        : text_of_powers(quantity.dimension);
}

std::optional<Quantity> quantity_with_unit(std::string_view unit, UnitSystem units) {
    const auto found = std::ranges::find_if(
        quantities::usual, [&](const Quantity& one) { return unit_text(one, units) == unit; });
    return found == quantities::usual.end() ? std::nullopt : std::optional(*found);
}

std::string_view words_of(UnitSystem units) {
    if (units == UnitSystem::real) return "real units";
    if (units == UnitSystem::si) return "SI";
    return "reduced units: a length, a mass and a time of the scene, Boltzmann's constant is 1";
}

}  // namespace carom
