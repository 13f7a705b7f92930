// The part of the event loop that refuses to go on: collisions without end, or too many. Included
// only by event_loop_steps.h.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "physics/collision_error.h"
#include "physics/events/event_loop.h"

namespace carom {

template <int Dimension, typename Scalar, bool has_surfaces>
void EventLoop<Dimension, Scalar, has_surfaces>::move_on_to(const Scalar& time,
                                                            std::optional<std::int32_t> i) {
    if (static_cast<double>(time) > static_cast<double>(now_))
        at_one_instant_ = 0;
    else
        refuse_to_stall(i);
    now_ = time;
}

// Initial states with touching particles cause some events at time 0, but far fewer than this
// bound. Times count as one instant if they are equal as doubles: with many bits, the events of
// bodies that are being crushed could go on almost without end at ever closer but distinct times.
template <int Dimension, typename Scalar, bool has_surfaces>
void EventLoop<Dimension, Scalar, has_surfaces>::refuse_to_stall(std::optional<std::int32_t> i) {
    const auto bound = 1'000'000 + 100 * static_cast<std::int64_t>(bodies_.size());
    if (++at_one_instant_ <= bound) return;
    if constexpr (has_surfaces)
        if (const auto surface = geometry_.surfaces().hardest_worker()) throw crushes(*surface);
    refuse_endless(i);
}

template <int Dimension, typename Scalar, bool has_surfaces>
void EventLoop<Dimension, Scalar, has_surfaces>::refuse_endless(std::optional<std::int32_t> i) {
    const bool falls = box_.surfaces.has_gravity();
    throw CollisionError(
        fmt::format(
            "{} collide without end at t = {:g}: they fill the box along a line, or are squeezed "
            "between infinite or far heavier masses{}",
            Dimension == 1   ? "beads"
            : Dimension == 2 ? "disks"
                             : "spheres",
            clock_.absolute(now_),
            falls ? ", or lie without velocity on an obstacle, a piston or one another" : ""),
        i ? std::optional(number_of(*i)) : std::nullopt);
}

// Processes some more events to find how fast collisions follow each other and which particle takes
// part in most of them.
template <int Dimension, typename Scalar, bool has_surfaces>
void EventLoop<Dimension, Scalar, has_surfaces>::refuse_more_collisions() {
    constexpr int events_seen = 4096;
    std::map<std::int32_t, std::int64_t> of_particle;
    CollisionsSeen seen{.most = most_, .begin = clock_.absolute(now_), .ties = counts_.ties};
    for (int k = 0; k < events_seen; ++k) {
        const std::int32_t i = next_particle();
        Collision collision;
        if (i < 0) break;
        if (!process(i, &collision)) continue;
        ++seen.count;
        ++of_particle[collision.first];
        if (collision.second.is_particle()) ++of_particle[collision.second.particle()];
    }
    const auto busiest =
        std::ranges::max_element(of_particle, {}, [](auto& one) { return one.second; });
    seen.end = clock_.absolute(now_);
    if (busiest != of_particle.end() && 2 * busiest->second > seen.count) {
        const auto k = std::ranges::find(number_, busiest->first) - number_.begin();
        const Body& b = bodies_[static_cast<std::size_t>(k)];
        seen.particle = busiest->first;
        for (std::size_t a = 0; a < Dimension; ++a)
            seen.place.push_back(
                box_.wrapped(a, static_cast<double>(position_at(b, a, Scalar(now_)))));
    }
    throw TooManyCollisions(seen);
}

}  // namespace carom
