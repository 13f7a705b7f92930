// Boxes with three lengths, what stands in them, and disks of a plane in them.
#pragma once

#include <Eigen/Core>

#include "physics/box.h"
#include "physics/particles.h"

namespace carom::test {

inline Box space_of(const Vec& size, const Walls& walls = {}) {
    Box box{3, size, walls};
    box.surfaces.side_count = 6;
    return box;
}

/// A cube whose walls are all alike.
inline Box cube_of(double side, Wall wall = Wall::solid) {
    return space_of({side, side, side}, {wall, wall, wall});
}

/// A box in so many dimensions, with the first of these lengths and with walls.
inline Box box_of(int dimension, const Vec& size) {
    return dimension == 3 ? space_of(size) : Box{dimension, {size[0], size[1]}, {}};
}

/// A partition with one gap.
inline Partition window(int axis, double at, const Gap& gap) {
    return {.name = "window", .axis = axis, .at = at, .gaps = {gap}};
}

/// The sample of disks, as spheres half way between the back and the front of a box.
inline Sample in_space(const Sample& plane, double depth) {
    const Eigen::Index count = plane.position.rows();
    Sample sample{plane.time, Eigen::ArrayXXd::Constant(count, 3, 0.5 * depth),
                  Eigen::ArrayXXd::Zero(count, 3)};
    sample.position.leftCols(2) = plane.position;
    sample.velocity.leftCols(2) = plane.velocity;
    return sample;
}

}  // namespace carom::test
