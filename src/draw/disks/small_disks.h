// Draws very many disks of about a pixel or less on a raster: each pixel is a mixture of the ground
// and the mean colour of the disks in it, weighted by the parts of its area that they cover. Where
// disks do not overlap this equals drawing them one by one at many times the resolution, in a small
// part of the time. Sums are taken in a fixed order, without functions that differ from machine to
// machine: the same result everywhere.
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

    /// Begins a picture of disks on the pixels inside `clip` of a canvas of this size.
    void begin(PixelSize size, const Rect& clip);

    /// Adds a disk, which is stored until it is drawn. Areas are exact, edges accurate to 1/64
    /// pixel. Disks that are not finite, have no size, are too large or lie outside are ignored.
    void add(const Disk& disk) {
        if (disk.radius > 0.0F && disk.radius <= largest_radius && disk.x > left_ &&
            disk.x < right_ && disk.y > top_ && disk.y < bottom_)
            bands_[static_cast<std::size_t>(static_cast<int>(disk.y - top_) / band_rows)].push_back(
                disk);
    }

    /// Draws the added disks over the content of the canvas, which must be a raster of the given
    /// size. Where overlapping disks cover more than a pixel their colours are mixed by their
    /// shares.
    void draw(Canvas& canvas);

  private:
    using Ink = float __attribute__((vector_size(16)));  // blue, green, red, alpha, up to 255

    static constexpr int phases = 64;  // positions of a centre within a pixel, along each axis
    static constexpr int radius_steps = 64;  // in a pixel, of the radius of a shape
    static constexpr int reach = 2;          // of a disk, in pixels from the pixel of its centre
    static constexpr int margin = 4;         // pixels around the picture, for disks that it cuts
    static constexpr int band_rows = 16;

    // The shares of a disk's area that fall on the pixels around it, `width` along each axis, for
    // all phases.
    struct Shape {
        int width = 0;
        std::array<int, phases> first{};  // first pixel, relative to that of the centre
        std::vector<float> shares;
    };

    static Shape make_shape(int radius);
    const Shape& shape_of(float radius);
    void add_up(const std::vector<Disk>& disks, int first_row);
    void mix(const PixelView& pixels, int first_row) const;
    void go_on();

    PixelBounds bounds_;
    Rect clip_{};
    float left_ = 0, top_ = 0, right_ = 0, bottom_ = 0;  // of centres of visible disks
    // Disks sorted into bands of rows, so that the sums stay in the processor's cache: in the
    // original order of millions of disks nearly each one would wait for memory.
    std::vector<std::vector<Disk>> bands_;
    int stride_ = 0;
    std::vector<Ink> sums_;  // of area times ink, for a band and the adjacent rows
    std::array<Shape, static_cast<std::size_t>(largest_radius* radius_steps) + 1> shapes_;
};

}  // namespace carom
