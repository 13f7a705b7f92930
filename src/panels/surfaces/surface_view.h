// The appearance of the surfaces of a box: sides that do more than reflect, partitions, obstacles
// and gravity, and the room that they need around the box. If sides move, the picture is laid out
// for the largest extent of the box. A surface with an imposed motion is hatched, a freely moving
// one is a plain bar, a heat bath has a wavy line, a membrane is dashed, a demon is dotted. A box
// in space is seen from the front: what is perpendicular to z is a frame, the smaller the further
// back it is. Draws no particles.
#pragma once

#include <array>
#include <vector>

#include "panels/panel.h"

namespace carom {

/// Maps positions of the scene (y up) to pixels (y down).
struct BoxMap {
    Rect frame;  ///< of the box at its largest extent
    Vec low = {};
    double scale = 1.0;  ///< pixels per unit length

    Point pixel(const Point& place) const {
        return {frame.x + (place.x - low[0]) * scale, frame.bottom() - (place.y - low[1]) * scale};
    }
    Rect rect(const Region& region) const;
};

/// How far the drawing of a side with this behaviour extends outward, without words and arrows, in
/// units.
double thickness_of_side(const Behaviour& behaviour);

class SurfaceView {
  public:
    explicit SurfaceView(const PanelContext& context);

    /// Whether there is nothing to draw but plain walls.
    bool is_plain() const { return plain_; }

    /// Whether no side moves.
    bool is_still() const { return still_; }

    /// First pass, every frame in order.
    void survey(const FrameInput& input);
    void archive(auto& archive) { archive(extent_.low, extent_.high); }

    /// The largest extent of the box; valid after the first pass.
    const Region& extent() const { return extent_; }

    /// The states of the sides and partitions that are drawn in a frame; empty for a plain box.
    std::vector<SurfaceState> states(const FrameInput& input) const;

    /// map_in() places the box in an area, as large as fits with what is drawn around it, at the
    /// area's left or in its middle; whole() is the rectangle of the box with all that is around
    /// it.
    BoxMap map_in(const Rect& area, double unit, bool centered) const;
    Rect whole(const BoxMap& map, double unit) const;

    /// The interior of the box at a moment.
    Region room(const std::vector<SurfaceState>& states) const;

    /// draw_room() fills the interior and draws the outline of the box and what is in it; not for a
    /// plain box. In space it draws nothing that stands in depth, and draw_partitions() those that
    /// are seen as lines.
    void draw_room(Canvas& canvas, const DrawContext& dc, const BoxMap& map,
                   const std::vector<SurfaceState>& states) const;
    void draw_obstacles(Canvas& canvas, const DrawContext& dc, const BoxMap& map,
                        const std::vector<SurfaceState>& states) const;
    void draw_partitions(Canvas& canvas, const DrawContext& dc, const BoxMap& map,
                         const std::vector<SurfaceState>& states) const;
    /// In space: what stands at a depth, by its number among the surfaces and its place along z:
    /// partitions across z, back and front walls that act, and obstacles. From back to front; of a
    /// particle and any of these, the one further in front hides the other.
    struct InDepth {
        double depth;
        std::size_t surface;
    };
    std::vector<InDepth> in_depth(const std::vector<SurfaceState>& states) const;
    void draw_in_depth(Canvas& canvas, const DrawContext& dc, const BoxMap& map,
                       const std::vector<SurfaceState>& states, std::size_t surface) const;

    /// Draws what is outside of the interior, and the labels of surfaces.
    void draw_around(Canvas& canvas, const DrawContext& dc, const BoxMap& map,
                     const std::vector<SurfaceState>& states) const;

    /// The colour of a heat bath, on a scale from the coldest to the hottest of the scene.
    Color bath_color(double temperature, const Theme& theme) const;

  private:
    struct Brush;
    struct Margins {  ///< units
        double left = 0.0, right = 0.0, bottom = 0.0, top = 0.0;
    };
    Margins margins_of() const;
    bool is_deep() const;
    bool may_move(std::size_t k) const;
    double thickness_of(std::size_t side) const;

    const Gas& gas_;  ///< of the scene
    Language language_;
    bool plain_, still_ = true;
    std::vector<std::vector<Behaviour>> behaviours_;  ///< of each side and partition, at all times
    std::array<double, 2> temperatures_{};            ///< lowest and highest of baths
    Margins margins_{};
    Region extent_{};  ///< of the box at its largest extent
};

}  // namespace carom
