// What a number is: its dimension, its kind, its word; and the text of its unit, which is made only
// here, from the quantity and the units of the scene. Pure values, safe on any thread.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "util/language.h"

namespace carom {

/// Twice the exponents of length, mass and time, since roots of masses occur.
struct Dimension {
    std::int8_t length = 0, mass = 0, time = 0;
    bool operator==(const Dimension&) const = default;
    constexpr bool is_none() const { return length == 0 && mass == 0 && time == 0; }
};

/// A physical quantity, or a number that is counted or compared.
struct Quantity {
    /// Tells apart quantities of one dimension: with Boltzmann's constant 1 a temperature is an
    /// energy.
    enum class Kind : std::uint8_t {
        derived,  ///< known by its dimension only
        length,
        mass,
        time,
        speed,
        momentum,
        force,
        energy,
        temperature,
        pressure,
        density,  ///< particles per length, area or volume
        rate,
        energy_current,
        number,       ///< a ratio, a correlation
        entropy,      ///< with Boltzmann's constant 1
        coefficient,  ///< of a matrix
        share,        ///< from 0 to 1
        per_cent,
        count,
        count_per_bin,  ///< the height of a bar
        ordinal,        ///< a number in a row: of a piece, of a step
        overlap,        ///< in contact distances
    };
    Kind kind = Kind::number;
    Dimension dimension = {};
    Phrase word = {};           ///< empty: it has none of its own
    bool is_logarithm = false;  ///< the decimal logarithm of a number in the unit

    bool operator==(const Quantity&) const = default;

    /// The same by another word: a mean speed is a speed.
    constexpr Quantity named(Phrase other) const { return {kind, dimension, other, is_logarithm}; }

    /// The quantity to a power, with exponents that are multiples of one half.
    constexpr Quantity to_power(double exponent) const {
        const auto times = [exponent](std::int8_t twice) {
            return static_cast<std::int8_t>(exponent * twice);
        };
        return {Kind::derived,
                {times(dimension.length), times(dimension.mass), times(dimension.time)}};
    }
    constexpr Quantity squared() const { return to_power(2.0); }
    constexpr Quantity root() const { return to_power(0.5); }

    constexpr Quantity logarithm() const { return {kind, dimension, word, true}; }

    /// Products have no word, and no kind but their dimension's.
    friend constexpr Quantity operator*(const Quantity& a, const Quantity& b) {
        const auto sum = [](std::int8_t one, std::int8_t other) {
            return static_cast<std::int8_t>(one + other);
        };
        return {Kind::derived,
                {sum(a.dimension.length, b.dimension.length),
                 sum(a.dimension.mass, b.dimension.mass), sum(a.dimension.time, b.dimension.time)}};
    }
    friend constexpr Quantity operator/(const Quantity& a, const Quantity& b) {
        return a * b.to_power(-1.0);
    }
};

/// The usual quantities. Those of a box depend on its dimension, from 1 to 3.
namespace quantities {

constexpr Quantity of_kind(Quantity::Kind kind, const Quantity& derived, Phrase word = {}) {
    return {kind, derived.dimension, word};
}

using Kind = Quantity::Kind;
inline constexpr Quantity number{Kind::number};
inline constexpr Quantity length{Kind::length, {2, 0, 0}, Phrase{"length"}};
inline constexpr Quantity mass{Kind::mass, {0, 2, 0}, Phrase{"mass"}};
inline constexpr Quantity time{Kind::time, {0, 0, 2}, Phrase{"time"}};
inline constexpr Quantity position = length.named(Phrase{"position"});
inline constexpr Quantity distance = length.named(Phrase{"distance"});
inline constexpr Quantity speed = of_kind(Kind::speed, length / time, Phrase{"speed"});
inline constexpr Quantity velocity = speed.named(Phrase{"velocity"});
inline constexpr Quantity momentum = of_kind(Kind::momentum, mass* speed);
inline constexpr Quantity force = of_kind(Kind::force, momentum / time);
inline constexpr Quantity energy = of_kind(Kind::energy, mass* speed.squared(), Phrase{"energy"});
inline constexpr Quantity mean_energy = energy.named(Phrase{"mean energy"});
inline constexpr Quantity temperature = of_kind(Kind::temperature, energy, Phrase{"temperature"});
inline constexpr Quantity rate = of_kind(Kind::rate, number / time);
inline constexpr Quantity energy_current =
    of_kind(Kind::energy_current, energy / time, Phrase{"energy current"});
inline constexpr Quantity entropy{Kind::entropy, {}, Phrase{"entropy"}};
inline constexpr Quantity coefficient{Kind::coefficient};
inline constexpr Quantity share{Kind::share, {}, Phrase{"share"}};
inline constexpr Quantity per_cent{Kind::per_cent, {}, Phrase{"share"}};
inline constexpr Quantity count{Kind::count};
inline constexpr Quantity count_per_bin{Kind::count_per_bin};
inline constexpr Quantity ordinal{Kind::ordinal};
inline constexpr Quantity overlap{Kind::overlap};

/// What a box holds: a length, an area or a volume.
constexpr Quantity content(int dimension) {
    return dimension == 1 ? length : length.to_power(dimension);
}
constexpr Quantity density(int dimension) {
    return of_kind(Kind::density, number / content(dimension), Phrase{"density"});
}
/// Energy per content: in one dimension a force.
constexpr Quantity pressure(int dimension) {
    return of_kind(Kind::pressure, energy / content(dimension), Phrase{"pressure"});
}

}  // namespace quantities

/// The units of a scene's numbers, and how they are written.
enum class UnitSystem : std::uint8_t {
    reduced,        ///< as powers of a length, a mass and a time: "mass length^2/time^2"
    reduced_names,  ///< by their names: "energy"; of plain numbers empty
    real,           ///< as people know them, by size (unit_table.h): "nm", "m/s", "K"
    si              ///< those of the SI: "m", "kg", "J"; numbers without dimension as in `reduced`
};

/// The text of a quantity's unit: "length/time", "per cent", "1". Empty if it has none. In real
/// units, that of numbers of about one nanometre, atomic mass unit and picosecond.
std::string unit_text(const Quantity& quantity, UnitSystem units);

/// The first of the usual quantities that has this unit, so that a temperature in reduced units is
/// an energy; none if the text is no unit.
std::optional<Quantity> quantity_with_unit(std::string_view unit, UnitSystem units);

/// The units in a sentence.
std::string_view words_of(UnitSystem units);

}  // namespace carom
