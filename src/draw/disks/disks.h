// Many disks. On a raster, fast: cached coverage masks at 16 x 16 sub-pixel phases, blended into
// the canvas's own pixels. In a vector document: circles.
#pragma once

#include <memory>
#include <span>

#include "draw/canvas.h"
#include "draw/disks/disk.h"

namespace carom {

class SmallDisks;

class DiskPainter {
  public:
    DiskPainter();
    ~DiskPainter();
    DiskPainter(DiskPainter&&) noexcept;
    DiskPainter& operator=(DiskPainter&&) noexcept;

    /// Draws in order, later disks over earlier ones; clipped to `clip`. On a raster centres are
    /// right to 1/32 pixel, coverage to 1/255 or so.
    void draw(Canvas& canvas, std::span<const Disk> disks, Rect clip);

    /// For disks that are too many and too small to be drawn one by one.
    SmallDisks& small_disks();

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace carom
