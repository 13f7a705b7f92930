// Fades a part of a picture in or out: it is drawn opaque, then blended with what was there before.
// On raster canvases only.
#pragma once

#include <cstdint>
#include <vector>

#include "draw/canvas.h"

namespace carom {

class Fade {
  public:
    /// Saves the pixels of an area, clipped to the canvas.
    Fade(Canvas& canvas, const Rect& area);

    /// Blends what has been drawn over the area since then with the saved pixels; `share`, from 0
    /// to 1, is the opacity that remains.
    void leave(double share);

  private:
    Canvas& canvas_;
    int left_, top_, right_, bottom_;
    std::vector<std::uint32_t> before_;
};

}  // namespace carom
