// The words that scenes have for the values of an enum: one table for each enum, which reading,
// messages, the schema and the reference page share.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "physics/gas.h"
#include "scene/scene.h"

namespace carom {

/// A value of an enum, and how scenes write it.
template <typename E>
struct EnumWord {
    E value;
    std::string_view word;
};

/// The table of an enum, `table`, in the order in which messages list its words. A value that is
/// not in it has no word: it is the default that nothing needs to be written for.
template <typename E>
struct EnumWords;

template <>
struct EnumWords<Wall> {
    static constexpr std::array<EnumWord<Wall>, 2> table{
        {{Wall::solid, "solid"}, {Wall::periodic, "periodic"}}};
};

template <>
struct EnumWords<ThemeName> {
    static constexpr std::array<EnumWord<ThemeName>, 3> table{
        {{ThemeName::light, "light"}, {ThemeName::dark, "dark"}, {ThemeName::print, "print"}}};
};

template <>
struct EnumWords<ColorBy> {
    static constexpr std::array<EnumWord<ColorBy>, 5> table{{{ColorBy::speed, "speed"},
                                                             {ColorBy::speed_class, "speed-class"},
                                                             {ColorBy::energy, "energy"},
                                                             {ColorBy::species, "species"},
                                                             {ColorBy::mass, "mass"}}};
};

template <>
struct EnumWords<Labels> {
    static constexpr std::array<EnumWord<Labels>, 2> table{
        {{Labels::mass, "mass"}, {Labels::index, "index"}}};
};

template <>
struct EnumWords<Monitor> {
    static constexpr std::array<EnumWord<Monitor>, 9> table{
        {{Monitor::time, "time"},
         {Monitor::collisions, "collisions"},
         {Monitor::mean_speed, "mean-speed"},
         {Monitor::mean_energy, "mean-energy"},
         {Monitor::slow, "slow"},
         {Monitor::medium, "medium"},
         {Monitor::fast, "fast"},
         {Monitor::all_collisions, "all-collisions"},
         {Monitor::return_distance, "return-distance"}}};
};

template <>
struct EnumWords<Component> {
    static constexpr std::array<EnumWord<Component>, 3> table{
        {{Component::x, "x"}, {Component::y, "y"}, {Component::both, "both"}}};
};

/// The word for a value; empty if it has none.
template <typename E>
constexpr std::string_view word_of(E value) {
    for (const EnumWord<E>& entry : EnumWords<E>::table)
        if (entry.value == value) return entry.word;
    return {};
}

/// The value of a word, if it is one of the table's.
template <typename E>
constexpr std::optional<E> value_of(std::string_view word) {
    for (const EnumWord<E>& entry : EnumWords<E>::table)
        if (entry.word == word) return entry.value;
    return std::nullopt;
}

}  // namespace carom
