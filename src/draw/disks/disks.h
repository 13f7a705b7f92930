// Draws many disks, of one colour or lit like spheres. On a raster by a fast method: cached
// coverage masks at 16 x 16 sub-pixel phases are blended directly into the pixels of the canvas. In
// a vector document as circles.
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

    /// Draws the disks in order, later ones over earlier ones, clipped to `clip`. On a raster
    /// centres are accurate to 1/32 pixel, coverages to about 1/255.
    void draw(Canvas& canvas, std::span<const Disk> disks, Rect clip);

    /// Draws spheres that are lit from the upper left: disks with a highlight, and darker toward
    /// the lower right. As above, but on a raster centres are accurate to 1/16 pixel, and radii to
    /// 1/32 pixel or 1/512 of themselves: spheres of all sizes, as perspective has them, would
    /// otherwise need more masks than can be kept.
    void draw_lit(Canvas& canvas, std::span<const Disk> disks, Rect clip);

    /// The painter for disks that are too many and too small to be drawn one by one.
    SmallDisks& small_disks();

  private:
    template <class Draw>
    void draw_each(Canvas& canvas, std::span<const Disk> disks, Rect clip, const Draw& draw);

    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace carom
