// The 255 colours of a GIF: chosen from frames of the whole film, and looked up for each pixel.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "draw/canvas.h"

namespace carom {

/// Opaque colours 0xffRRGGBB, followed by a transparent one as the last entry.
using GifPalette = std::array<std::uint32_t, 256>;
constexpr int gif_colors = 255;

/// Chooses colours from frames of one size by libavfilter's palettegen. Throws SystemError.
class PaletteMaker {
  public:
    PaletteMaker(int width, int height);
    ~PaletteMaker();

    void add(const PixelView& frame);
    GifPalette finish();  ///< requires at least one frame; the object cannot be used afterwards

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

/// Maps each colour to the nearest one of a palette, by the distance in sRGB; the first one if
/// several are equally near. No dithering: pictures are flat, and noise on a flat ground would
/// crawl.
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
    std::vector<Known> known_;  ///< a hash table with the last colour met in each slot
};

}  // namespace carom
