// Helpers for painters that write pixels directly: which pixels they may write, and which they have
// written.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "draw/canvas.h"

namespace carom {

/// The pixels of a canvas inside a clip.
inline PixelBounds bounds_of(PixelSize size, const Rect& clip) {
    const auto within = [](double position, int most) {
        return static_cast<int>(std::clamp(std::round(position), 0.0, static_cast<double>(most)));
    };
    return {within(clip.x, size.width), within(clip.y, size.height),
            within(clip.right(), size.width), within(clip.bottom(), size.height)};
}

/// Collects the boxes that were drawn in; reports the whole clip instead if they cover a large part
/// of it.
class DrawnBoxes {
  public:
    explicit DrawnBoxes(const Rect& clip) : clip_(clip), left_(0.4 * clip.width * clip.height) {}

    void add(const Rect& box) {
        if (left_ < 0.0) return;
        boxes_.push_back(box);
        left_ -= box.width * box.height;
    }

    void touch(Canvas& canvas) const {
        if (left_ < 0.0) return canvas.touch(clip_);
        for (const Rect& box : boxes_) canvas.touch(box);
    }

  private:
    Rect clip_;
    double left_;  ///< pixels
    std::vector<Rect> boxes_;
};

}  // namespace carom
