#include "physics/units/unit_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace carom {
namespace {

// The Boltzmann and Avogadro constants and the electronvolt are exact; the atomic mass constant is
// that of CODATA 2022, 1.660 539 068 92(52)e-27 kg (Mohr, Newell, Taylor, Tiesinga, Rev. Mod. Phys.
// 97, 025002 (2025), table XXXI and XXXIV; physics.nist.gov/constants). Powers of ten stand apart.
constexpr double u_in_kg = 1.66053906892;     // e-27
constexpr double boltzmann = 1.380649;        // e-23 J/K
constexpr double avogadro = 6.02214076;       // e23/mol
constexpr double electronvolt = 1.602176634;  // e-19 J
constexpr double standard_gravity = 9.80665;  // m/s2, exact
constexpr double atmosphere = 1.01325;        // e5 Pa, exact

// One kilogram is this times 1e27 u, one joule this times 1e21 u nm2/ps2.
constexpr double kg_in_u = 1.0 / u_in_kg;

namespace q = quantities;

constexpr Quantity acceleration =
    q::of_kind(Quantity::Kind::derived, q::speed / q::time, Phrase{"acceleration"});
constexpr Quantity mass_density(int dimension) { return q::mass / q::content(dimension); }

constexpr std::array units{
    Unit{"fm", q::length, 1.0, -6},
    Unit{"pm", q::length, 1.0, -3},
    Unit{"angstrom", q::length, 1.0, -1},
    Unit{"nm", q::length, 1.0, 0},
    Unit{"um", q::length, 1.0, 3},
    Unit{"mm", q::length, 1.0, 6},
    Unit{"cm", q::length, 1.0, 7},
    Unit{"m", q::length, 1.0, 9},
    Unit{"km", q::length, 1.0, 12},
    Unit{"u", q::mass, 1.0, 0},
    Unit{"fg", q::mass, kg_in_u, 9},
    Unit{"pg", q::mass, kg_in_u, 12},
    Unit{"ng", q::mass, kg_in_u, 15},
    Unit{"ug", q::mass, kg_in_u, 18},
    Unit{"mg", q::mass, kg_in_u, 21},
    Unit{"g", q::mass, kg_in_u, 24},
    Unit{"kg", q::mass, kg_in_u, 27},
    Unit{"fs", q::time, 1.0, -3},
    Unit{"ps", q::time, 1.0, 0},
    Unit{"ns", q::time, 1.0, 3},
    Unit{"us", q::time, 1.0, 6},
    Unit{"ms", q::time, 1.0, 9},
    Unit{"s", q::time, 1.0, 12},
    Unit{"uK", q::temperature, boltzmann* kg_in_u, -8},
    Unit{"mK", q::temperature, boltzmann* kg_in_u, -5},
    Unit{"K", q::temperature, boltzmann* kg_in_u, -2},
    Unit{"mm/s", q::speed, 1.0, -6},
    Unit{"cm/s", q::speed, 1.0, -5},
    Unit{"m/s", q::speed, 1.0, -3},
    Unit{"km/s", q::speed, 1.0, 0},
    Unit{"m/s2", acceleration, 1.0, -15},
    Unit{"g0", acceleration, standard_gravity, -15},
    Unit{"zJ", q::energy, kg_in_u, 0},
    Unit{"kJ/mol", q::energy, 10.0 / avogadro* kg_in_u, 0},
    Unit{"meV", q::energy, electronvolt* kg_in_u, -1},
    Unit{"eV", q::energy, electronvolt* kg_in_u, 2},
    Unit{"keV", q::energy, electronvolt* kg_in_u, 5},
    Unit{"aJ", q::energy, kg_in_u, 3},
    Unit{"fJ", q::energy, kg_in_u, 6},
    Unit{"pJ", q::energy, kg_in_u, 9},
    Unit{"nJ", q::energy, kg_in_u, 12},
    Unit{"uJ", q::energy, kg_in_u, 15},
    Unit{"mJ", q::energy, kg_in_u, 18},
    Unit{"J", q::energy, kg_in_u, 21},
    Unit{"kJ", q::energy, kg_in_u, 24},
    Unit{"fN", q::force, kg_in_u, -3},
    Unit{"pN", q::force, kg_in_u, 0},
    Unit{"nN", q::force, kg_in_u, 3},
    Unit{"uN", q::force, kg_in_u, 6},
    Unit{"mN", q::force, kg_in_u, 9},
    Unit{"N", q::force, kg_in_u, 12},
    Unit{"Pa", q::pressure(3), kg_in_u, -6},
    Unit{"hPa", q::pressure(3), kg_in_u, -4},
    Unit{"mbar", q::pressure(3), kg_in_u, -4},
    Unit{"kPa", q::pressure(3), kg_in_u, -3},
    Unit{"bar", q::pressure(3), kg_in_u, -1},
    Unit{"atm", q::pressure(3), atmosphere* kg_in_u, -1},
    Unit{"MPa", q::pressure(3), kg_in_u, 0},
    Unit{"GPa", q::pressure(3), kg_in_u, 3},
    Unit{"uN/m", q::pressure(2), kg_in_u, -3},
    Unit{"mN/m", q::pressure(2), kg_in_u, 0},
    Unit{"N/m", q::pressure(2), kg_in_u, 3},
    Unit{"1/m3", q::density(3), 1.0, -27},
    Unit{"1/nm3", q::density(3), 1.0, 0},
    Unit{"mol/l", q::density(3), avogadro, -1},
    Unit{"1/m2", q::density(2), 1.0, -18},
    Unit{"1/nm2", q::density(2), 1.0, 0},
    Unit{"1/m", q::density(1), 1.0, -9},
    Unit{"1/nm", q::density(1), 1.0, 0},
    Unit{"kg/m3", mass_density(3), kg_in_u, 0},
    Unit{"g/cm3", mass_density(3), kg_in_u, 3},
    Unit{"kg/m2", mass_density(2), kg_in_u, 9},
    Unit{"kg/m", mass_density(1), kg_in_u, 18},
    Unit{"Ns", q::momentum, kg_in_u, 24},
    Unit{"u m/s", q::momentum, 1.0, -3},
    Unit{"1/us", q::rate, 1.0, -6},
    Unit{"1/ns", q::rate, 1.0, -3},
    Unit{"1/ps", q::rate, 1.0, 0},
    Unit{"fW", q::energy_current, kg_in_u, -6},
    Unit{"pW", q::energy_current, kg_in_u, -3},
    Unit{"nW", q::energy_current, kg_in_u, 0},
    Unit{"uW", q::energy_current, kg_in_u, 3},
    Unit{"nm2", q::content(2), 1.0, 0},
    Unit{"um2", q::content(2), 1.0, 6},
    Unit{"nm3", q::content(3), 1.0, 0},
    Unit{"um3", q::content(3), 1.0, 9},
    Unit{"nm2/ps", q::content(2) / q::time, 1.0, 0},
};

// The units in which numbers are shown, of each dimension from small to large.
constexpr std::array shown_names{
    "fm",   "pm",   "nm",    "um",    "mm",   "m",     "u",     "fg",    "pg",    "ng",   "ug",
    "mg",   "g",    "kg",    "fs",    "ps",   "ns",    "us",    "ms",    "s",     "K",    "m/s",
    "m/s2", "zJ",   "aJ",    "fJ",    "pJ",   "nJ",    "uJ",    "mJ",    "J",     "fN",   "pN",
    "nN",   "uN",   "mN",    "N",     "Pa",   "kPa",   "bar",   "MPa",   "GPa",   "uN/m", "mN/m",
    "N/m",  "1/nm", "1/nm2", "1/nm3", "kg/m", "kg/m2", "kg/m3", "u m/s", "1/us",  "1/ns", "1/ps",
    "fW",   "pW",   "nW",    "uW",    "nm2",  "um2",   "nm3",   "um3",   "nm2/ps"};

bool is_shown(const Unit& unit) {
    return std::ranges::find(shown_names, unit.name) != shown_names.end();
}

void replace_all(std::string& text, std::string_view what, std::string_view by) {
    for (std::size_t at = text.find(what); at != text.npos; at = text.find(what, at + by.size()))
        text.replace(at, what.size(), by);
}

// A decimal number times a power of ten, correctly rounded.
std::optional<double> shifted(std::string_view decimal, int power) {
    if (decimal.starts_with('+')) decimal.remove_prefix(1);
    const std::size_t mark = std::min(decimal.find_first_of("eE"), decimal.size());
    std::string_view exponent = decimal.substr(std::min(mark + 1, decimal.size()));
    if (exponent.starts_with('+')) exponent.remove_prefix(1);
    int written = 0;
    if (mark < decimal.size()) {
        const auto [end, error] =
            std::from_chars(exponent.data(), exponent.data() + exponent.size(), written);
        constexpr int most = 100'000;
        if (error != std::errc{} || end != exponent.data() + exponent.size() ||
            std::abs(written) > most)
            return std::nullopt;
    }
    const std::string all = fmt::format("{}e{}", decimal.substr(0, mark), written + power);
    double value = 0.0;
    const auto [end, error] = std::from_chars(all.data(), all.data() + all.size(), value);
    if (error != std::errc{} || end != all.data() + all.size()) return std::nullopt;
    return value;
}

double shifted(double value, int power) {
    return std::isfinite(value) ? shifted(fmt::format("{}", value), power).value_or(value * 0.0)
                                : value;
}

// With signs as scenes write them replaced by those of print: "um2" by "μm²".
std::string printed(std::string_view name) {
    std::string text(name);
    if (text.starts_with('u') && text.size() > 1 && text[1] != ' ') text.replace(0, 1, "μ");
    replace_all(text, "/us", "/μs");
    if (text.ends_with('2')) text.replace(text.size() - 1, 1, "²");
    if (text.ends_with('3')) text.replace(text.size() - 1, 1, "³");
    replace_all(text, "m2/", "m²/");
    return text;
}

}  // namespace

std::span<const Unit> all_units() { return units; }

const Unit* unit_named(std::string_view name) {
    std::string plain(name);
    for (const auto& [from, to] :
         {std::pair{"µ", "u"}, {"μ", "u"}, {"²", "2"}, {"³", "3"}, {"^", ""}, {"₀", "0"}})
        replace_all(plain, from, to);
    for (const std::string_view letter : {"Å", "Å"})
        if (plain == letter) plain = "angstrom";
    const auto found = std::ranges::find(units, plain, &Unit::name);
    return found == units.end() ? nullptr : &*found;
}

bool measures(const Unit& unit, const Quantity& quantity) {
    const auto is_temperature = [](const Quantity& its) {
        return its.kind == Quantity::Kind::temperature;
    };
    return unit.quantity.dimension == quantity.dimension &&
           is_temperature(unit.quantity) == is_temperature(quantity);
}

std::optional<double> in_base_units(std::string_view decimal, const Unit& unit) {
    const auto value = shifted(decimal, unit.power);
    if (!value || !std::isfinite(*value * unit.factor)) return std::nullopt;
    return *value * unit.factor;
}

double from_base_units(double value, const Unit& unit) {
    return shifted(value / unit.factor, -unit.power);
}

double in_si(double value, const Quantity& quantity) {
    const auto [length, mass, time] = quantity.dimension;
    int twice = -9 * length - 27 * mass - 12 * time;  // exponent of ten
    double factor = 1.0;
    for (int k = 0; k < std::abs(mass) / 2; ++k) factor *= u_in_kg;
    if (mass % 2 != 0) factor *= std::sqrt(u_in_kg);
    if (mass < 0) factor = 1.0 / factor;
    if (quantity.kind == Quantity::Kind::temperature) {
        factor /= boltzmann;
        twice += 2 * 23;
    }
    if (twice % 2 != 0) {
        factor *= std::sqrt(10.0);
        --twice;
    }
    if (quantity.is_logarithm) return value + std::log10(factor) + 0.5 * twice;
    return shifted(value * factor, twice / 2);
}

std::string unit_of_calculation(const Quantity& quantity) {
    std::string text =
        unit_text(Quantity{Quantity::Kind::derived, quantity.dimension}, UnitSystem::reduced);
    replace_all(text, "length", "nm");
    replace_all(text, "mass", "u");
    replace_all(text, "time", "ps");
    return text;
}

ShownUnit shown_unit(const Quantity& quantity, UnitSystem system, double largest) {
    if (system != UnitSystem::real) return {unit_text(quantity, system), 1.0};
    if (quantity.is_logarithm) return {"", 1.0};
    if (quantity.kind == Quantity::Kind::entropy) return {"k", 1.0};
    if (quantity.dimension.is_none()) return {unit_text(quantity, UnitSystem::reduced), 1.0};
    const Unit* best = nullptr;
    constexpr double round_off = 1e-9;
    for (const Unit& unit : units) {
        if (!measures(unit, quantity) || !is_shown(unit)) continue;
        const double size = shifted(unit.factor, unit.power);
        if (best == nullptr || std::abs(largest) * (1.0 + round_off) >= size) best = &unit;
        if (largest == 0.0 && unit.power == 0) best = &unit;
    }
    if (best == nullptr) return {unit_of_calculation(quantity), 1.0};
    return {printed(best->name), shifted(1.0 / best->factor, -best->power)};
}

std::string quantity_words(const Quantity& quantity) {
    using Kind = Quantity::Kind;
    switch (quantity.kind) {
        case Kind::length:
            return "a length";
        case Kind::mass:
            return "a mass";
        case Kind::time:
            return "a time";
        case Kind::speed:
            return "a speed";
        case Kind::momentum:
            return "a momentum";
        case Kind::force:
            return "a force";
        case Kind::energy:
            return "an energy";
        case Kind::temperature:
            return "a temperature";
        case Kind::pressure:
            return "a pressure";
        case Kind::density:
            return "a number of particles per content";
        default:
            break;
    }
    if (quantity.dimension == acceleration.dimension) return "an acceleration";
    return "a mass per content";
}

std::string unit_example(const Quantity& quantity) {
    using Kind = Quantity::Kind;
    switch (quantity.kind) {
        case Kind::length:
            return "0.17 nm";
        case Kind::mass:
            return "39.948 u";
        case Kind::time:
            return "60 ps";
        case Kind::speed:
            return "400 m/s";
        case Kind::temperature:
            return "300 K";
        case Kind::pressure:
            return quantity.dimension == q::pressure(3).dimension ? "1 bar" : "1 mN/m";
        default:
            break;
    }
    const auto found = std::ranges::find_if(
        units, [&](const Unit& unit) { return measures(unit, quantity) && is_shown(unit); });
    return found == units.end() ? "" : fmt::format("1 {}", found->name);
}

}  // namespace carom
