// The collision of two beads on a wire in the plane of their velocities: an ellipse of constant
// energy, a line of constant momentum, and the two points where they cross, before and after. Or
// all collisions of the two as a walk on the ellipse.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "panels/collision/collision_map_key.h"
#include "panels/collision/pair_collision.h"
#include "panels/collision/pair_motion.h"
#include "panels/collision/velocity_plane.h"
#include "util/archive.h"

namespace carom {

class CollisionMapPanel : public Panel {
  public:
    CollisionMapPanel(const PanelContext& context, const PanelSpec& spec);

    void survey(const FrameInput& input) override;
    bool surveys_collisions() const override { return !spec_.given; }
    void fix_axes() override;
    void archive(Archive& archive) override {
        archive(met_, motion_, number_, walk_, factor_, reach_);
    }
    std::shared_ptr<const PanelState> state(const FrameInput& input) override;
    void draw_ground(Canvas& canvas, const DrawContext& dc) const override;
    void draw(Canvas& canvas, const DrawContext& dc, const PanelState& state) const override;
    Table table(const PanelState& state, const Theme& theme) const override;
    std::string account(const PanelState& state) const override;

    VelocityPlane plane(const DrawContext& dc) const;

  private:
    struct Counts;
    bool is_walk() const { return spec_.walk; }
    bool is_scaled() const { return spec_.scaled.value_or(is_walk()); }
    static std::size_t steps_of(const PanelState& state);  ///< of the walk, so far
    Counts counts_of(std::size_t steps) const;
    std::string subscripted(const char* letter, std::size_t k) const;
    std::string velocity_name(std::size_t k) const;
    std::string pair_title(const Theme& theme) const;
    std::vector<std::string> titles(const Theme& theme) const;  ///< the longest first
    std::vector<MapKeyEntry> key(std::size_t steps) const;
    MapPlaces places(const DrawContext& dc) const;
    VelocityPlane plane_in(const Rect& area) const;
    void draw_axes(Canvas& canvas, const DrawContext& dc, const VelocityPlane& to) const;
    void draw_energy(Canvas& canvas, const DrawContext& dc, const VelocityPlane& to) const;
    void draw_collision(Canvas& canvas, const DrawContext& dc, const VelocityPlane& to) const;
    void draw_walk(Canvas& canvas, const DrawContext& dc, const VelocityPlane& to,
                   std::size_t steps) const;
    std::vector<Eigen::Array2d> ellipse() const;

    PanelContext context_;
    PanelSpec spec_;
    PairCollisionWatch watch_;
    WalkWatch walk_watch_;
    std::optional<PairCollision> met_;  ///< of the run
    PairMotion motion_;
    std::array<std::int64_t, 2> number_{1, 2};  ///< what the two are called
    std::vector<WalkStep> walk_;
    Eigen::Array2d factor_{1.0, 1.0};
    Eigen::Array2d reach_{1.0, 1.0};  ///< largest velocities shown, times factor_
};

}  // namespace carom
