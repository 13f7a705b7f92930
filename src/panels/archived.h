// How an Archive writes and reads plain values of the modules below.
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "draw/geometry.h"
#include "physics/advance_result.h"
#include "physics/particles.h"
#include "scene/time/timeline.h"
#include "util/archive.h"

namespace carom {

/// A value that several share and none changes; it may be null.
template <class T>
void archive_parts(Archive& archive, std::shared_ptr<const T>& its) {
    std::optional<T> value;
    if (its) value = *its;
    archive(value);
    if (archive.is_reading()) its = value ? std::make_shared<const T>(*std::move(value)) : nullptr;
}

inline void archive_parts(Archive& archive, Point& point) { archive(point.x, point.y); }

inline void archive_parts(Archive& archive, Collision& its) {
    archive(its.time, its.first, its.second, its.first_position, its.second_position,
            its.first_before, its.second_before, its.first_after, its.second_after);
}

inline void archive_parts(Archive&, Reflecting&) {}
inline void archive_parts(Archive& archive, Bath& its) { archive(its.temperature); }
inline void archive_parts(Archive& archive, Driven& its) { archive(its.velocity, its.until); }
inline void archive_parts(Archive& archive, Piston& its) {
    archive(its.mass, its.force, its.velocity);
}
inline void archive_parts(Archive& archive, Membrane::Speeds& its) {
    archive(its.faster_than, its.slower_than);
}
inline void archive_parts(Archive& archive, Membrane& its) {
    archive(its.species, its.upward, its.downward);
}

inline void archive_parts(Archive& archive, SurfaceState::Motion& its) {
    archive(its.place, its.velocity);
}
inline void archive_parts(Archive& archive, SurfaceState& its) {
    archive(its.hits, its.impulse, its.work, its.heat, its.behaviour, its.is_open, its.is_held,
            its.motion);
}

/// All but the collisions themselves.
inline void archive_parts(Archive& archive, AdvanceResult& its) {
    archive(its.counts.particle, its.counts.wall, its.counts.ties, its.impulses.wall,
            its.impulses.virial, its.impulses.largest_overlap, its.reversals, its.surfaces);
}

inline void archive_parts(Archive& archive, Particles& its) {
    archive(its.radius, its.inverse_mass, its.species);
}

inline void archive_parts(Archive& archive, Sample& its) {
    archive(its.time, its.position, its.velocity);
}

inline void archive_parts(Archive& archive, Tick& its) {
    archive(its.frame, its.time, its.phase, its.progress, its.slow.factor, its.slow.share,
            its.reversals, its.seconds);
}

}  // namespace carom
