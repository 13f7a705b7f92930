// The pixels of a picture, to compare it with another.
#pragma once

#include <cstdint>
#include <vector>

#include "draw/canvas.h"

namespace carom::test {

/// Row by row, without what pads the rows.
inline std::vector<std::uint32_t> pixels_of(const PixelView& view) {
    std::vector<std::uint32_t> pixels;
    for (int y = 0; y < view.height; ++y)
        pixels.insert(pixels.end(), view.data + y * view.stride,
                      view.data + y * view.stride + view.width);
    return pixels;
}

inline std::vector<std::uint32_t> pixels_of(const Canvas& canvas) {
    return pixels_of(canvas.pixels());
}

}  // namespace carom::test
