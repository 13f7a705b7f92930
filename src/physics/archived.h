// Serialization by Archive of the plain values of physics.
#pragma once

#include <variant>

#include "physics/advance_result.h"
#include "physics/box.h"
#include "physics/particles.h"
#include "physics/run.h"
#include "physics/surface.h"
#include "util/archive.h"

namespace carom {

// ------------------------------------------------------------------------------------- surfaces

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
inline void archive_parts(Archive&, Diffuse&) {}

inline void archive_parts(Archive& archive, Partition& its) {
    archive(its.name, its.axis, its.at, its.gaps, its.behaviour, its.is_open);
}
inline void archive_parts(Archive& archive, Obstacle::Disk& its) {
    archive(its.center, its.radius);
}
inline void archive_parts(Archive& archive, Obstacle::Lines& its) {
    archive(its.corners, its.is_closed);
}
inline void archive_parts(Archive& archive, Obstacle& its) {
    bool is_disk = std::holds_alternative<Obstacle::Disk>(its.shape);
    archive(its.name, is_disk);
    if (archive.is_reading() && is_disk) its.shape = Obstacle::Disk{{0.0, 0.0}, 0.0};
    if (archive.is_reading() && !is_disk) its.shape = Obstacle::Lines{};
    std::visit([&](auto& shape) { archive(shape); }, its.shape);
}
inline void archive_parts(Archive& archive, Surfaces& its) {
    archive(its.sides, its.side_count, its.partitions, its.obstacles, its.gravity, its.seed);
}

inline void archive_parts(Archive& archive, SurfaceTotals& its) {
    archive(its.hits, its.impulse, its.work, its.heat);
}
inline void archive_parts(Archive& archive, SurfaceState::Motion& its) {
    archive(its.place, its.velocity);
}
inline void archive_parts(Archive& archive, SurfaceState& its) {
    archive(static_cast<SurfaceTotals&>(its), its.behaviour, its.is_open, its.is_held, its.motion);
}

inline void archive_parts(Archive& archive, EnergyAccount& its) {
    archive(its.kinetic, its.potential, its.pistons, its.work, its.heat, its.relative_error);
}

// ------------------------------------------------------------------------------ box and particles

inline void archive_parts(Archive& archive, Box& its) {
    archive(its.dimension, its.size, its.walls, its.surfaces);
}

inline void archive_parts(Archive& archive, Particles& its) {
    archive(its.radius, its.inverse_mass, its.species);
}

inline void archive_parts(Archive& archive, Membership& its) {
    archive(its.species, its.is_present);
}

/// Without the membership, which the owner of the sample writes or reads.
inline void archive_parts(Archive& archive, Sample& its) {
    archive(its.time, its.position, its.velocity);
}

/// Whether a sample that was read has this number of particles and the dimension of the box.
inline bool is_of(const Sample& its, const Box& box, Eigen::Index particles) {
    return its.position.rows() == particles && its.position.cols() == box.dimension &&
           its.velocity.rows() == particles && its.velocity.cols() == box.dimension;
}

/// Whether the arrays of particles that were read have consistent sizes and valid species indices.
inline bool are_of(const Particles& its, std::size_t species) {
    return its.inverse_mass.size() == its.count() && its.species.size() == its.count() &&
           (its.species >= 0).all() && (its.species < static_cast<int>(species)).all();
}

// ------------------------------------------------------------------------------- events of a run

inline void archive_parts(Archive&, ReverseVelocities&) {}
inline void archive_parts(Archive& archive, Perturbation& its) { archive(its.particle, its.by); }
inline void archive_parts(Archive& archive, SetOpen& its) { archive(its.surface, its.is_open); }
inline void archive_parts(Archive& archive, MoveSurface& its) {
    archive(its.surface, its.velocity);
}
inline void archive_parts(Archive& archive, HoldPiston& its) { archive(its.surface); }
inline void archive_parts(Archive& archive, ReleasePiston& its) { archive(its.surface); }
inline void archive_parts(Archive& archive, ChangeSurface& its) {
    archive(its.surface, its.behaviour);
}
inline void archive_parts(Archive& archive, Temperature& its) { archive(its.value, its.is_exact); }
inline void archive_parts(Archive& archive, Heat& its) { archive(its.species, its.amount); }
inline void archive_parts(Archive& archive, RunEvent& its) {
    archive(its.at, its.action, its.is_mirrored);
}

// ---------------------------------------------------------------------------- what an advance
// gives

inline void archive_parts(Archive& archive, Collision& its) {
    archive(its.time, its.first, its.second, its.first_position, its.second_position,
            its.first_before, its.second_before, its.first_after, its.second_after);
}
inline void archive_parts(Archive& archive, CollisionCounts& its) {
    archive(its.particle, its.wall, its.ties.instants, its.ties.contacts, its.ties.first);
}
inline void archive_parts(Archive& archive, ImpulseTotals& its) {
    archive(its.wall, its.virial, its.largest_overlap);
}

/// All but the collisions themselves.
inline void archive_parts(Archive& archive, AdvanceResult& its) {
    archive(its.counts, its.impulses, its.reversals, its.surfaces);
}

}  // namespace carom
