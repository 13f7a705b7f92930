// The behaviours of surfaces in the course of a run, determined without a simulation. All functions
// may be called from any thread.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "physics/run.h"
#include "physics/surface.h"

namespace carom {

/// Whether a surface with this behaviour moves.
inline bool moves(const Behaviour& behaviour) {
    return std::holds_alternative<Driven>(behaviour) || std::holds_alternative<Piston>(behaviour);
}

/// The surface to which an event gives another behaviour, and that; none for other events.
inline std::optional<std::pair<std::int32_t, Behaviour>> given_behaviour(const RunEvent& event) {
    if (const auto* change = std::get_if<ChangeSurface>(&event.action))
        return {{change->surface, change->behaviour}};
    if (const auto* move = std::get_if<MoveSurface>(&event.action))
        return {{move->surface, Driven{move->velocity}}};
    return {};
}

/// All behaviours that each side and partition has in the course of the run: at the start and after
/// its events.
inline std::vector<std::vector<Behaviour>> behaviours_in_time(const Surfaces& surfaces,
                                                              const Run& run) {
    std::vector<std::vector<Behaviour>> all;
    for (const Behaviour& side : surfaces.sides) all.push_back({side});
    for (const Partition& partition : surfaces.partitions) all.push_back({partition.behaviour});
    for (const RunEvent& event : run.events) {
        const auto given = given_behaviour(event);
        const auto k = given ? static_cast<std::size_t>(given->first) : all.size();
        if (k < all.size()) all[k].push_back(given->second);
    }
    return all;
}

}  // namespace carom
