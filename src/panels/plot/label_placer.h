// Checks places for words in a plot, which are put at the first place where they overlap nothing.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "draw/geometry.h"

namespace carom::plot {

class LabelPlacer {
  public:
    /// Words stay inside of `area`.
    explicit LabelPlacer(const Rect& area) : area_(area) {}

    /// Add what words must not overlap: a straight segment of a line, and other words.
    void keep_clear(Point from, Point to) { segments_.emplace_back(from, to); }
    void keep_clear(const Rect& words) { words_.push_back(words); }

    bool is_inside(const Rect& words) const;
    bool is_free(const Rect& words) const;

  private:
    Rect area_;
    std::vector<std::pair<Point, Point>> segments_;
    std::vector<Rect> words_;
};

/// Whether a straight segment crosses a rectangle.
bool meets(const Rect& part, const Point& from, const Point& to);

}  // namespace carom::plot
