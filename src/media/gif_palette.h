// The 255 colours of a GIF: chosen from frames of the whole film, and found again for each pixel.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "draw/canvas.h"

namespace carom {

/// Opaque colours 0xffRRGGBB, and as the last one a transparent.
using GifPalette = std::array<std::uint32_t, 256>;
constexpr int gif_colors = 255;

/// Chooses colours from frames of one size by libavfilter's palettegen. Throws SystemError.
class PaletteMaker {
  public:
    PaletteMaker(int width, int height);
    ~PaletteMaker();

    void add(const PixelView& frame);
    GifPalette finish();  ///< spent afterwards; at least one frame must have been added

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

/// Gives each colour the nearest one of a palette, by the distance in sRGB; the first of equals. No
/// dithering: pictures are flat, and noise on flat ground would crawl.
class ColorFinder {
  public:
    explicit ColorFinder(const GifPalette& palette);

    void find(const std::uint32_t* pixels, std::uint8_t* indices, int count);

  private:
    std::uint8_t nearest(std::uint32_t color) const;

    struct Known {
        std::uint32_t color;
        std::uint8_t index;
    };
    GifPalette palette_;
    std::vector<Known> known_;  ///< the last color met in each place of a hash table
};

}  // namespace carom
