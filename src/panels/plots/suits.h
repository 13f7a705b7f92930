// For which gases a panel has something to show: whether their speeds change, and their energy.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <variant>

#include "physics/gas.h"
#include "physics/run.h"

namespace carom {

/// Whether something in the box, or an event, changes the energy of particles or their places.
inline bool acts_on_gas(const Gas& gas, const Run& run) {
    return !gas.box.surfaces.are_plain() || std::ranges::any_of(run.events, heats);
}

/// Whether collisions redistribute speeds: equal beads on a line, and a single pair, only exchange
/// them.
inline bool speeds_spread(const Gas& gas, const Run& run) {
    const auto common_mass = [](const Species& species) -> std::optional<double> {
        const auto* mass = std::get_if<ValueRule>(&species.mass);
        const double* value = mass == nullptr ? nullptr : std::get_if<double>(mass);
        return value == nullptr ? std::nullopt : std::optional(*value);
    };
    const std::optional<double> first = common_mass(gas.species.front());
    std::int64_t count = 0;
    for (const Species& species : gas.species) count += species.count;
    const bool all_equal = first && std::ranges::all_of(gas.species, [&](const Species& species) {
                               return common_mass(species) == first;
                           });
    if (acts_on_gas(gas, run)) return true;
    return count > 2 && !(gas.box.dimension == 1 && all_equal);
}

}  // namespace carom
