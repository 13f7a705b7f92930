// The wire with its beads, and under it their world lines: where each bead was during the last
// while, time flowing down. The picture a film of one dimension is about.
#pragma once

#include <optional>
#include <vector>

#include "panels/gas/flashes.h"
#include "panels/gas/gas_colors.h"
#include "panels/gas/ghosts.h"
#include "panels/gas/velocity_arrows.h"
#include "panels/line/line_map.h"
#include "panels/line/world_lines.h"
#include "panels/panel.h"

namespace carom {

class WirePanel : public Panel {
  public:
    explicit WirePanel(const PanelContext& context)
        : context_(context),
          colors_(context),
          arrows_(context),
          ghosts_(context.scene),
          flashes_(context) {}

    void survey(const FrameInput& input) override;
    void fix_axes() override;
    void archive(Archive& archive) override;
    std::shared_ptr<const PanelState> state(const FrameInput& input) override;
    void draw_ground(Canvas& canvas, const DrawContext& dc) const override;
    void draw(Canvas& canvas, const DrawContext& dc, const PanelState& state) const override;
    Table table(const PanelState& state, const Theme& theme) const override;
    void draw_key(Canvas& canvas, const DrawContext& dc, const DrawContext& own) const override;
    bool wants_collisions() const override { return true; }
    bool surveys_collisions() const override { return flashes_.asked(); }

    /// For tests: the simulated time that the world lines show.
    double memory() const { return memory_; }

  private:
    struct View;
    struct Bends {
        double time;
        double count;  ///< of all world lines since the start
    };
    void survey_flashes(const FrameInput& input);
    double usual_rate() const;  ///< bends of one world line in a unit of time
    View view(const DrawContext& dc) const;
    bool is_ring() const;
    bool is_filled(Eigen::Index particle) const;
    Labels shown_labels() const;
    bool words_fit(const DrawContext& dc, Labels labels, const View& view) const;
    std::vector<Point> seen_at(double place, double radius, const View& view) const;
    double shown_radius(Eigen::Index particle, const View& view) const;
    bool is_rod(Eigen::Index particle, const View& view) const;
    double half_height(Eigen::Index particle, const View& view) const;
    void draw_lines(Canvas& canvas, const DrawContext& dc, const PanelState& state) const;
    void draw_line(Canvas& canvas, const DrawContext& dc, const PanelState& state, std::size_t line,
                   std::optional<Color> color, double width) const;
    void draw_band(Canvas& canvas, const DrawContext& dc, const PanelState& state,
                   std::size_t line) const;
    void draw_end(Canvas& canvas, const DrawContext& dc, double side) const;
    void draw_captions(Canvas& canvas, const DrawContext& dc) const;
    void draw_reversals(Canvas& canvas, const DrawContext& dc, const PanelState& state) const;
    void draw_ghosts(Canvas& canvas, const DrawContext& dc, const PanelState& state) const;
    void draw_beads(Canvas& canvas, const DrawContext& dc, const PanelState& state) const;
    void draw_flashes(Canvas& canvas, const DrawContext& dc, const PanelState& state) const;
    void draw_arrows(Canvas& canvas, const DrawContext& dc, const PanelState& state) const;
    void draw_name(Canvas& canvas, const DrawContext& dc, Eigen::Index particle, double place,
                   double alpha) const;
    void draw_words(Canvas& canvas, const DrawContext& dc, const PanelState& state) const;

    PanelContext context_;
    GasColors colors_;
    VelocityArrows arrows_;
    GhostKeeper ghosts_;
    Flashes flashes_;
    std::optional<WireMap> map_;  ///< from the first frame on
    std::vector<Bends> bends_;    ///< at each frame of the first pass
    double memory_ = 1.0;
    std::optional<WorldLines> lines_;  ///< after fix_axes()
    Eigen::ArrayXd surveyed_places_, last_places_;
};

}  // namespace carom
