// One collision in three pictures: before, at and after the contact. Computes the layout as plain
// geometry, independent of how it is drawn.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>

#include "panels/collision/pair_collision.h"

namespace carom {

/// The collision from which the stages are computed; point particles are given a radius.
struct CollisionCause {
    std::array<Vec, 2> place, before, after;
    std::array<double, 2> radius, weight;  ///< weight: share of the mass
    Vec drift;                             ///< of the centre of mass
    double back, on;  ///< times from the first stage to contact, and on to the last
};

CollisionCause cause_of(const PairCollision& met, const Particles& particles);

/// The content of one stage in units of the scene; positions are relative to the centre of mass.
struct CollisionPose {
    std::array<Vec, 2> center;
    std::array<Vec, 2> arrow;  ///< velocities, or their changes
};

/// Before, at contact and after.
std::array<CollisionPose, 3> poses(const CollisionCause& cause);

/// An arrow from `from` to `to`; no arrow if the two points coincide.
struct StageArrow {
    Point from, to;
};

/// One of the pictures, in pixels; the centre of mass is in its middle.
struct CollisionStage {
    Rect area;
    Point mass_center;
    std::array<Point, 2> center;  ///< of the disks
    std::array<StageArrow, 2>
        velocity;  ///< before or after; at contact the changes, from the centres
    StageArrow mass_center_velocity;
};

/// The three pictures, with common scales of length and of velocity.
struct CollisionStages {
    std::array<CollisionStage, 3> stage;
    std::array<double, 2> radius;  ///< pixels
    double reach = 0.0;            ///< pixels per unit of velocity
};

/// Whether numbers are written under a stage, and whether they take two rows. A stage that is too
/// low has no numbers; its disks take their place. `unit` as in DrawContext.
bool has_numbers(const Rect& stage, double unit);
bool has_rows_of_numbers(const Rect& stage, double unit);

/// The height of a row of numbers, in units.
inline constexpr double height_of_row = 1.25;

/// Lays out the three pictures of a collision in an area: side by side or one above the other,
/// whichever gives the larger scale. On a wire the arrows have rows of their own above and below
/// the beads, which they would cover otherwise.
CollisionStages collision_stages(const PairCollision& pair, const Particles& particles,
                                 const Rect& area, double unit, int dimension);

}  // namespace carom
