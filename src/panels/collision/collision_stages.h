// One collision in three pictures: before, at contact, after. Where everything stands, as plain
// geometry, apart from how it is drawn.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>

#include "panels/collision/pair_collision.h"

namespace carom {

/// The collision with beads of a size, where they are points.
struct CollisionCause {
    std::array<Eigen::Array2d, 2> place, before, after;
    std::array<double, 2> radius, weight;  ///< weight: share of the mass
    Eigen::Array2d drift;                  ///< of the centre of mass
    double back, on;                       ///< time before and after the contact
};

CollisionCause cause_of(const PairCollision& met, const Particles& particles);

/// What stands in one stage, in lengths of the scene, from the centre of mass.
struct CollisionPose {
    std::array<Eigen::Array2d, 2> center;
    std::array<Eigen::Array2d, 2> arrow;  ///< velocities, or their changes
};

/// Before, at contact and after.
std::array<CollisionPose, 3> poses(const CollisionCause& cause);

inline double length_of(const Eigen::Array2d& v) { return std::sqrt(v.square().sum()); }

/// An arrow from `from` to `to`; none where they are one point.
struct StageArrow {
    Point from, to;
};

/// One of the pictures, in pixels; the centre of mass stands in its middle.
struct CollisionStage {
    Rect area;
    Point mass_center;
    std::array<Point, 2> center;  ///< of the disks
    std::array<StageArrow, 2>
        velocity;  ///< before or after; at contact the changes, from the centres
    StageArrow mass_center_velocity;
};

/// The three of them on one scale of lengths and one of velocities.
struct CollisionStages {
    std::array<CollisionStage, 3> stage;
    std::array<double, 2> radius;  ///< pixels
    double reach = 0.0;            ///< pixels of a unit of velocity
};

/// Whether numbers stand under a stage, and whether in two rows; in a low one the disks take their
/// place. `unit` as in DrawContext.
bool has_numbers(const Rect& stage, double unit);
bool has_rows_of_numbers(const Rect& stage, double unit);

/// The height of such a row, units.
inline constexpr double height_of_row = 1.25;

/// Of a collision in an area; side by side, or in a high area one above the other. On a wire
/// arrows stand in rows of their own, above the beads and below, which they would cover.
CollisionStages collision_stages(const PairCollision& pair, const Particles& particles,
                                 const Rect& area, double unit, int dimension);

}  // namespace carom
