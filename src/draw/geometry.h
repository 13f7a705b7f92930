// Points, rectangles and sizes on a canvas: pixels or points, x to the right, y down.
#pragma once

#include <cmath>

namespace carom {

struct Point {
    double x = 0, y = 0;
};

/// Whether two points lie farther apart than this, across or up.
inline bool is_apart(const Point& a, const Point& b, double distance) {
    return std::abs(a.x - b.x) > distance || std::abs(a.y - b.y) > distance;
}

struct Rect {
    double x = 0, y = 0, width = 0, height = 0;
    double right() const { return x + width; }
    double bottom() const { return y + height; }
};

struct PixelSize {
    int width = 0, height = 0;
};

/// Columns and rows of pixels: [left, right) and [top, bottom).
struct PixelBounds {
    int left = 0, top = 0, right = 0, bottom = 0;
};

}  // namespace carom
