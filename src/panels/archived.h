// How an Archive writes and reads plain values of the modules below.
#pragma once

#include "draw/geometry.h"
#include "physics/advance_result.h"
#include "physics/particles.h"
#include "scene/time/timeline.h"
#include "util/archive.h"

namespace carom {

inline void archive_parts(Archive& archive, Point& point) { archive(point.x, point.y); }

inline void archive_parts(Archive& archive, Collision& its) {
    archive(its.time, its.first, its.second, its.first_position, its.second_position,
            its.first_before, its.second_before, its.first_after, its.second_after);
}

/// All but the collisions themselves.
inline void archive_parts(Archive& archive, AdvanceResult& its) {
    archive(its.counts.particle, its.counts.wall, its.counts.ties, its.impulses.wall,
            its.impulses.virial, its.impulses.largest_overlap, its.reversals);
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
