// Positions and velocities of the event loop as records hold them: in doubles.
#pragma once

#include <array>
#include <cstddef>

#include "physics/vec.h"

namespace carom {

template <typename Scalar, std::size_t Dimension>
Vec as_vec(const std::array<Scalar, Dimension>& x) {
    Vec vec;
    for (std::size_t axis = 0; axis < Dimension; ++axis) vec[axis] = static_cast<double>(x[axis]);
    return vec;
}

template <typename Scalar, std::size_t Dimension>
std::array<double, Dimension> in_doubles(const std::array<Scalar, Dimension>& x) {
    std::array<double, Dimension> values;
    for (std::size_t a = 0; a < Dimension; ++a) values[a] = static_cast<double>(x[a]);
    return values;
}

}  // namespace carom
