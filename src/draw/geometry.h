// Points, rectangles and sizes on a canvas: pixels or points, x to the right, y down.
#pragma once

namespace carom {

struct Point {
    double x = 0, y = 0;
};

struct Rect {
    double x = 0, y = 0, width = 0, height = 0;
    double right() const { return x + width; }
    double bottom() const { return y + height; }
};

struct PixelSize {
    int width = 0, height = 0;
};

}  // namespace carom
