// The box and the disks in it, their trails, velocities and names: the picture a film of two
// dimensions is about.
#pragma once

#include <deque>
#include <vector>

#include "panels/gas/flashes.h"
#include "panels/gas/gas_colors.h"
#include "panels/gas/ghosts.h"
#include "panels/gas/velocity_arrows.h"
#include "panels/panel.h"

namespace carom {

class GasPanel : public Panel {
  public:
    explicit GasPanel(const PanelContext& context);

    void survey(const FrameInput& input) override;
    void fix_axes() override;
    void archive(Archive& archive) override;
    std::shared_ptr<const PanelState> state(const FrameInput& input) override;
    void draw_ground(Canvas& canvas, const DrawContext& dc) const override;
    void draw(Canvas& canvas, const DrawContext& dc, const PanelState& state) const override;
    Table table(const PanelState& state, const Theme& theme) const override;

    void draw_key(Canvas& canvas, const DrawContext& dc, const DrawContext& own) const override;

    /// A trail needs the collisions on the way.
    bool wants_collisions() const override { return !chosen_.empty(); }
    bool surveys_collisions() const override { return flashes_.asked(); }

    /// The box is as large as fits, at the area's left; in its middle where no panel stands right
    /// of it.
    Rect frame_in(const Rect& area) const override;

  private:
    struct Chosen {
        Eigen::Index particle;
        double trail_seconds;
    };
    struct TrailPoint {
        double film_time;  ///< seconds
        Point place;       ///< scene units
    };

    void choose_particles();
    void extend_trails(const FrameInput& input);
    bool stands_alone() const;
    bool is_filled(std::size_t particle) const;
    std::string label(std::size_t particle, const PanelState& state) const;
    void draw_ghosts(Canvas& canvas, const DrawContext& dc, const PanelState& state) const;
    void draw_disks(Canvas& canvas, const DrawContext& dc, const PanelState& state) const;
    void draw_infinite(Canvas& canvas, const DrawContext& dc, const PanelState& state) const;
    void draw_arrows(Canvas& canvas, const DrawContext& dc, const PanelState& state) const;
    void draw_labels(Canvas& canvas, const DrawContext& dc, const PanelState& state) const;
    void draw_trails(Canvas& canvas, const DrawContext& dc, const PanelState& state) const;
    void draw_chosen(Canvas& canvas, const DrawContext& dc, const PanelState& state) const;
    void draw_flashes(Canvas& canvas, const DrawContext& dc, const PanelState& state) const;
    void draw_remarks(Canvas& canvas, const DrawContext& dc) const;

    PanelContext context_;
    GasColors colors_;
    VelocityArrows arrows_;
    GhostKeeper ghosts_;
    Flashes flashes_;
    std::vector<Chosen> chosen_;
    std::vector<std::deque<TrailPoint>>
        trails_;                   ///< one for each chosen particle, as of the last state
    double moving_seconds_ = 0.0;  ///< film time without holds
    double last_time_ = 0.0;
};

}  // namespace carom
