// Which of the images of a point in a periodic box is the nearest: the only place where that is
// decided, but for the search for contacts, which asks for many at once (plane/contact_search.h).
#pragma once

#include <cmath>
#include <cstddef>

#include "physics/gas.h"

namespace carom {

/// How many lengths of the box lie between the nearest images of two points that are `separation`
/// apart along an axis; 0 where the box is not periodic.
inline double turns(const Box& box, std::size_t axis, double separation) {
    return box.walls[axis] == Wall::periodic
               ? std::round(separation / box.size[static_cast<Eigen::Index>(axis)])
               : 0.0;
}

/// The shortest vector between two points that are `separation` apart: across periodic sides where
/// the box has them.
inline Eigen::Array2d nearest_image(const Box& box, const Eigen::Array2d& separation) {
    return {separation[0] - box.size[0] * turns(box, 0, separation[0]),
            separation[1] - box.size[1] * turns(box, 1, separation[1])};
}

}  // namespace carom
