// The appearance of the surfaces of a box: sides that do more than reflect, partitions, obstacles
// and gravity, and the room that they need around the box. If sides move, the picture is laid out
// for the largest extent of the box. A surface with an imposed motion is hatched, a freely moving
// one is a plain bar, a heat bath has a wavy line, a membrane is dashed, a demon is dotted. A box
// in space is drawn in perspective: walls that act and partitions are translucent sheets, with the
// same lines along their edges. Draws no particles.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "panels/panel.h"
#include "panels/surfaces/perspective.h"

namespace carom {

/// Maps positions of the scene (y up) to pixels (y down).
struct BoxMap {
    Rect frame;  ///< of the box at its largest extent; in space from all viewpoints of the film
    Vec low = {};
    double scale = 1.0;                     ///< pixels per unit length; in space at its middle
    std::optional<Perspective> space = {};  ///< of a box in space, which has no pixel() and rect()

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
    /// `viewpoints`: those from which a box in space is seen, as Camera::viewpoints() has them.
    explicit SurfaceView(const PanelContext& context, std::vector<Viewpoint> viewpoints = {{}});

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
    /// plain box, nor in space.
    void draw_room(Canvas& canvas, const DrawContext& dc, const BoxMap& map,
                   const std::vector<SurfaceState>& states) const;
    void draw_obstacles(Canvas& canvas, const DrawContext& dc, const BoxMap& map,
                        const std::vector<SurfaceState>& states) const;
    void draw_partitions(Canvas& canvas, const DrawContext& dc, const BoxMap& map,
                         const std::vector<SurfaceState>& states) const;
    /// In space: the edges of the box and the walls that act, as far as they are behind the gas,
    /// and those in front of it.
    void draw_behind(Canvas& canvas, const DrawContext& dc, const BoxMap& map,
                     const std::vector<SurfaceState>& states) const;
    void draw_in_front(Canvas& canvas, const DrawContext& dc, const BoxMap& map,
                       const std::vector<SurfaceState>& states) const;

    /// In space: what stands among the particles.
    struct Sheet {  ///< a partition
        std::size_t surface;
        std::size_t axis;
        double at;
    };
    struct Body {
        std::size_t surface;
        const Obstacle* obstacle;
    };
    std::vector<Sheet> sheets(const std::vector<SurfaceState>& states) const;
    std::vector<Body> bodies() const;

    /// draw_sheet() draws the piece of a partition that lies in a part of the box.
    void draw_sheet(Canvas& canvas, const DrawContext& dc, const BoxMap& map,
                    const std::vector<SurfaceState>& states, const Sheet& sheet,
                    const Region& part) const;
    void draw_body(Canvas& canvas, const DrawContext& dc, const BoxMap& map,
                   const Body& body) const;

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
    Margins margins_in_space() const;
    bool is_deep() const;
    bool may_move(std::size_t k) const;
    double thickness_of(std::size_t side) const;

    const Gas& gas_;  ///< of the scene
    Language language_;
    bool plain_, still_ = true;
    bool names_axes_ = false;  ///< in space, where a panel or a surface refers to them
    std::vector<std::vector<Behaviour>> behaviours_;  ///< of each side and partition, at all times
    std::array<double, 2> temperatures_{};            ///< lowest and highest of baths
    Margins margins_{};
    Region extent_{};  ///< of the box at its largest extent
    std::vector<Viewpoint> viewpoints_;
};

}  // namespace carom
