// Knows what is drawn in a plot, so that words are put where they touch nothing.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "draw/geometry.h"

namespace carom::plot {

class LabelPlacer {
  public:
    /// Words stay inside of `area`.
    explicit LabelPlacer(const Rect& area) : area_(area) {}

    /// Add what words must not touch: a straight piece of a line, as wide as it is drawn, and
    /// bars, bands or other words.
    void keep_clear(Point from, Point to, double width = 0.0);
    void keep_clear(const Rect& part) { parts_.push_back(part); }

    /// The growing line (a layer) to which the pieces belong that are added from now on; none: to
    /// no such line. To its name no other one may be as near, unless it is `close` (pixels) to it.
    void set_line(std::optional<std::size_t> line) { line_ = line; }
    bool is_nearest_line(std::size_t line, const Rect& words, double close) const;

    /// Adds a vertical line that may be drawn with gaps for words.
    void keep_off_marker(double x, double top, double bottom, double width);

    /// Adds the height of a level, to whose words no other level is as near.
    void add_level(double y) { levels_.push_back(y); }
    bool is_nearest_level(double y, const Rect& words) const;

    /// Adds words that have their place; markers have gaps there.
    void place(const Rect& words);
    const std::vector<Rect>& placed() const { return placed_; }

    bool is_inside(const Rect& words) const;

    /// Whether words touch nothing; with `over_markers`, nothing but markers, whose lines go on
    /// above and below them.
    bool is_free(const Rect& words, bool over_markers = false) const;

  private:
    struct Segment {
        Point from, to;
        double width;
        std::optional<std::size_t> line = {};
    };
    static bool crosses(const Segment& segment, const Rect& words);
    Rect area_;
    std::vector<Segment> segments_, markers_;
    std::vector<double> levels_;
    std::optional<std::size_t> line_;
    std::vector<Rect> parts_, placed_;
};

/// Whether a straight segment crosses a rectangle.
bool meets(const Rect& part, const Point& from, const Point& to);

/// Whether two rectangles share more than an edge.
bool overlap(const Rect& one, const Rect& other);

}  // namespace carom::plot
