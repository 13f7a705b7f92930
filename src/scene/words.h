// The words for the values of each enum in scenes: one table per enum, shared by reading, messages,
// the schema and the reference page.
#pragma once

#include <array>
#include <string_view>

#include "physics/box.h"
#include "physics/units/quantity.h"
#include "scene/looks.h"
#include "scene/panel_spec.h"
#include "util/language.h"

namespace carom {

/// A value of an enum and its word in scenes.
template <typename E>
struct EnumWord {
    E value;
    std::string_view word;
};

/// The table of an enum, in the order in which messages list the words. A value without an entry
/// has no word: it is the default, which is never written.
template <typename E>
inline constexpr std::array<EnumWord<E>, 0> enum_words{};

template <>
inline constexpr auto enum_words<UnitSystem> = std::to_array<EnumWord<UnitSystem>>(
    {{UnitSystem::reduced, "reduced"}, {UnitSystem::real, "real"}});

template <>
inline constexpr auto enum_words<Wall> =
    std::to_array<EnumWord<Wall>>({{Wall::solid, "solid"}, {Wall::periodic, "periodic"}});

template <>
inline constexpr auto enum_words<ThemeName> = std::to_array<EnumWord<ThemeName>>(
    {{ThemeName::light, "light"}, {ThemeName::dark, "dark"}, {ThemeName::print, "print"}});

template <>
inline constexpr auto enum_words<ColorBy> =
    std::to_array<EnumWord<ColorBy>>({{ColorBy::speed, "speed"},
                                      {ColorBy::speed_class, "speed-class"},
                                      {ColorBy::energy, "energy"},
                                      {ColorBy::direction, "direction"},
                                      {ColorBy::species, "species"},
                                      {ColorBy::mass, "mass"}});

template <>
inline constexpr auto enum_words<Labels> =
    std::to_array<EnumWord<Labels>>({{Labels::mass, "mass"}, {Labels::index, "index"}});

template <>
inline constexpr auto enum_words<Monitor> =
    std::to_array<EnumWord<Monitor>>({{Monitor::time, "time"},
                                      {Monitor::collisions, "collisions"},
                                      {Monitor::mean_speed, "mean-speed"},
                                      {Monitor::mean_energy, "mean-energy"},
                                      {Monitor::slow, "slow"},
                                      {Monitor::medium, "medium"},
                                      {Monitor::fast, "fast"},
                                      {Monitor::all_collisions, "all-collisions"},
                                      {Monitor::return_distance, "return-distance"},
                                      {Monitor::overlap, "overlap"}});

template <>
inline constexpr auto enum_words<Language> =
    std::to_array<EnumWord<Language>>({{Language::english, "en"},
                                       {Language::german, "de"},
                                       {Language::french, "fr"},
                                       {Language::spanish, "es"}});

template <>
inline constexpr auto enum_words<FieldOf> =
    std::to_array<EnumWord<FieldOf>>({{FieldOf::density, "density"},
                                      {FieldOf::temperature, "temperature"},
                                      {FieldOf::speed, "speed"},
                                      {FieldOf::flow, "flow"},
                                      {FieldOf::concentration, "concentration"}});

template <>
inline constexpr auto enum_words<SoundOf> = std::to_array<EnumWord<SoundOf>>({{SoundOf::collisions,
                                                                               "collisions"}});

template <>
inline constexpr auto enum_words<Component> =
    std::to_array<EnumWord<Component>>({{Component::x, "x"},
                                        {Component::y, "y"},
                                        {Component::z, "z"},
                                        {Component::xy, "xy"},
                                        {Component::xz, "xz"},
                                        {Component::yz, "yz"},
                                        {Component::both, "both"},
                                        {Component::both, "all"}});

/// The word for a value; empty if it has none.
template <typename E>
constexpr std::string_view word_of(E value) {
    for (const EnumWord<E>& entry : enum_words<E>)
        if (entry.value == value) return entry.word;
    return {};
}

}  // namespace carom
