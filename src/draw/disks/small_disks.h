// Very many disks of about a pixel or less on a raster: each pixel has the colour of its ground and
// the mean colour of the disks in it, by the shares of its area that they cover. Where disks do not
// overlap this is what drawing them one by one at many times the resolution gives, for a small part
// of the time. Sums in a fixed order, without functions that differ from machine to machine: the
// same everywhere.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "draw/canvas.h"
#include "draw/disks/disk.h"
#include "draw/raster/pixel_bounds.h"

namespace carom {

class SmallDisks {
  public:
    static constexpr float largest_radius = 1.5F;  ///< pixels; larger disks are not drawn

    /// Begins a picture of disks on the pixels that a clip leaves of a canvas of this size.
    void begin(PixelSize size, const Rect& clip);

    /// Adds a disk, which is kept until it is drawn. Areas are exact, edges right to 1/64 pixel.
    /// What is not finite, has no size or lies outside is left out.
    void add(const Disk& disk) {
        if (disk.radius > 0.0F && disk.radius <= largest_radius && disk.x > left_ &&
            disk.x < right_ && disk.y > top_ && disk.y < bottom_)
            bands_[static_cast<std::size_t>(static_cast<int>(disk.y - top_) / band_rows)].push_back(
                disk);
    }

    /// Draws what was added over what the canvas, a raster of that size, shows. Where disks that
    /// overlap cover more than a pixel they are mixed by their shares.
    void draw(Canvas& canvas);

  private:
    using Ink = float __attribute__((vector_size(16)));  // blue, green, red, alpha, up to 255

    static constexpr int phases = 64;        // of a centre within a pixel, each way
    static constexpr int radius_steps = 64;  // in a pixel, of the radius of a shape
    static constexpr int reach = 2;          // of a disk, in pixels from that of its centre
    static constexpr int margin = 4;         // pixels around the picture, for what is cut
    static constexpr int band_rows = 16;

    // The shares of a disk's area in the pixels around it, `width` each way, for all phases.
    struct Shape {
        int width = 0;
        std::array<int, phases> first{};  // pixel, from that of the centre
        std::vector<float> shares;
    };

    static Shape make_shape(int radius);
    const Shape& shape_of(float radius);
    void add_up(const std::vector<Disk>& disks, int first_row);
    void mix(const PixelView& pixels, int first_row) const;
    void go_on();

    PixelBounds bounds_;
    Rect clip_{};
    float left_ = 0, top_ = 0, right_ = 0, bottom_ = 0;  // of centres whose disks may be seen
    // By rows of the picture, so that the sums stay in the processor's cache: in the order of
    // millions of disks nearly each one would wait for memory.
    std::vector<std::vector<Disk>> bands_;
    int stride_ = 0;
    std::vector<Ink> sums_;  // of inks by covered area, of a band and the rows beside it
    std::array<Shape, static_cast<std::size_t>(largest_radius* radius_steps) + 1> shapes_;
};

}  // namespace carom
