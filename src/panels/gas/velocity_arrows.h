// Arrows that show the velocities of disks and beads: one scale for the whole film, and its key.
// Knows no places.
#pragma once

#include <array>
#include <vector>

#include "draw/arrow.h"
#include "panels/panel.h"

namespace carom {

/// Where arrows may be: the box on the picture, pixels of a length, and the axes along which what
/// leaves the box on one side comes in on the other.
struct ArrowField {
    Rect box;
    double scale = 1.0;
    std::array<bool, 2> joined{};
};

class VelocityArrows {
  public:
    static constexpr double key_height = 3.6;  ///< units

    explicit VelocityArrows(const PanelContext& context) : context_(context) {}

    /// Whether the scene asks for them.
    bool shown() const { return context_.scene.film.velocities; }

    /// First pass, every frame in order; then fix_scale() fixes the scale: a fast particle's arrow
    /// is of this length (as the scene measures it), unless the scene has a scale of its own.
    void survey(const FrameInput& input);
    void fix_scale(double length);

    /// As those of GasColors.
    void add_survey(const VelocityArrows& other) {
        pool_.insert(pool_.end(), other.pool_.begin(), other.pool_.end());
    }
    void take_scale(const VelocityArrows& from) {
        fast_ = from.fast_;
        reach_ = from.reach_;
    }

    void archive(auto& archive) { archive(fast_, reach_); }

    /// Whether a particle has an arrow: of many only some, evenly chosen, the same in every frame.
    bool is_drawn(Eigen::Index particle) const { return particle % apart() == 0; }

    /// Draws the arrow of a velocity, given as on the picture: y down. It begins at the centre, or
    /// at the rim where words stand on the disks. `ground` is the colour behind; an arrow of less
    /// `light` fades into it.
    void draw(Canvas& canvas, const DrawContext& dc, const ArrowField& field, Point center,
              double radius, Point velocity, Color ground, double light = 1.0) const;

    /// What may hold arrows: the box, and where it has walls a little more.
    static Rect bounds(const DrawContext& dc, const ArrowField& field);

    /// Draws what the arrows mean at the foot of an area, and returns what is left above; `scale`
    /// is pixels of a length.
    Rect draw_key(Canvas& canvas, const DrawContext& dc, double scale) const;

  private:
    Eigen::Index apart() const;
    ArrowStyle style(const DrawContext& dc, double scale, Color ground) const;

    PanelContext context_;
    std::vector<double> pool_;
    int surveyed_ = 0;
    double fast_ = 0.0;   ///< a speed
    double reach_ = 0.0;  ///< the simulated time in which a particle goes as far as its arrow is
                          ///< long; 0 if all are at rest
};

}  // namespace carom
