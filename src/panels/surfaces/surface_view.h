// How the surfaces of a box look: sides that act, partitions, obstacles and gravity, and the room
// that they take around the box. Where sides move, the picture holds the box as large as it ever
// gets. What imposes its motion is hatched, what moves freely is a plain bar, a heat bath has a
// wavy line, a membrane is dashed, a demon dotted. Draws no particles.
#pragma once

#include <array>
#include <vector>

#include "panels/panel.h"

namespace carom {

/// From places of the scene, y up, to pixels, y down.
struct BoxMap {
    Rect frame;  ///< of the box, as large as it ever gets
    Eigen::Array2d low{0.0, 0.0};
    double scale = 1.0;  ///< pixels of a length

    Point pixel(const Point& place) const {
        return {frame.x + (place.x - low[0]) * scale, frame.bottom() - (place.y - low[1]) * scale};
    }
    Rect rect(const Region& region) const;
};

class SurfaceView {
  public:
    explicit SurfaceView(const PanelContext& context);

    /// Whether there is nothing to draw but walls.
    bool is_plain() const { return plain_; }

    /// Whether no side moves.
    bool is_still() const { return still_; }

    /// First pass, every frame in order.
    void survey(const FrameInput& input);
    void archive(auto& archive) { archive(extent_.low, extent_.high); }

    /// The box, as large as it ever gets; after the first pass.
    const Region& extent() const { return extent_; }

    /// Those of a frame that are drawn: of sides and partitions; none of a plain box.
    std::vector<SurfaceState> states(const FrameInput& input) const;

    /// The box in an area, as large as fits beside what stands around it, at the area's left or in
    /// its middle; and all of it.
    BoxMap map_in(const Rect& area, double unit, bool centered) const;
    Rect whole(const BoxMap& map, double unit) const;

    /// What is inside of the sides at a moment.
    Region room(const std::vector<SurfaceState>& states) const;

    /// Fills the room, and draws its outline and what stands in it; not for a plain box.
    void draw_room(Canvas& canvas, const DrawContext& dc, const BoxMap& map,
                   const std::vector<SurfaceState>& states) const;
    void draw_obstacles(Canvas& canvas, const DrawContext& dc, const BoxMap& map,
                        const std::vector<SurfaceState>& states) const;
    void draw_partitions(Canvas& canvas, const DrawContext& dc, const BoxMap& map,
                         const std::vector<SurfaceState>& states) const;
    /// What is outside of the room, and what is written on surfaces.
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
    bool may_move(std::size_t k) const;
    double thickness_of(std::size_t side) const;

    const Scene& scene_;
    bool plain_, still_ = true;
    std::vector<std::vector<Behaviour>> behaviours_;  ///< of each side and partition, at any time
    std::array<double, 2> temperatures_{};            ///< lowest and highest of baths
    Margins margins_{};
    Region extent_{};  ///< of the box, as large as it ever gets
};

}  // namespace carom
