// The behaviours of surfaces in the course of a run, determined without a simulation. All functions
// may be called from any thread.
#pragma once

#include <cstdint>
#include <vector>

#include "physics/run.h"
#include "physics/surface.h"

namespace carom {

/// Whether a surface with this behaviour moves.
inline bool moves(const Behaviour& behaviour) {
    return std::holds_alternative<Driven>(behaviour) || std::holds_alternative<Piston>(behaviour);
}

/// All behaviours that each side and partition has in the course of the run: at the start and after
/// its events.
inline std::vector<std::vector<Behaviour>> behaviours_in_time(const Surfaces& surfaces,
                                                              const Run& run) {
    std::vector<std::vector<Behaviour>> all;
    for (const Behaviour& side : surfaces.sides) all.push_back({side});
    for (const Partition& partition : surfaces.partitions) all.push_back({partition.behaviour});
    const auto add = [&](std::int32_t surface, const Behaviour& behaviour) {
        const auto k = static_cast<std::size_t>(surface);
        if (k < all.size()) all[k].push_back(behaviour);
    };
    for (const RunEvent& event : run.events) {
        if (const auto* change = std::get_if<ChangeSurface>(&event.action))
            add(change->surface, change->behaviour);
        if (const auto* move = std::get_if<MoveSurface>(&event.action))
            add(move->surface, Driven{move->velocity});
    }
    return all;
}

}  // namespace carom
