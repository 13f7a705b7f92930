// Arrows that show the velocities of disks and beads: one scale for the whole film, and its key.
// Independent of positions.
#pragma once

#include <array>
#include <vector>

#include "draw/arrow.h"
#include "panels/field/key_row.h"
#include "panels/panel.h"
#include "scene/film.h"

namespace carom {

/// The region for arrows: the box on the picture, pixels per unit length, and for each axis whether
/// it is periodic.
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
    bool shown() const { return context_.film().velocities; }

    /// First pass: survey() for every frame in order, then fix_scale(), which fixes the scale: the
    /// arrow of a fast particle has this `length` (in units of the scene), unless the scene gives
    /// its own scale.
    void survey(const FrameInput& input);
    void fix_scale(double length);

    /// For two runs that share a scale, as in GasColors.
    void add_survey(const VelocityArrows& other) {
        pool_.insert(pool_.end(), other.pool_.begin(), other.pool_.end());
    }
    void take_scale(const VelocityArrows& from) {
        fast_ = from.fast_;
        reach_ = from.reach_;
    }

    void archive(auto& archive) { archive(fast_, reach_); }

    /// Whether a particle has an arrow. If there are many particles, only some have one: evenly
    /// chosen, and the same in every frame.
    bool is_drawn(Eigen::Index particle) const { return particle % apart() == 0; }

    /// Draws the arrow of a velocity, which is given in the orientation of the picture, y down. The
    /// arrow begins at the centre, or at the rim if there are labels on the disks. `ground` is the
    /// colour behind; an arrow with `light` below 1 fades into it.
    void draw(Canvas& canvas, const DrawContext& dc, const ArrowField& field, Point center,
              double radius, Point velocity, Color ground, double light = 1.0) const;

    /// The area that may contain arrows: the box, and a little beyond it at walls.
    static Rect bounds(const DrawContext& dc, const ArrowField& field);

    /// Draws the key of the arrows at the bottom of an area and returns the rest of the area above.
    /// `scale`: pixels per unit length.
    Rect draw_key(Canvas& canvas, const DrawContext& dc, double scale) const;

    /// The same in one line.
    void add_key(KeyRow& row, double scale) const;

  private:
    Eigen::Index apart() const;
    ArrowStyle style(const DrawContext& dc, double scale, Color ground) const;

    PanelContext context_;
    std::vector<double> pool_;
    int surveyed_ = 0;
    double fast_ = 0.0;  ///< a speed
    /// The simulated time in which a particle moves by the length of its arrow; 0 if all rest.
    double reach_ = 0.0;
};

}  // namespace carom
