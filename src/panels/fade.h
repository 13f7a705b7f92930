// Something that comes or goes: drawn as it is, and then seen through. On pixels only.
#pragma once

#include <cstdint>
#include <vector>

#include "draw/canvas.h"

namespace carom {

class Fade {
  public:
    /// Keeps the pixels of an area, cut at the canvas's edges.
    Fade(Canvas& canvas, const Rect& area);

    /// Leaves this share, from 0 to 1, of what has been drawn over them since.
    void leave(double share);

  private:
    Canvas& canvas_;
    int left_, top_, right_, bottom_;
    std::vector<std::uint32_t> before_;
};

}  // namespace carom
