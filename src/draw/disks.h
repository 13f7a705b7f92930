// Many disks. On a raster, fast: cached coverage masks at 16 x 16 sub-pixel phases, blended into
// the canvas's own pixels. In a vector document: circles.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "draw/canvas.h"

namespace carom {

struct Disk {
    float x = 0, y = 0, radius = 0;  ///< pixels
    std::uint32_t color = 0;         ///< 0xRRGGBB, opaque
};

class DiskPainter {
  public:
    DiskPainter();
    ~DiskPainter();
    DiskPainter(DiskPainter&&) noexcept;
    DiskPainter& operator=(DiskPainter&&) noexcept;

    /// Draws in order, later disks over earlier ones; clipped to `clip`. On a raster centres are
    /// right to 1/32 pixel, coverage to 1/255 or so.
    void draw(Canvas& canvas, std::span<const Disk> disks, Rect clip);

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace carom
