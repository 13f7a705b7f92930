// One collision in three pictures: before, at contact, after. Where everything stands, as plain
// geometry, apart from how it is drawn.
#pragma once

#include <array>

#include "panels/collision/pair_collision.h"

namespace carom {

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

/// Of a collision in an area; side by side, or in a high area one above the other. On a wire
/// arrows stand in rows of their own, above the beads and below, which they would cover.
CollisionStages collision_stages(const PairCollision& pair, const Particles& particles,
                                 const Rect& area, double unit, int dimension);

}  // namespace carom
