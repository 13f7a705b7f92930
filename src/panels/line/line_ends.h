// The ends of a wire whose walls do more than reflect: their range of motion and their drawing.
// Places are those of the scene, not those of the picture.
#pragma once

#include <array>
#include <deque>
#include <utility>
#include <vector>

#include "panels/panel.h"
#include "panels/surfaces/surface_view.h"

namespace carom {

class LineEnds {
  public:
    explicit LineEnds(const PanelContext& context);

    /// Whether the ends only reflect, and no force acts on the beads.
    bool is_plain() const { return look_.is_plain(); }

    /// First pass, every frame in order.
    void survey(const FrameInput& input);
    void archive(auto& archive) { archive(extent_); }

    /// The largest extent of the wire to the left of 0, and beyond its length.
    double before() const { return -extent_.first; }
    double beyond() const { return extent_.second - length_; }

    /// The wire with its largest extent in the film.
    Region extent() const { return {{extent_.first, 0.0}, {extent_.second, 0.0}}; }

    /// An end at a frame.
    struct End {
        SurfaceState state;
        double place = 0.0;
        std::vector<Point> path = {};  ///< past times and places within `memory`, if the end moves
    };

    /// Second pass, every frame in order: returns the ends; empty if they are plain. `memory`: the
    /// simulated time that a path goes back.
    std::vector<End> see(const FrameInput& input, double memory);

    void archive_progress(auto& archive) { archive(paths_); }

    /// Draws an end at `x` (pixels), across the wire at the height `y`.
    void draw(Canvas& canvas, const DrawContext& dc, const End& end, std::size_t side, double x,
              double y) const;

    /// Draws the arrow of gravity in a line of text above the wire.
    void draw_gravity(Canvas& canvas, const DrawContext& dc, const Rect& line) const;

  private:
    bool has_words(std::size_t side) const;

    const Gas& gas_;  ///< of the scene
    const Run& run_;
    Language language_;
    SurfaceView look_;
    double length_;
    std::pair<double, double> extent_;
    std::array<std::deque<Point>, 2> paths_;
};

}  // namespace carom
