// The letters of the axes of a box. Pure values, safe on any thread.
#pragma once

#include <concepts>

namespace carom {

/// "x", "y" or "z": of the axes 0, 1 and 2.
constexpr const char* axis_letter(std::integral auto axis) {
    return axis == 0 ? "x" : axis == 1 ? "y" : "z";
}

}  // namespace carom
