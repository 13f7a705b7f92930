// Serialization by Archive of the plain values of physics.
#pragma once

#include "physics/advance_result.h"
#include "physics/box.h"
#include "physics/particles.h"
#include "physics/run.h"
#include "physics/surface.h"
#include "util/archive.h"

namespace carom {

// ------------------------------------------------------------------------------------- surfaces

inline void archive_parts(Archive&, Reflecting&) {}
inline void archive_parts(Archive& archive, Bath& bath) { archive(bath.temperature); }
inline void archive_parts(Archive& archive, Driven& driven) {
    archive(driven.velocity, driven.until);
}
inline void archive_parts(Archive& archive, Piston& piston) {
    archive(piston.mass, piston.force, piston.velocity);
}
inline void archive_parts(Archive& archive, Membrane::Speeds& speeds) {
    archive(speeds.faster_than, speeds.slower_than);
}
inline void archive_parts(Archive& archive, Membrane& membrane) {
    archive(membrane.species, membrane.upward, membrane.downward);
}
inline void archive_parts(Archive&, Diffuse&) {}

inline void archive_parts(Archive& archive, Partition& partition) {
    archive(partition.name, partition.axis, partition.at, partition.gaps, partition.behaviour,
            partition.is_open);
}
inline void archive_parts(Archive& archive, Obstacle::Ball& ball) {
    archive(ball.center, ball.radius);
}
inline void archive_parts(Archive& archive, Obstacle::Cuboid& cuboid) {
    archive(cuboid.low, cuboid.high);
}
inline void archive_parts(Archive& archive, Obstacle::Lines& lines) {
    archive(lines.corners, lines.is_closed);
}
inline void archive_parts(Archive& archive, Obstacle& obstacle) {
    archive(obstacle.name, obstacle.shape);
}
inline void archive_parts(Archive& archive, Surfaces& surfaces) {
    archive(surfaces.sides, surfaces.side_count, surfaces.partitions, surfaces.obstacles,
            surfaces.gravity, surfaces.seed);
}

inline void archive_parts(Archive& archive, SurfaceTotals& totals) {
    archive(totals.hits, totals.impulse, totals.work, totals.heat);
}
inline void archive_parts(Archive& archive, SurfaceState::Motion& motion) {
    archive(motion.place, motion.velocity);
}
inline void archive_parts(Archive& archive, SurfaceState& state) {
    archive(static_cast<SurfaceTotals&>(state), state.behaviour, state.is_open, state.is_held,
            state.motion);
}

inline void archive_parts(Archive& archive, EnergyAccount& account) {
    archive(account.kinetic, account.potential, account.pistons, account.work, account.heat,
            account.relative_error);
}

// ------------------------------------------------------------------------------ box and particles

inline void archive_parts(Archive& archive, Box& box) {
    archive(box.dimension, box.size, box.walls, box.surfaces);
}

inline void archive_parts(Archive& archive, Particles& particles) {
    archive(particles.radius, particles.inverse_mass, particles.species);
}

inline void archive_parts(Archive& archive, Membership& membership) {
    archive(membership.species, membership.is_present);
}

/// Without the membership, which the owner of the sample writes or reads.
inline void archive_parts(Archive& archive, Sample& sample) {
    archive(sample.time, sample.position, sample.velocity);
}

/// Whether a sample that was read has this number of particles and the dimension of the box.
inline bool is_of(const Sample& sample, const Box& box, Eigen::Index particles) {
    return sample.position.rows() == particles && sample.position.cols() == box.dimension &&
           sample.velocity.rows() == particles && sample.velocity.cols() == box.dimension;
}

/// Whether the arrays of particles that were read have consistent sizes and valid species indices.
inline bool are_of(const Particles& particles, std::size_t species) {
    return particles.inverse_mass.size() == particles.count() &&
           particles.species.size() == particles.count() && (particles.species >= 0).all() &&
           (particles.species < static_cast<int>(species)).all();
}

// ------------------------------------------------------------------------------- events of a run

inline void archive_parts(Archive&, ReverseVelocities&) {}
inline void archive_parts(Archive& archive, Perturbation& perturbation) {
    archive(perturbation.particle, perturbation.by);
}
inline void archive_parts(Archive& archive, SetOpen& action) {
    archive(action.surface, action.is_open);
}
inline void archive_parts(Archive& archive, MoveSurface& action) {
    archive(action.surface, action.velocity);
}
inline void archive_parts(Archive& archive, HoldPiston& action) { archive(action.surface); }
inline void archive_parts(Archive& archive, ReleasePiston& action) { archive(action.surface); }
inline void archive_parts(Archive& archive, ChangeSurface& action) {
    archive(action.surface, action.behaviour);
}
inline void archive_parts(Archive& archive, Temperature& temperature) {
    archive(temperature.value, temperature.is_exact);
}
inline void archive_parts(Archive& archive, Heat& heat) { archive(heat.species, heat.amount); }
inline void archive_parts(Archive& archive, RunEvent& event) {
    archive(event.at, event.action, event.is_mirrored);
}

// ---------------------------------------------------------------------------- what an advance
// gives

inline void archive_parts(Archive& archive, Collision& collision) {
    archive(collision.time, collision.first, collision.second, collision.first_position,
            collision.second_position, collision.first_before, collision.second_before,
            collision.first_after, collision.second_after);
}
inline void archive_parts(Archive& archive, CollisionCounts& counts) {
    archive(counts.particle, counts.wall, counts.ties.instants, counts.ties.contacts,
            counts.ties.first);
}
inline void archive_parts(Archive& archive, ImpulseTotals& totals) {
    archive(totals.wall, totals.virial, totals.largest_overlap);
}

/// All but the collisions themselves.
inline void archive_parts(Archive& archive, AdvanceResult& result) {
    archive(result.counts, result.impulses, result.reversals, result.surfaces);
}

}  // namespace carom
