// The pixels of a picture as a vector, for comparison with another picture.
#pragma once

#include <cstdint>
#include <vector>

#include "draw/canvas.h"

namespace carom::test {

/// The pixels row by row, without the padding at the end of the rows.
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
