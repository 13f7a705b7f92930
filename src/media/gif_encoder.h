// The pictures of a GIF: frames of one segment, each as the part of it that differs from the one
// before, compressed by libav. Knows no file and no times.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "media/gif_palette.h"

namespace carom {

/// A graphic control extension and an image of GIF89a, without colours of its own.
using GifImage = std::vector<std::uint8_t>;

/// Bytes of an image at which its delay stands, little-endian, in hundredths of a second.
constexpr std::size_t gif_delay_at = 4;

/// Encodes the frames of one segment, in order, on the calling thread alone. The first covers the
/// whole picture.
class GifEncoder {
  public:
    /// Throws SystemError naming codec and cause.
    GifEncoder(int width, int height, const GifPalette& palette);
    ~GifEncoder();

    GifImage add(const PixelView& frame);

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace carom
