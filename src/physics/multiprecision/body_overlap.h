// Brute-force overlap test of one disk or sphere against all others, used for one that an event has
// displaced.
#pragma once

#include <cstddef>
#include <optional>

#include "physics/box.h"
#include "physics/multiprecision/multiprecision.h"

namespace carom {

/// The first body whose nearest image `moved` overlaps by more than `slack` times the contact
/// distance, when all bodies are at the same time; nothing if there is none. For doubles and for
/// multiprecision.
template <typename Geometry>
std::optional<std::size_t> body_overlapped(const Geometry& geometry,
                                           const typename Geometry::Bodies& bodies,
                                           std::size_t moved, const Box& box, double slack) {
    const auto& x = bodies[moved].x;
    const double radius = geometry.properties(bodies, moved).radius;
    for (std::size_t k = 0; k < bodies.size(); ++k) {
        if (k == moved) continue;
        const double sigma = radius + geometry.properties(bodies, k).radius;
        auto square = as_precise_as(x[0], 0.0);
        for (std::size_t a = 0; a < x.size(); ++a) {
            auto apart = bodies[k].x[a] - x[a];
            const double size = box.length(a);
            apart -= as_precise_as(apart, size) * box.turns(a, static_cast<double>(apart));
            square += apart * apart;
        }
        if (square < as_precise_as(x[0], sigma) * sigma * (1.0 - 2.0 * slack)) return k;
    }
    return std::nullopt;
}

}  // namespace carom
