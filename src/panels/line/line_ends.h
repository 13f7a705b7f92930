// The ends of a wire whose walls act: how far they come, and what is drawn there. Places are those
// of the scene, not as drawn.
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

    /// Whether they only reflect, and nothing pulls at the beads.
    bool is_plain() const { return look_.is_plain(); }

    /// First pass, every frame in order.
    void survey(const FrameInput& input);
    void archive(auto& archive) { archive(extent_); }

    /// How far the wire reaches, at most, left of 0 and beyond its length.
    double before() const { return -extent_.first; }
    double beyond() const { return extent_.second - length_; }

    /// The wire, as far as it ever reaches.
    Region extent() const { return {{extent_.first, 0.0}, {extent_.second, 0.0}}; }

    /// An end at a frame.
    struct End {
        SurfaceState state;
        double place = 0.0;
        std::vector<Point> path = {};  ///< times and places so far, in memory; of one that moves
    };

    /// Second pass, every frame in order; none of plain ones.
    std::vector<End> see(const FrameInput& input, double memory);

    void archive_progress(auto& archive) { archive(paths_); }

    /// Draws one at `x` (pixels), across the wire at the height `y`.
    void draw(Canvas& canvas, const DrawContext& dc, const End& end, std::size_t side, double x,
              double y) const;

    /// An arrow in a line of words above the wire.
    void draw_gravity(Canvas& canvas, const DrawContext& dc, const Rect& line) const;

  private:
    bool has_words(std::size_t side) const;

    const Scene& scene_;
    SurfaceView look_;
    double length_;
    std::pair<double, double> extent_;
    std::array<std::deque<Point>, 2> paths_;
};

}  // namespace carom
