// The images of a particle in a periodic box that may touch another one.
#pragma once

#include <array>
#include <cstddef>

namespace carom {

/// Calls see(which) for each combination of these images: which[axis] is 0 for the image that is
/// nearest along an axis, or, where the box is `narrow`, 1 for the second nearest.
template <std::size_t Axes, typename See>
void for_each_image(const std::array<bool, Axes>& narrow, const See& see) {
    for (unsigned bits = 0; bits < 1U << Axes; ++bits) {
        std::array<std::size_t, Axes> which;
        bool exists = true;
        for (std::size_t axis = 0; axis < Axes; ++axis) {
            which[axis] = bits >> (Axes - 1 - axis) & 1U;
            exists = exists && (which[axis] == 0 || narrow[axis]);
        }
        if (exists) see(which);
    }
}

}  // namespace carom
